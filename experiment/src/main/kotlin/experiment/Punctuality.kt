package experiment

import java.util.concurrent.ConcurrentLinkedQueue
import java.util.concurrent.locks.LockSupport
import kotlin.concurrent.thread

/**
 * Checks if this machine keeps up with real time in its simulation. A thread asks to be woken every [STEP_NANOS] ns, and measures its
 * delay. Boards and agents suffer the same delays.
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

    /** Returns the longest delay of this machine in ms since [start], a [System.nanoTime]. Returns 0 if none reached 1 ms. */
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

/** The greatest number of tries for a run, if the machine was late. */
internal const val MAX_TRIES = 3

/**
 * Returns the longest allowed delay of this machine in a run of [condition], in ms. The limit is a third of the time of a request and an
 * answer with twelve sensors at 9600 baud.
 */
internal fun maxLateMs(condition: Condition): Double = exchangeNanos(Trial(condition, View.NONE, 0, 0, 1)) / 3e6

internal val Finished.isLate: Boolean get() = result.lateMs > maxLateMs(trial.condition)

/**
 * Calls [make] until this machine was punctual in a run, at most [MAX_TRIES] times. Returns the last run, or null as soon as [make] returns
 * null.
 *
 * @param repeated called before each repetition
 */
internal fun <R : Any> punctual(isLate: (R) -> Boolean, repeated: () -> Unit, make: () -> R?): R? {
    repeat(MAX_TRIES - 1) {
        val run = make() ?: return null
        if (!isLate(run)) return run
        repeated()
    }
    return make()
}
