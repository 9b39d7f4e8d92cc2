package experiment

import java.util.concurrent.ConcurrentLinkedQueue
import java.util.concurrent.locks.LockSupport
import kotlin.concurrent.thread

/**
 * Watches whether this machine keeps up with real time in its simulation. A thread asks to be woken every [STEP_NANOS] ns, and notes how
 * late it was woken. Boards and agents are delayed by the same causes.
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

    /** Returns the longest delay of this machine since [start], a [System.nanoTime], in ms; 0 if no delay was as long as 1 ms. */
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

/** A run may be made so many times, if the machine was late in the earlier tries. */
internal const val MAX_TRIES = 3

/**
 * Returns how late this machine may be in a run of [condition], in ms. The limit is a third of the time that a request and the answer with
 * twelve sensors take at 9600 baud.
 */
internal fun maxLateMs(condition: Condition): Double = exchangeNanos(Trial(condition, View.NONE, 0, 0, 1)) / 3e6

/** Whether this machine was later than the condition of the run allows. */
internal val Finished.isLate: Boolean get() = result.lateMs > maxLateMs(trial.condition)

/**
 * Calls [make] until this machine was not too late in a run, but at most [MAX_TRIES] times. Returns the last run; null as soon as [make]
 * returns null.
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
