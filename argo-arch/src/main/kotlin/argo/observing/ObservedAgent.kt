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

/** An agent, as its observers see it. Any thread may use a member if its comment names no thread. */
interface ObservedAgent {
    /** The agent's name in the multi-agent system. */
    val name: String

    /** The policy that decides when the agent gets snapshots of its sensors: `fresh`, `every` or `in_cycle`. */
    val policy: String

    /** The sensing interval in ms of all boards that have no interval of their own. */
    val intervalMs: Int

    /** The ms between the oldest and the newest reading that the agent believes now; null if it believes none. See `argo.skew`. */
    val skewMs: Long?

    /** True if the agent perceives its boards. */
    val isPerceiving: Boolean

    /** The actions that the perceived boards have registered; null if none of these boards has described itself. */
    val actions: List<BoardAction>?

    /** The agent's belief base. Only for the agent's thread, see [AgentObserver.cycleFinished]. */
    val beliefs: BeliefBase

    /** The agent's intentions and events. Only for the agent's thread. */
    val circumstance: Circumstance

    /** The agent's transition system in Jason, with its program and options. Only for the agent's thread. */
    val reasoning: TransitionSystem

    /** The log to which the agent's plans print with `.print`. Jason's reports about the agent also go to this log. */
    val printed: Logger

    /** Pauses the agent, and lets it continue. */
    val pausing: Pausing

    /** The computers of the agent's system; empty if the system runs on one computer. */
    val computers: List<ObservedComputer> get() = emptyList()

    /** Returns the time of the agent's clock in ns. The clock never goes back. */
    fun nanos(): Long

    /** Returns the ports that the agent has asked for. */
    fun ports(): List<ObservedPort>

    /**
     * Returns the kinds of percepts that the board on a port describes. The list is empty if it describes none, or if its kinds are not
     * known yet. After the first call, ARGO asks the board once in each session, between two requests for percepts.
     *
     * @param portName the name with which the port was opened
     */
    fun perceptKinds(portName: String): List<PerceptKind>

    /**
     * Returns the names of the filters that the agent can choose.
     *
     * @throws java.util.ServiceConfigurationError if a filter provider cannot be used
     */
    fun filterNames(): List<String>

    /** Returns the filter called [name]. Returns null for the name `none`. Throws like [argo.filters.format.FilterFinder.find]. */
    fun filter(name: String): PerceptionFilter?

    /** Explains in words why the filter keeps or drops [percept]. If the explanations for boards differ, returns one for each board. */
    fun explain(percept: String): String

    /** Returns the critical rules of the active filter, in the filter's order. Each has its watcher, the computer or the board. */
    fun criticalRules(): List<WatchedRule>

    /**
     * Makes the agent perceive through [filter] from its next cycle on, or at once if it is paused. If [filter] is null, the agent
     * perceives without a filter. The agent's thread calls [done] afterwards.
     */
    fun perceiveThrough(filter: PerceptionFilter?, done: () -> Unit)

    /**
     * Makes the agent start or stop perceiving in its next cycle, or at once if it is paused. The agent's thread calls [done] afterwards.
     */
    fun perceive(open: Boolean, done: () -> Unit)

    /**
     * Sends [command], a literal or a string in quotes, like `argo.act(command)` in a plan. Sends it in the next cycle, or at once if the
     * agent is paused. [done] is called once, on any thread, with null or with the reason why the command was not carried out.
     */
    fun act(command: String, done: (CommandFailure?) -> Unit) = act(command, SendOptions.defaults(), done)

    /** Like the other [act], with the [options] of `argo.act`. */
    fun act(command: String, options: SendOptions, done: (CommandFailure?) -> Unit)

    /**
     * Makes the agent carry out [order] at the beginning of its next cycle. The agent's thread calls [done] once afterwards, with the
     * outcome.
     */
    fun order(order: Order, done: (Outcome) -> Unit)

    /**
     * Reads the agent's program and its active filters again, on the calling thread. The agent then exchanges the changed parts, as after
     * `argo.reload`. [done] is called once at the end. If anything cannot be read, the calling thread calls it, else the agent's thread.
     */
    fun reload(done: (Outcome) -> Unit)

    /** Returns the files on disk that [reload] reads: the program, the files that the program includes, and filters. */
    fun sources(): List<Path>

    /** Makes the agent run a reasoning cycle soon. */
    fun wake()

    /** Makes the agent run a reasoning cycle soon, and further cycles at growing intervals until [seen] returns true. */
    fun wakeUntil(seen: () -> Boolean)
}

/** A critical rule of an agent's filter. [watcher] tells whether the board or the computer watches it now. */
data class WatchedRule(val rule: CriticalRule, val watcher: RuleWatcher)

/**
 * A port that an agent has asked for.
 *
 * @property name the agent's term for the port, as a literal: `ttyACM0`, or a string in its quotes
 * @property status `on`, `off` or `timeout`
 * @property isInUse whether this is the port in use, which gets each command for which no other board is found
 * @property isStale whether the agent believes `stale(P)` about the port
 * @property isPerceived whether the agent perceives the board on the port
 * @property namespace the namespace of the percepts from the port's board; null for the default namespace
 * @property intervalMs the sensing interval in ms of the port's board; null if the board is not perceived
 * @property filter the name of the board's filter; null if the board has none, or is not perceived
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
