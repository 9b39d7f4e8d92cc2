package experiment

import java.util.concurrent.ConcurrentLinkedQueue
import java.util.concurrent.locks.LockSupport
import kotlin.concurrent.thread

/**
 * Watches whether this machine keeps up with the time of its simulation. A thread asks to be woken every [STEP_NANOS] ns and notes how late
 * it was woken. The same causes delay boards and agents.
 */
internal class Punctuality : AutoCloseable {
    private class Delay(val at: Long, val nanos: Long)

    private val delays = ConcurrentLinkedQueue<Delay>()
    private val watcher = thread(name = "punctuality", isDaemon = true) {
        var due = System.nanoTime() + STEP_NANOS
        while (!Thread.currentThread().isInterrupted) {
            val wait = due - System.nanoTime()
            if (wait > 0) {
                LockSupport.parkNanos(wait)
                continue
            }
            if (-wait > MIN_NANOS) delays.add(Delay(due, -wait))
            due = System.nanoTime() + STEP_NANOS
        }
    }

    /** Returns the largest lateness of this machine since [start], a [System.nanoTime], in ms; 0 if it was less than 1 ms. */
    fun worstSinceMs(start: Long): Double = delays.filter { it.at + it.nanos - start >= 0 }.maxOfOrNull { it.nanos / 1e6 } ?: 0.0

    override fun close() {
        watcher.interrupt()
        watcher.join()
    }

    private companion object {
        const val STEP_NANOS = 5_000_000L
        const val MIN_NANOS = 1_000_000L
    }
}
