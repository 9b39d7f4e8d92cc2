package argo.view

import java.util.concurrent.TimeUnit
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/** Passes an agent's newest state to its pages. A page that is slower than the agent misses states. Any thread may call the functions. */
internal class Broadcast {
    private val lock = ReentrantLock()
    private val changed = lock.newCondition()
    private var pages = 0
    private var hasNewPage = false
    private var newest = Published(0, "", isLast = false)

    val isWatched: Boolean get() = lock.withLock { pages > 0 }

    /** Returns true if a page has come since the last call. */
    fun takeNewPage(): Boolean = lock.withLock { hasNewPage.also { hasNewPage = false } }

    /** Replaces the newest state by [json]. If [isLast] is true, no state follows. */
    fun publish(json: String, isLast: Boolean) = lock.withLock {
        newest = Published(newest.number + 1, json, isLast)
        changed.signalAll()
    }

    /**
     * Serves a page on the calling thread. Calls [begin], then [send] with each new state up to the last one, then [end]. After
     * [HEARTBEAT_NANOS] ns without a state, calls [send] with null, which fails if the connection is closed. The page counts as open until
     * [end] has returned. The port must not be closed earlier.
     */
    fun serve(begin: () -> Unit, send: (String?) -> Unit, end: () -> Unit) {
        var number = lock.withLock {
            pages++
            hasNewPage = true
            newest.number // the page needs only later states
        }
        try {
            begin()
            do {
                val next = await(number)
                number = next?.number ?: number
                send(next?.json)
            } while (next?.isLast != true)
            end()
        } finally {
            lock.withLock {
                pages--
                changed.signalAll()
            }
        }
    }

    private fun await(after: Long): Published? = lock.withLock {
        var left = HEARTBEAT_NANOS
        while (newest.number <= after && left > 0) left = changed.awaitNanos(left)
        newest.takeIf { it.number > after }
    }

    /** Waits until no page is open, but at most [limitMs] ms. */
    fun awaitNoPage(limitMs: Long) = lock.withLock {
        var left = TimeUnit.MILLISECONDS.toNanos(limitMs)
        while (pages > 0 && left > 0) left = changed.awaitNanos(left)
    }

    private class Published(val number: Long, val json: String, val isLast: Boolean)

    private companion object {
        val HEARTBEAT_NANOS = TimeUnit.SECONDS.toNanos(2)
    }
}
