package argo.testkit

import javino.LineClock
import java.util.PriorityQueue
import java.util.concurrent.Semaphore
import java.util.concurrent.TimeUnit
import java.util.concurrent.locks.Condition
import java.util.concurrent.locks.Lock

/**
 * Virtual time. Virtual time advances only when all threads from [start] wait. Time then jumps to the end of the shortest wait. The threads
 * run one at a time in a fixed order. A test thus gives equal results on any machine.
 *
 * The test's thread drives this time. The driver calls [advance] or [advanceUntil], or waits for a lock or a condition of this time. There
 * may be only one driver at a time.
 */
internal class VirtualTime : LineClock {
    private val threads = ArrayList<VirtualThread>()
    private val timers = PriorityQueue<Timer>(compareBy({ it.atNanos }, { it.number }))
    private val returned = Semaphore(0)
    private var nowNanos = 0L
    private var timersSoFar = 0L

    /** Does a part of the agents' pending work on the driver's thread. Returns false if there was none. */
    var work: () -> Boolean = { false }

    var mas: TestMas? = null

    override fun nanos(): Long = nowNanos

    override fun await(condition: Condition, nanos: Long) {
        condition.awaitNanos(nanos)
    }

    override fun newLock(fair: Boolean): Lock = VirtualLock(this)

    override fun schedule(nanos: Long, action: Runnable) {
        later(nanos, action::run)
    }

    /** Starts a thread in this time. The thread runs when the driver resumes it. */
    fun start(name: String, run: () -> Unit): Thread = VirtualThread(name, run).also {
        threads += it
        it.isDaemon = true
        it.start()
    }

    /** Calls [action] on the driver's thread after [delayNanos]. [action] must not wait. Returns a function that cancels the call. */
    fun later(delayNanos: Long, action: () -> Unit): () -> Unit {
        val timer = Timer(nowNanos + maxOf(0, delayNanos), timersSoFar++, action)
        timers += timer
        return { timers -= timer }
    }

    fun advance(nanos: Long) = advanceUntil(nanos) { false }

    /**
     * Advances time until [reached] returns true, by at most [nanos]. Returns the last result of [reached]. Work that is due at the last
     * instant is still done.
     * @throws InterruptedException if the driver is interrupted, for example by a test's time limit
     */
    fun advanceUntil(nanos: Long, reached: () -> Boolean): Boolean = driving {
        val end = nowNanos + nanos
        while (true) {
            if (Thread.interrupted()) throw InterruptedException("the test was interrupted")
            val rests = settle()
            if (reached()) return@driving true
            if (nowNanos > end) return@driving false // an agent waited inside its cycle and advanced time further
            if (rests) nowNanos = nextInstant()?.takeIf { it <= end } ?: break
        }
        nowNanos = maxOf(nowNanos, end)
        false
    }

    /** Runs all threads until each waits for a later time. Returns false if time has advanced. */
    fun settle(): Boolean = driving {
        val instant = nowNanos
        var ran = true
        while (ran && nowNanos == instant) ran = runReady() || work()
        !ran
    }

    fun living(): List<String> = threads.filter { !it.over }.map { it.name }

    fun interruptAll() = threads.forEach { it.interrupt() }

    /** The running thread of this time, or null for the driver. */
    val running: Any? get() = Thread.currentThread().let { if (it is VirtualThread && it.time === this) it else null }

    /**
     * Waits until [ready] returns true, or until the time [deadlineNanos]. Null means no time limit. The waiting thread calls this
     * function.
     * @throws InterruptedException if the wait is [interruptible] and was interrupted
     */
    fun block(deadlineNanos: Long?, interruptible: Boolean, ready: () -> Boolean) {
        val thread = running as VirtualThread?
        if (thread != null) return thread.block(deadlineNanos, interruptible, ready)
        driving {
            while (!ready() && (deadlineNanos == null || nowNanos < deadlineNanos)) if (!runReady()) {
                val next = listOfNotNull(nextInstant(), deadlineNanos).minOrNull()
                    ?: error("the test waits for something that never comes: ${threads.filter { !it.over }.joinToString { it.name }}")
                nowNanos = maxOf(nowNanos, next)
            }
        }
    }

