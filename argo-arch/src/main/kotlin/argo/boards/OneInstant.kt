package argo.boards

import argo.platform.Platform
import java.util.concurrent.TimeUnit

/**
 * Has what several boards sense at one instant perceived together. While the answer of another board is [near][ExpectedAnswer.isNear] a
 * snapshot that is ready waits for it, [MAX_NANOS] at most. Any thread may ask; [taken] belongs to the agent's.
 */
internal class OneInstant(private val platform: Platform) {
    @Volatile
    private var sinceNanos: Long? = null

    /** Whether the snapshots of [boards] that are ready wait for others of them. Called by the agent's thread it begins the wait. */
    fun isAwaited(boards: List<Board>, begins: Boolean = false): Boolean {
        if (boards.size < 2 || boards.none(Board::isReady) || boards.any(Board::isUrgent)) return false.also { if (begins) taken() }
        val now = platform.clock.nanos()
        val since = sinceNanos ?: now.also { if (begins) sinceNanos = it }
        return now - since < MAX_NANOS && boards.any { !it.isReady() && it.answer.isNear(now) }
    }

    /** The time in ms until the wait is over at the latest; null: nothing waits. */
    fun dueInMs(): Long? = sinceNanos?.let { maxOf(1, TimeUnit.NANOSECONDS.toMillis(it + MAX_NANOS - platform.clock.nanos())) }

    /** Snapshots were taken, or none is ready. */
    fun taken() {
        sinceNanos = null
    }

    companion object {
        /** The longest that a snapshot waits, in ns. */
        val MAX_NANOS = ExpectedAnswer.SOON_NANOS + ExpectedAnswer.LATE_NANOS
    }
}
