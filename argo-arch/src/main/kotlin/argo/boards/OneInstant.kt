package argo.boards

import argo.platform.Platform
import java.util.concurrent.TimeUnit

/**
 * Has what several boards sense at one instant perceived together. While the answer of another board is [near][ExpectedAnswer.isNear] a
 * snapshot that is ready waits for it, [MAX_NANOS] at most. Any thread may ask; [taken] belongs to the agent's.
 *
 * @param wake wakes the agent until its argument holds; called once a wait has lasted so long
 */
internal class OneInstant(private val platform: Platform, private val wake: (seen: () -> Boolean) -> Unit) {
    private class Wait {
        /** When it began; null: nothing waits yet. */
        @Volatile
        var sinceNanos: Long? = null
    }

    @Volatile
    private var wait = Wait()

    /** Whether the snapshots of [boards] that are ready wait for others of them. Who finds it first begins the wait. */
    fun isAwaited(boards: List<Board>): Boolean {
        val wait = wait // before the boards are asked: if snapshots are taken meanwhile no later wait has begun
        if (boards.size < 2 || boards.none(Board::isReady) || boards.any(Board::isUrgent)) return false
        val now = platform.clock.nanos()
        if (boards.none { !it.isReady() && it.answer.isNear(now) }) return false
        val since = wait.sinceNanos ?: now.also { begin(wait, it) }
        return now - since < MAX_NANOS
    }

    /** Answers wake the agent, but for one that does not come. */
    private fun begin(wait: Wait, nowNanos: Long) {
        wait.sinceNanos = nowNanos
        platform.later(TimeUnit.NANOSECONDS.toMillis(MAX_NANOS)) { if (this.wait === wait) wake { this.wait !== wait } }
    }

    /** Snapshots were taken, or none is ready. */
    fun taken() {
        wait = Wait()
    }

    companion object {
        /** The longest that a snapshot waits, in ns. */
        val MAX_NANOS = ExpectedAnswer.SOON_NANOS + ExpectedAnswer.LATE_NANOS
    }
}
