package argo.view.timeline

import argo.recording.Place
import argo.recording.Step

/**
 * Links each step of an agent's intentions with the event that caused it, and each goal with the step that posed it. A recording does not
 * contain these links.
 */
internal class PlanLinks {
    /** A plan that was chosen for an event and has made no step yet. [intention] is the plan's intention; null if none existed yet. */
    private class Chosen(val event: Int, val plan: Place, val intention: Int?)

    private val waiting = ArrayDeque<Chosen>()
    private val events = HashMap<Pair<Int, Int>, Int>()
    private val posing = HashMap<String, Int>()
    private val intentions = HashMap<Int, Int>()
    private val seen = HashSet<Int>()

    /** The last failed step; null if there is none. */
    var failed: Int? = null

    /** Returns the step that caused the goal event [trigger]; null if the goal is initial or came from outside. */
    fun posing(trigger: String): Int? = if (trigger.startsWith('-')) failed else posing[functor(trigger.drop(2))]

    /** Returns the number of the intention in which [step] posed its goal; null if the goal began its own intention. */
    fun intentionOf(step: Int): Int? = intentions[step]

    fun chosen(event: Int, plan: Place, intention: Int?) {
        waiting += Chosen(event, plan, intention)
        if (waiting.size > MOST_WAITING) waiting.removeFirst()
    }

    /** Returns the event for which the plan of [step] was chosen; null if it is not known. */
    fun causeOf(step: Step): Int? {
        val key = step.intention to step.depth
        val found = waiting.find {
            it.plan == step.plan && if (it.intention == null) step.intention !in seen else it.intention == step.intention
        }
        if (found != null) {
            waiting -= found
            events[key] = found.event
        }
        seen += step.intention
        return events[key]
    }

    /** Notes that [step] was carried out. [id] is the id of the step's item. */
    fun stepped(id: Int, step: Step, text: String) {
        if (!text.startsWith("!!")) intentions[id] = step.intention
        if (text.startsWith('!') || text.startsWith('?')) posing[functor(text.trimStart('!', '?'))] = id
    }

    private companion object {
        /** The largest number of plans that wait for their first step. Plans without a body never make a step. */
        const val MOST_WAITING = 100
    }
}
