package argo.platform

import kotlin.concurrent.withLock

/** Does pieces of work one after the other, in their order, on a thread that ends when no work is left. */
internal class SequentialExecutor(private val platform: Platform, private val name: String) {
    private val lock = platform.clock.newLock(false)
    private val waiting = ArrayDeque<() -> Unit>()
    private var working = false

    /**
     * Does [work] after all earlier work. An exception of [work] goes to the thread's uncaught exception handler. Later work is still done.
     */
    fun execute(work: () -> Unit) = lock.withLock {
        waiting.addLast(work)
        startUnlessWorking()
    }

    /** Forgets work that has not begun. */
    fun clear() = lock.withLock { waiting.clear() }

    private fun startUnlessWorking() {
        if (working) return
        platform.start(name, ::doAll) // doAll waits for the lock; if no thread can be started, the next work tries again
        working = true
    }

    private fun doAll() {
        var ended = false
        try {
            while (true) (next() ?: break)()
            ended = true
        } finally {
            if (!ended) lock.withLock {
                working = false
                if (waiting.isNotEmpty()) startUnlessWorking()
            }
        }
    }

    private fun next(): (() -> Unit)? = lock.withLock { waiting.removeFirstOrNull().also { working = it != null } }
}
