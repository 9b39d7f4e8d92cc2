package argo.view

import argo.filters.PerceptionFilter
import jason.bb.BeliefBase

/** What a live view asks of its agent and has it do. Any thread may call, but for [beliefs]. */
internal interface ViewedAgent {
    val name: String

    /** The word for when the agent gets a snapshot of its sensors. */
    val policy: String

    /** The sensing interval in ms. */
    val intervalMs: Int

    /** Whether it perceives its board. */
    val isPerceiving: Boolean

    /** The clock that the agent's messages are timed by, in ns; it never goes back. */
    fun nanos(): Long

    /** What it believes; belongs to the agent's thread. */
    val beliefs: BeliefBase

    /** The ports it has asked for. */
    fun ports(): List<ViewedPort>

    /** The names of the filters it could change to. */
    fun filterNames(): List<String>

    /** The filter of that [name]; throws what looking for one throws, see [argo.filters.format.FilterFinder.find]. */
    fun filter(name: String): PerceptionFilter

    /** Why the active filter does with the text [percept] what it does. */
    fun explain(percept: String): String

    /** Has the agent perceive through [filter], null being none; [done] is called by the agent's thread when it does. */
    fun perceiveThrough(filter: PerceptionFilter?, done: () -> Unit)

    /** Has the agent start or stop perceiving; [done] is called by the agent's thread when it has. */
    fun perceive(open: Boolean, done: () -> Unit)

    /** Has the agent run a reasoning cycle soon. */
    fun wake()
}

/**
 * A port of an agent.
 *
 * @property name what the agent calls it
 * @property status `on`, `off` or `timeout`
 * @property inUse whether it is the one for sensing and acting
 */
internal data class ViewedPort(val name: String, val status: String, val inUse: Boolean)
