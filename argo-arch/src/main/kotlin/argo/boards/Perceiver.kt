package argo.boards

import argo.acting.CommandOptions
import argo.acting.Transmission
import argo.connecting.OpenPort
import argo.connecting.PortStatus
import argo.filters.CriticalRule
import argo.filters.PerceptionFilter
import argo.observing.Observers
import argo.perception.HandOver
import argo.platform.Platform
import argo.platform.RateLimitedWarning
import argo.platform.nowMs
import javino.PortException
import java.util.logging.Logger

/** The interface of an agent for the boards that it perceives. Any thread may call. */
internal interface Perceiver {
    /** The agent's name. */
    val owner: String
    val platform: Platform
    val log: Logger

    /** The most percepts of a board that it believes at once. */
    val maxPercepts: Int

    /** The sensing interval in ms of boards without one of their own. */
    val intervalMs: Int

    /** The filter of boards without one of their own; null: everything is kept. */
    val filter: PerceptionFilter?

    /** True if boards watch critical rules themselves as far as they can. */
    val leavesRulesToBoards: Boolean

    /** Returns the agent's observers. */
    fun observers(): Observers

    /** True if it perceives more than one board. */
    val perceivesSeveral: Boolean

    /** Returns true if it perceives [board] now. */
    fun perceives(board: Board): Boolean

    /** Returns the board on [port], if the agent perceives it now. */
    fun boardOn(port: OpenPort): Board?

    /** Returns true if the board on [port], an [OpenPort], answers: it is on and not stale. */
    fun answers(port: Any): Boolean

    /** Returns true if the board on [port] watches [rule] itself. */
    fun isWatchedBy(port: OpenPort, rule: CriticalRule): Boolean

    /** Returns the hand-over of [board]'s snapshots to the agent. */
    fun handOverOf(board: Board): HandOver

    /** Sends [text] on [port]; no snapshot waits for it. Any thread. The caller is to [follow][Transmission.follow] it. */
    fun send(port: OpenPort, text: String, options: CommandOptions): Transmission

    /** Wakes the agent until [seen] is true; other threads call [seen]. */
    fun wake(seen: () -> Boolean)

    /** Notes that the answer of [board] has come, and can be perceived. */
    fun answered(board: Board)

    /**
     * Returns true if the ready snapshot of [board] waits for those of other boards. The agent is woken if that lasts too long.
     */
    fun isForLater(board: Board): Boolean

    /** Reports a new state of [port]. */
    fun report(port: OpenPort, status: PortStatus, reason: String? = null)

    /** Reports that the device of [port] has gone. */
    fun lost(port: OpenPort, trouble: PortException)
}

/** Makes a warning in the agent's log that is not repeated while its cause lasts. */
internal fun Perceiver.rateLimitedWarning() = RateLimitedWarning(platform.nowMs) { log.warning(it) }
