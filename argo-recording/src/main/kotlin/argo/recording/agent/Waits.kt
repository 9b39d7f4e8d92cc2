package argo.recording.agent

import argo.insides.Insides
import argo.insides.WaitEvents
import jason.asSemantics.CircumstanceListener
import jason.asSemantics.TransitionSystem

/** [wait], a `.wait` of Jason's, as it is written, with the number of its [timer]. */
internal fun describe(wait: CircumstanceListener, timer: Int?, isListening: Boolean) = WaitEvents.run {
    Wait(
        timer, isListening, trigger[wait], formula[wait], reason[wait], key[wait], unifier[wait], intention[wait], isDropped[wait],
        elapsed[wait],
    )
}

/**
 * Makes the `.wait` of Jason's that this is, for the agent of [ts], which begins a timer if it has one. It is registered nowhere.
 * The agent's listeners and pending intentions are to be set afterwards.
 */
internal fun Wait.make(ts: TransitionSystem): CircumstanceListener {
    val before = intention.suspendedReason
    Insides.selectedIntention[ts.c] = intention
    ts.c.listeners.clear() // others would take the new one for news
    val made = WaitEvents.make(trigger, formula, un, ts, if (timer == null) -1L else 0L, elapsed)
    intention.suspendedReason = before
    WaitEvents.reason[made] = reason
    WaitEvents.key[made] = key
    WaitEvents.isDropped[made] = isDropped
    return made
}
