package argo.boards

import argo.perception.Snapshot
import argo.platform.Platform
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.TimeUnit
import java.util.concurrent.atomic.AtomicReference

/**
 * Decides which snapshots of its [boards] an agent perceives now: those that the hand-over of their board has [ready][Board.isReady]. They
 * wait for boards whose answer is [near][ExpectedAnswer.isNear], [MAX_NANOS] at most, so that readings of several boards at one instant are
 * perceived together. [take] belongs to the agent's thread; any thread may ask.
 *
 * @param boards returns the boards that the agent perceives
 * @param wake wakes the agent until its argument holds; called when a wait has lasted too long
 */
internal class ReadySnapshots(
    private val platform: Platform,
    private val boards: () -> List<Board>,
    private val wake: (seen: () -> Boolean) -> Unit,
) {
    /** A wait for the answers of [boards]. Each answer removes its board, so that an answer is not compared with all others. */
    private class Wait(val beganNanos: Long, boards: List<Board>) {
        private val awaited = ConcurrentHashMap.newKeySet<Board>(boards.size).apply { addAll(boards) }

        fun leave(board: Board) {
            awaited -= board
        }

        fun lasts(nowNanos: Long) = awaited.isNotEmpty() && nowNanos - beganNanos < MAX_NANOS
    }

    /** Null: no snapshot waits. */
    private val wait = AtomicReference<Wait?>()

    /** Returns true if [take] would return a snapshot. */
    fun areThere(): Boolean = boards().let { boards -> boards.any(Board::isReady) && !areAwaiting(boards) }

    /** Takes the snapshots to perceive now. */
    fun take(): List<Snapshot> {
        val boards = boards()
        if (areAwaiting(boards)) return emptyList()
        wait.set(null)
        return boards.mapNotNull(Board::take)
    }

    /** Notes that the answer of [board] has come, and can be perceived. */
    fun answered(board: Board) {
        wait.get()?.leave(board)
    }

    /**
     * Returns true if the snapshot of [board], which has just become ready, waits for those of other boards. The agent is woken if that
     * lasts too long.
     */
    fun isAwaiting(board: Board): Boolean = boards().let { it.size > 1 && !board.isUrgent() && lasts(it) }

    /** Returns true if the ready snapshots of [boards] wait for other boards' answers. The first call with that result begins the wait. */
    private fun areAwaiting(boards: List<Board>) =
        boards.size > 1 && boards.any(Board::isReady) && boards.none(Board::isUrgent) && lasts(boards)

    private fun lasts(boards: List<Board>): Boolean {
        val now = platform.clock.nanos()
        return (wait.get() ?: begin(boards, now))?.lasts(now) == true
    }

    /** Begins a wait; null: no board is awaited. A timer wakes the agent if an answer stays out. */
    private fun begin(boards: List<Board>, nowNanos: Long): Wait? {
        val awaited = boards.filter { !it.isReady() && it.answer.isNear(nowNanos) }
        if (awaited.isEmpty()) return null
        val begun = Wait(nowNanos, awaited)
        if (!wait.compareAndSet(null, begun)) return wait.get()
        awaited.filter(Board::isReady).forEach(begun::leave) // their answers came before the wait was visible
        platform.later(TimeUnit.NANOSECONDS.toMillis(MAX_NANOS)) { if (wait.get() === begun) wake { wait.get() !== begun } }
        return begun
    }

    companion object {
        /** The longest that a snapshot waits, in ns. */
        val MAX_NANOS = ExpectedAnswer.SOON_NANOS + ExpectedAnswer.LATE_NANOS
    }
}