    private fun runReady(): Boolean {
        threads.removeAll { it.over }
        val thread = threads.firstOrNull { it.canRun() }
        if (thread != null) {
            threads -= thread // the other threads run first
            threads += thread
            resume(thread)
            return true
        }
        if ((timers.peek() ?: return false).atNanos > nowNanos) return false
        timers.remove().action()
        return true
    }

    private fun resume(thread: VirtualThread) {
        thread.go.release()
        if (!returns()) {
            val where = thread.stackTrace.joinToString("\n") { "\tat $it" }
            error("thread ${thread.name} waits for something that is not part of the test's time:\n$where")
        }
        thread.failure?.let { throw IllegalStateException("thread ${thread.name} ended with $it", it) }
    }

    /**
     * Returns true if the resumed thread waits or ends within [STUCK_S]. An interrupt does not end this wait, since the driver must not run
     * together with a thread.
     */
    private fun returns(): Boolean {
        val end = System.nanoTime() + TimeUnit.SECONDS.toNanos(STUCK_S)
        var wasInterrupted = false
        try {
            while (true) {
                try {
                    return returned.tryAcquire(end - System.nanoTime(), TimeUnit.NANOSECONDS)
                } catch (_: InterruptedException) {
                    wasInterrupted = true
                }
            }
        } finally {
            if (wasInterrupted) Thread.currentThread().interrupt()
        }
    }

    /** Returns the time of the next thread or timer, but at least the current time. Returns null if there is none. */
    private fun nextInstant(): Long? =
        (threads.mapNotNull { if (it.over) null else it.deadlineNanos } + listOfNotNull(timers.peek()?.atNanos))
            .minOrNull()?.let { maxOf(it, nowNanos) }

    /** Calls [work] in this time. Threads that it starts and records that it logs then belong to this time. */
    fun <T> driving(work: () -> T): T {
        val before = ACTIVE.get()
        ACTIVE.set(this)
        try {
            return work()
        } finally {
            ACTIVE.set(before)
        }
    }

    private class Timer(val atNanos: Long, val number: Long, val action: () -> Unit)

    /**
     * A thread that runs only when the driver resumes it. The thread resumes the driver when it waits or ends. An interrupt during the
     * driver's turn takes effect when the thread runs again.
     */
    private inner class VirtualThread(name: String, private val body: () -> Unit) : Thread(name) {
        val time get() = this@VirtualTime
        val go = Semaphore(0)
        var deadlineNanos: Long? = null
        private var ready: () -> Boolean = { true }
        private var interruptible = false

        @Volatile
        private var toBeInterrupted = false

        @Volatile
        var over = false

        @Volatile
        var failure: Throwable? = null

        fun canRun() = ready() || deadlineNanos.let { it != null && it <= nowNanos } || interruptible && toBeInterrupted

        override fun run() {
            awaitTurn()
            try {
                body()
            } catch (cause: Throwable) { // the driver throws an exception with this cause
                failure = cause
            } finally {
                over = true
                returned.release()
            }
        }

        fun block(deadlineNanos: Long?, interruptible: Boolean, ready: () -> Boolean) {
            if (interruptible && interrupted()) throw InterruptedException()
            this.deadlineNanos = deadlineNanos
            this.interruptible = interruptible
            this.ready = ready
            returned.release()
            awaitTurn()
            this.deadlineNanos = null
            if (interruptible && interrupted()) throw InterruptedException()
        }

        private fun awaitTurn() {
            go.acquireUninterruptibly()
            if (!toBeInterrupted) return
            toBeInterrupted = false
            super.interrupt()
        }

        override fun interrupt() {
            if (currentThread() === this) super.interrupt() else toBeInterrupted = true
        }

        override fun isInterrupted() = super.isInterrupted() || toBeInterrupted
    }

    companion object {
        private val ACTIVE = ThreadLocal<VirtualTime?>()

        /** Returns the virtual time in which the calling thread runs or which it drives, or null if there is none. */
        fun active(): VirtualTime? = (Thread.currentThread() as? VirtualThread)?.time ?: ACTIVE.get()

        /** The longest real time for which a resumed thread may run, in s. */
        private const val STUCK_S = 30L
    }
}
