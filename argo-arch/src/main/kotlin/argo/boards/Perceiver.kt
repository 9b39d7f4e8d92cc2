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

/** The agent that perceives boards, as they see it. Any thread may call. */
internal interface Perceiver {
    /** The agent's name. */
    val owner: String
    val platform: Platform
    val log: Logger

    /** How many percepts of a board it believes at once. */
    val maxPercepts: Int

    /** The sensing interval in ms of boards without one of their own. */
    val intervalMs: Int

    /** The filter of boards without one of their own; null: everything is kept. */
    val filter: PerceptionFilter?

    /** Whether boards watch critical rules themselves as far as they can. */
    val leavesRulesToBoards: Boolean

    /** Those who follow what happens to the agent. */
    fun observers(): Observers

    /** Whether it perceives more than one board. */
    val perceivesSeveral: Boolean

    /** Whether it perceives [board] now. */
    fun perceives(board: Board): Boolean

    /** The board on [port], if the agent perceives it now. */
    fun boardOn(port: OpenPort): Board?

    /** Whether the board on [port], an [OpenPort], answers: it is on and not stale. */
    fun answers(port: Any): Boolean

    /** Whether the board on [port] watches [rule] itself. */
    fun isWatchedBy(port: OpenPort, rule: CriticalRule): Boolean

    /** Where the snapshots of [board] are left for the agent. */
    fun handOverOf(board: Board): HandOver

    /** Sends [text] on [port]; no snapshot waits for it. Any thread. The caller is to [follow][Transmission.follow] it. */
    fun send(port: OpenPort, text: String, options: CommandOptions): Transmission

    /** Wakes the agent until [seen], which other threads ask. */
    fun wake(seen: () -> Boolean)

    /** The answer of [board] has come, and can be perceived. */
    fun answered(board: Board)

    /** Whether the snapshot of [board], which is ready, waits for those of other boards. The agent is woken when that has lasted too long. */
    fun isForLater(board: Board): Boolean

    /** [port] has changed its state. */
    fun report(port: OpenPort, status: PortStatus, reason: String? = null)

    /** The device of [port] has gone. */
    fun lost(port: OpenPort, trouble: PortException)
}

/** A warning in the agent's log that is not repeated while its cause lasts. */
internal fun Perceiver.rateLimitedWarning() = RateLimitedWarning(platform.nowMs) { log.warning(it) }
