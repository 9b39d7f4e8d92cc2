package argo.observing

import argo.filters.CriticalRule
import argo.filters.PerceptionFilter
import jason.asSemantics.Circumstance
import jason.asSemantics.TransitionSystem
import jason.bb.BeliefBase
import javino.PerceptKind
import javino.link.SendOptions
import javino.wire.BoardAction
import java.nio.file.Path
import java.util.logging.Logger

/** The interface of an agent for its observers. Any thread may use it unless a member says otherwise. */
interface ObservedAgent {
    /** The agent's name in the multi-agent system. */
    val name: String

    /** The policy by which the agent gets snapshots of its sensors: `fresh`, `every` or `in_cycle`. */
    val policy: String

    /** The sensing interval in ms of boards without an interval of their own. */
    val intervalMs: Int

    /**
     * The time in ms between the oldest and the newest reading of the boards that the agent believes; null: there is none. See `argo.skew`.
     */
    val skewMs: Long?

    /** True if the agent perceives its boards. */
    val isPerceiving: Boolean

    /** The actions that the perceived boards have registered; null: none of these boards has described itself. */
    val actions: List<BoardAction>?

    /** The agent's belief base. For the agent's thread only: see [AgentObserver.cycleFinished]. */
    val beliefs: BeliefBase

    /** The agent's intentions and events. For the agent's thread only, like [beliefs]. */
    val circumstance: Circumstance

    /** The agent's transition system in Jason, with its program and options. For the agent's thread only, like [beliefs]. */
    val reasoning: TransitionSystem

    /** The log to which the agent's plans print with `.print`. Jason's reports about the agent go there too. */
    val printed: Logger

    /** Pauses the agent, and lets it go on. */
    val pausing: Pausing

    /** The computers of the agent's system; empty: the system runs on one computer. */
    val computers: List<ObservedComputer> get() = emptyList()

    /** Returns the time of the agent's clock in ns. The clock never goes back. */
    fun nanos(): Long

    /** Returns the ports that the agent has asked for. */
    fun ports(): List<ObservedPort>

    /**
     * Returns the kinds of percepts that the board on a port describes; empty: it describes none, or they are not known yet. From the first
     * call on, the board is asked for its kinds once in each session, between two requests.
     *
     * @param portName the name with which the port was opened
     */
    fun perceptKinds(portName: String): List<PerceptKind>

    /**
     * Returns the names of the filters that the agent can choose.
     * @throws java.util.ServiceConfigurationError if a filter provider cannot be used
     */
    fun filterNames(): List<String>

    /** Returns the filter called [name]; null: [name] is `none`, for no filter. Throws like [argo.filters.format.FilterFinder.find]. */
    fun filter(name: String): PerceptionFilter?

    /** Explains why the filter keeps or drops [percept], in words; for each board, if boards differ. */
    fun explain(percept: String): String

    /** Returns the critical rules of the active filter, in its order, each with the side that watches it. */
    fun criticalRules(): List<WatchedRule>

    /**
     * Makes the agent perceive through [filter] in its next cycle, or at once if the agent is paused; null: through none. The agent's
     * thread calls [done] afterwards.
     */
    fun perceiveThrough(filter: PerceptionFilter?, done: () -> Unit)

    /**
     * Makes the agent start or stop perceiving in its next cycle, or at once if the agent is paused. The agent's thread calls [done]
     * afterwards.
     */
    fun perceive(open: Boolean, done: () -> Unit)

    /**
     * Sends [command], a literal or a string in quotes, like `argo.act(command)` in a plan: in the next cycle, or at once if the agent
     * stands. The thread that learns the outcome calls [done] once: with null, or with the reason why the command was not carried out.
     */
    fun act(command: String, done: (CommandFailure?) -> Unit) = act(command, SendOptions.defaults(), done)

    /** Like the other [act], with the [options] of `argo.act`. */
    fun act(command: String, options: SendOptions, done: (CommandFailure?) -> Unit)

    /**
     * Makes the agent carry [order] out at the beginning of its next cycle. The agent's thread calls [done] once afterwards, with the
     * outcome.
     */
    fun order(order: Order, done: (Outcome) -> Unit)

    /**
     * Reads the agent's program and its active filters anew, on the calling thread, and lets the agent exchange the changed parts, like
     * `argo.reload`. Calls [done] once at the end: on the calling thread if anything cannot be read, else on the agent's thread.
     */
    fun reload(done: (Outcome) -> Unit)

    /** Returns the files that [reload] reads: the program, the files that it includes, and filters; empty: none is on a disk. */
    fun sources(): List<Path>

    /** Makes the agent run a reasoning cycle soon. */
    fun wake()

    /** Makes the agent run a reasoning cycle soon, and further ones at growing intervals until [seen] returns true. */
    fun wakeUntil(seen: () -> Boolean)
}

/** A critical rule of an agent's filter, with the side that watches it now. */
data class WatchedRule(val rule: CriticalRule, val watcher: RuleWatcher)

/**
 * A port that an agent has asked for.
 *
 * @property name the agent's term for the port, as a literal: `ttyACM0`, or a string in its quotes
 * @property status `on`, `off` or `timeout`
 * @property isInUse whether this is the port in use, which gets each command for which no other board is found
 * @property isStale whether the agent believes `stale(P)` about the port
 * @property isPerceived whether the agent perceives the board on the port
 * @property namespace the namespace of its board's percepts; null: the default namespace
 * @property intervalMs the sensing interval in ms of its board; null: the board is not perceived
 * @property filter the name of the board's filter; null: the board has none, or is not perceived
 */
data class ObservedPort(
    val name: String,
    val status: String,
    val isInUse: Boolean,
    val isStale: Boolean,
    val isPerceived: Boolean = isInUse,
    val namespace: String? = null,
    val intervalMs: Int? = null,
    val filter: String? = null,
)
