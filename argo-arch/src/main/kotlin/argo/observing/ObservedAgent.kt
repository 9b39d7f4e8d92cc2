package argo.observing

import argo.filters.CriticalRule
import argo.filters.PerceptionFilter
import jason.asSemantics.Circumstance
import jason.asSemantics.TransitionSystem
import jason.bb.BeliefBase
import javino.SendOptions
import javino.wire.BoardAction
import java.util.logging.Logger

/** An agent as its observers see it, and what they can ask of it. Any thread may call, but for [beliefs]. */
interface ObservedAgent {
    /** Its name in the multi-agent system. */
    val name: String

    /** When it gets a snapshot of its sensors: `fresh`, `every` or `in_cycle`. */
    val policy: String

    /** The sensing interval in ms of boards without one of their own. */
    val intervalMs: Int

    /**
     * The time in ms between the oldest and the newest of the boards' readings that it believes; null: there are none. See `argo.skew`.
     */
    val skewMs: Long?

    /** Whether it perceives its boards. */
    val isPerceiving: Boolean

    /** The actions that its boards have registered; null: no board that it perceives has described itself. */
    val actions: List<BoardAction>?

    /** What it believes. For the agent's thread only: see [AgentObserver.cycleFinished]. */
    val beliefs: BeliefBase

    /** What it does: its intentions and events. For the agent's thread only, as [beliefs]. */
    val circumstance: Circumstance

    /** Jason's reasoning of it, with its program and options. For the agent's thread only, as [beliefs]. */
    val reasoning: TransitionSystem

    /** The log that its plans print to with `.print`. Jason's reports of it go there too. */
    val printed: Logger

    /** The clock that its messages are timed by, in ns. It never goes back. */
    fun nanos(): Long

    /** The ports that it has asked for. */
    fun ports(): List<ObservedPort>

    /**
     * The names of the filters that it could change to.
     *
     * @throws java.util.ServiceConfigurationError if a filter provider cannot be used
     */
    fun filterNames(): List<String>

    /** The filter called [name]; throws what [argo.filters.format.FilterFinder.find] throws. */
    fun filter(name: String): PerceptionFilter

    /** Why the filter keeps or drops the percept [percept], in words; of each board where they differ. */
    fun explain(percept: String): String

    /** The critical rules of the active filter, in its order, and who watches each. */
    fun criticalRules(): List<WatchedRule>

    /** Has it perceive through [filter], null being none, before its next cycle; then its thread calls [done]. */
    fun perceiveThrough(filter: PerceptionFilter?, done: () -> Unit)

    /** Has it start or stop perceiving before its next cycle; then its thread calls [done]. */
    fun perceive(open: Boolean, done: () -> Unit)

    /**
     * Sends [command], a literal or a string in quotes, before its next cycle, by the same way as the internal action `argo.act(command)`
     * of a plan. Whichever thread finds the outcome calls [done] once: with null, or why the command was not carried out.
     */
    fun act(command: String, done: (CommandFailure?) -> Unit) = act(command, SendOptions.defaults(), done)

    /** As the other [act], with [options], which are those of `argo.act`. */
    fun act(command: String, options: SendOptions, done: (CommandFailure?) -> Unit)

    /** Has it run a reasoning cycle soon. */
    fun wake()

    /** Has it run a reasoning cycle soon, and does so again, ever more slowly, until it has [seen] what it is woken for. */
    fun wakeUntil(seen: () -> Boolean)
}

/** A critical rule of an agent's filter, and who watches it now. */
data class WatchedRule(val rule: CriticalRule, val watcher: RuleWatcher)

/**
 * A port that an agent has asked for.
 *
 * @property name what the agent calls it, as a literal: `ttyACM0`, or a string in its quotes
 * @property status `on`, `off` or `timeout`
 * @property isInUse whether it is the port in use, where commands go for which no other board is found
 * @property isStale whether the agent believes `stale(P)` of it
 * @property isPerceived whether its board is among those that the agent perceives
 * @property namespace where what its board says is believed; null: in the default namespace
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
