package argo.recording.agent

import argo.insides.Insides
import argo.insides.WaitEvents
import jason.asSemantics.CircumstanceListener
import jason.asSemantics.Event
import jason.asSemantics.Intention
import jason.asSemantics.TransitionSystem
import jason.asSemantics.Unifier
import jason.asSyntax.Literal
import jason.asSyntax.LogicalFormula
import jason.asSyntax.Plan
import jason.asSyntax.Rule
import jason.asSyntax.Term
import jason.asSyntax.Trigger
import java.io.Serializable

internal class Mind(
    val events: ArrayList<Event>,
    val atomicEvent: Event?,
    val running: ArrayList<Intention>,
    val atomic: Intention?,
    val isAtomicSuspended: Boolean,
    val pending: LinkedHashMap<String, Intention>,
    val pendingEvents: LinkedHashMap<String, Event>,
    val goalConditions: Int,
    /** The last chosen event. A cycle without a choice keeps this event. */
    val event: Event?,
    val plan: Plan?,
    val intention: Intention?,
    val waits: ArrayList<Wait>,
    /** The intentions with a number, in the order of their [numbers]. */
    val numbered: ArrayList<Intention>,
    val numbers: ArrayList<Int>,
    /** The agent's plans; null if it has exactly those of its program. */
    val plans: ArrayList<Plan>?,
    /** The rules that the agent has got at run time, by their places among its beliefs; null if there are none. */
    val rules: HashMap<Int, Rule>? = null,
) : Serializable {
    private companion object {
        const val serialVersionUID = 1L
    }
}

/**
 * A `.wait` of Jason.
 *
 * @property timer the number of the `.wait`'s timer; null if no timer is running
 * @property isListening whether the `.wait` still waits; its timer may run on after the `.wait` has ended
 */
internal class Wait(
    val timer: Int?,
    val isListening: Boolean,
    val trigger: Trigger?,
    val formula: LogicalFormula?,
    val reason: Literal,
    val key: String,
    val un: Unifier,
    val intention: Intention,
    val isDropped: Boolean,
    val elapsed: Term?,
) : Serializable {
    private companion object {
        const val serialVersionUID = 1L
    }
}

internal fun describe(wait: CircumstanceListener, timer: Int?, isListening: Boolean) = WaitEvents.run {
    Wait(
        timer, isListening, trigger[wait], formula[wait], reason[wait], key[wait], unifier[wait], intention[wait], isDropped[wait],
        elapsed[wait],
    )
}

/**
 * Makes the described `.wait` for the agent of [ts], and begins its timer if it has one. Does not register the `.wait`, and clears the
 * agent's listeners. The caller must then set listeners and pending intentions.
 */
internal fun Wait.make(ts: TransitionSystem): CircumstanceListener {
    val before = intention.suspendedReason
    Insides.selectedIntention[ts.c] = intention
    ts.c.listeners.clear() // no listener must be notified of the new mind
    val made = WaitEvents.make(trigger, formula, un, ts, if (timer == null) -1L else 0L, elapsed)
    intention.suspendedReason = before
    WaitEvents.reason[made] = reason
    WaitEvents.key[made] = key
    WaitEvents.isDropped[made] = isDropped
    return made
}
