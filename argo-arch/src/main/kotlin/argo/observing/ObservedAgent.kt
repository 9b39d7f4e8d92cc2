package argo.observing

import argo.filters.CriticalRule
import argo.filters.PerceptionFilter
import jason.asSemantics.Circumstance
import jason.asSemantics.TransitionSystem
import jason.bb.BeliefBase
import javino.PerceptKind
import javino.link.SendOptions
import javino.wire.BoardAction
import java.util.logging.Logger

/** The interface of an agent for its observers. Any thread may use it unless a member says otherwise. */
interface ObservedAgent {
    /** The agent's name in the multi-agent system. */
    val name: String

    /** The policy by which the agent gets snapshots of its sensors: `fresh`, `every` or `in_cycle`. */
    val policy: String

    /** The sensing interval in ms of boards that have no interval of their own. */
    val intervalMs: Int

    /** The time in ms between the oldest and the newest reading that it believes of its boards; null: there is none. See `argo.skew`. */
    val skewMs: Long?

    /** True if it perceives its boards. */
    val isPerceiving: Boolean

    /** The actions that its boards have registered; null: no board that it perceives has described itself. */
    val actions: List<BoardAction>?

    /** The agent's belief base. For the agent's thread only: see [AgentObserver.cycleFinished]. */
    val beliefs: BeliefBase

    /** The agent's intentions and events. For the agent's thread only, as [beliefs]. */
    val circumstance: Circumstance

    /** The agent's transition system in Jason, with its program and options. For the agent's thread only, as [beliefs]. */
    val reasoning: TransitionSystem

    /** The log to which the agent's plans print with `.print`. Jason's reports about the agent go there too. */
    val printed: Logger

    /** Returns the time of the clock that times its messages, in ns. It never goes back. */
    fun nanos(): Long

    /** Returns the ports that it has asked for. */
    fun ports(): List<ObservedPort>

    /**
     * Returns the kinds of percepts that the board on a port describes. From the first call on the board is asked for them, once in each
     * session and between two requests; none: it describes none, or they are not known yet.
     *
     * @param portName the name with which the port was opened, as [PerceivedMessage.portName]
     */
    fun perceptKinds(portName: String): List<PerceptKind>

    /**
     * Returns the names of the filters to which it could change.
     *
     * @throws java.util.ServiceConfigurationError if a filter provider cannot be used
     */
    fun filterNames(): List<String>

    /** Returns the filter called [name]; throws as [argo.filters.format.FilterFinder.find] does. */
    fun filter(name: String): PerceptionFilter

    /** Explains why the filter keeps or drops the percept [percept], in words; for each board, if boards differ. */
    fun explain(percept: String): String

    /** Returns the critical rules of the active filter, in its order, each with the side that watches it. */
    fun criticalRules(): List<WatchedRule>

    /** Makes it perceive through [filter], null being none, before its next cycle; then its thread calls [done]. */
    fun perceiveThrough(filter: PerceptionFilter?, done: () -> Unit)

    /** Makes it start or stop perceiving before its next cycle; then its thread calls [done]. */
    fun perceive(open: Boolean, done: () -> Unit)

    /**
     * Sends [command], a literal or a string in quotes, before its next cycle, by the same way as the internal action `argo.act(command)`
     * of a plan. The thread that finds the outcome calls [done] once: with null, or with the reason why the command was not carried out.
     */
    fun act(command: String, done: (CommandFailure?) -> Unit) = act(command, SendOptions.defaults(), done)

    /** As the other [act], but with the [options] of `argo.act`. */
    fun act(command: String, options: SendOptions, done: (CommandFailure?) -> Unit)

    /** Makes the agent run a reasoning cycle soon. */
    fun wake()

    /** Makes it run a reasoning cycle soon, and further ones at growing intervals until [seen] returns true. */
    fun wakeUntil(seen: () -> Boolean)
}

/** A critical rule of an agent's filter, and the side that watches it now. */
data class WatchedRule(val rule: CriticalRule, val watcher: RuleWatcher)

/**
 * A port that an agent has asked for.
 *
 * @property name the agent's term for the port, as a literal: `ttyACM0`, or a string in its quotes
 * @property status `on`, `off` or `timeout`
 * @property isInUse whether it is the port in use, which gets commands for which no other board is found
 * @property isStale whether the agent believes `stale(P)` about it
 * @property isPerceived whether the agent perceives the board on the port
 * @property namespace the namespace of its board's percepts; null: the default namespace
 * @property intervalMs the sensing interval in ms of its board; null: it is not perceived
 * @property filter the name of the filter of its board; null: it has none, or is not perceived
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
