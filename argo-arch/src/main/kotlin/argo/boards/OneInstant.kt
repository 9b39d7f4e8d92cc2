package argo.boards

import argo.platform.Platform
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.TimeUnit
import java.util.concurrent.atomic.AtomicReference

/**
 * Delays a ready snapshot for boards whose answer is [near][ExpectedAnswer.isNear], [MAX_NANOS] at most, so that readings of several boards
 * at one instant are perceived together. Any thread may ask; [taken] belongs to the agent's.
 *
 * @param wake wakes the agent until its argument holds; called once a wait has lasted too long
 */
internal class OneInstant(private val platform: Platform, private val wake: (seen: () -> Boolean) -> Unit) {
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

    /** Returns true if the ready snapshots of [boards] wait for others of them. The first call with that result begins the wait. */
    fun isAwaited(boards: List<Board>): Boolean =
        boards.size > 1 && boards.any(Board::isReady) && boards.none(Board::isUrgent) && lasts(boards)

    /** Notes that the answer of [board] has come, and can be perceived. */
    fun answered(board: Board) {
        wait.get()?.leave(board)
    }

    /** Returns true if the snapshot of [board], one of [boards], which has just become ready, waits for others of them. */
    fun isAwaited(board: Board, boards: List<Board>): Boolean = boards.size > 1 && !board.isUrgent() && lasts(boards)

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
        awaited.filter(Board::isReady).forEach(begun::leave) // answers that came before the wait was visible
        platform.later(TimeUnit.NANOSECONDS.toMillis(MAX_NANOS)) { if (wait.get() === begun) wake { wait.get() !== begun } }
        return begun
    }

    /** Ends the wait: snapshots were taken, or none is ready. */
    fun taken() = wait.set(null)

    companion object {
        /** The longest that a snapshot waits, in ns. */
        val MAX_NANOS = ExpectedAnswer.SOON_NANOS + ExpectedAnswer.LATE_NANOS
    }
}
