package argo.boards

import argo.perception.Snapshot
import argo.platform.Platform
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.TimeUnit
import java.util.concurrent.atomic.AtomicReference

/**
 * Decides which [ready][Board.isReady] snapshots of its [boards] an agent perceives now. A ready snapshot waits up to [MAX_NANOS] for
 * boards with a [near][ExpectedAnswer.isNear] answer. The agent then perceives the readings of one instant together. Only the agent's
 * thread may call [take].
 *
 * @param boards returns the boards that the agent perceives
 * @param wake wakes the agent until `seen` returns true; called when a snapshot has waited too long
 */
internal class SimultaneousSnapshots(
    private val platform: Platform,
    private val boards: () -> List<Board>,
    private val wake: (seen: () -> Boolean) -> Unit,
) {
    /** A wait for the answers of [boards]. Each answer removes its board from the wait. */
    private class Wait(val beganNanos: Long, boards: List<Board>) {
        private val awaited = ConcurrentHashMap.newKeySet<Board>(boards.size).apply { addAll(boards) }

        fun leave(board: Board) {
            awaited -= board
        }

        fun lasts(nowNanos: Long) = awaited.isNotEmpty() && nowNanos - beganNanos < MAX_NANOS
    }

    /** The current wait; null if no snapshot waits. */
    private val wait = AtomicReference<Wait?>()

    fun areThere(): Boolean = boards().let { boards -> boards.any(Board::isReady) && !areAwaiting(boards) }

    fun take(): List<Snapshot> {
        val boards = boards()
        if (areAwaiting(boards)) return emptyList()
        wait.set(null)
        return boards.mapNotNull(Board::take)
    }

    /** Notes that the answer of [board] can be perceived. */
    fun answered(board: Board) {
        wait.get()?.leave(board)
    }

    /** Returns true if the ready snapshot of [board] must wait for other boards. A timer wakes the agent after too long a wait. */
    fun isAwaiting(board: Board): Boolean = boards().let { it.size > 1 && !board.isUrgent() && lasts(it) }

    /** Returns true if the ready snapshots of [boards] wait for other boards' answers. The first true result begins the wait. */
    private fun areAwaiting(boards: List<Board>) =
        boards.size > 1 && boards.any(Board::isReady) && boards.none(Board::isUrgent) && lasts(boards)

    private fun lasts(boards: List<Board>): Boolean {
        val now = platform.clock.nanos()
        return (wait.get() ?: begin(boards, now))?.lasts(now) == true
    }

    /** Begins a wait and returns it; null if no answer is near. If an awaited answer does not come, a timer wakes the agent. */
    private fun begin(boards: List<Board>, nowNanos: Long): Wait? {
        val awaited = boards.filter { !it.isReady() && it.answer.isNear(nowNanos) }
        if (awaited.isEmpty()) return null
        val begun = Wait(nowNanos, awaited)
        if (!wait.compareAndSet(null, begun)) return wait.get()
        awaited.filter(Board::isReady).forEach(begun::leave) // these boards answered before other threads could see the wait
        platform.later(TimeUnit.NANOSECONDS.toMillis(MAX_NANOS)) { if (wait.get() === begun) wake { wait.get() !== begun } }
        return begun
    }

    companion object {
        /** The longest wait of a snapshot, in ns. */
        val MAX_NANOS = ExpectedAnswer.SOON_NANOS + ExpectedAnswer.LATE_NANOS
    }
}
