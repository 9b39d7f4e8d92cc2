package argo.view.timeline

import argo.recording.Place
import argo.recording.Step

/** Which event each step of an agent's intentions came of, and which step posed a goal. A recording has neither in so many words. */
internal class PlanLinks {
    /** A plan that was chosen for an event and has made no step yet; [intention] is the one that it belongs to, if that was there. */
    private class Chosen(val event: Int, val plan: Place, val intention: Int?)

    private val waiting = ArrayDeque<Chosen>()
    private val events = HashMap<Pair<Int, Int>, Int>()
    private val posing = HashMap<String, Int>()
    private val intentions = HashMap<Int, Int>()
    private val seen = HashSet<Int>()

    /** The last step that failed; null: none has. */
    var failed: Int? = null

    /** The step that the event of a goal, [trigger], came of; null: it is one that the agent began with, or that came from outside. */
    fun posing(trigger: String): Int? = if (trigger.startsWith('-')) failed else posing[functor(trigger.drop(2))]

    /** The number of the intention of [step]; null: the goal is one of its own. */
    fun intentionOf(step: Int): Int? = intentions[step]

    /** [plan] was chosen for [event]. */
    fun chosen(event: Int, plan: Place, intention: Int?) {
        waiting += Chosen(event, plan, intention)
        if (waiting.size > MOST_WAITING) waiting.removeFirst()
    }

    /** The event whose plan [step] is of; null: it is not known. */
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

    /** [step], whose item is [id], was carried out. */
    fun stepped(id: Int, step: Step, text: String) {
        if (!text.startsWith("!!")) intentions[id] = step.intention
        if (text.startsWith('!') || text.startsWith('?')) posing[functor(text.trimStart('!', '?'))] = id
    }

    private companion object {
        /** Plans without a body make no step. */
        const val MOST_WAITING = 100
    }
}
