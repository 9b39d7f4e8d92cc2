package argo.recording.agent

import argo.insides.Insides
import argo.insides.WaitEvents
import jason.asSemantics.CircumstanceListener
import jason.asSemantics.TransitionSystem

/** Describes [wait], a `.wait` of Jason's, for a key frame, with the number of its [timer]. */
internal fun describe(wait: CircumstanceListener, timer: Int?, isListening: Boolean) = WaitEvents.run {
    Wait(
        timer, isListening, trigger[wait], formula[wait], reason[wait], key[wait], unifier[wait], intention[wait], isDropped[wait],
        elapsed[wait],
    )
}

/**
 * Makes the described `.wait` of Jason's for the agent of [ts], and begins its timer if it has one. Registers it nowhere, and clears the
 * agent's listeners: the caller sets listeners and pending intentions afterwards.
 */
internal fun Wait.make(ts: TransitionSystem): CircumstanceListener {
    val before = intention.suspendedReason
    Insides.selectedIntention[ts.c] = intention
    ts.c.listeners.clear() // other listeners would be notified of the new one
    val made = WaitEvents.make(trigger, formula, un, ts, if (timer == null) -1L else 0L, elapsed)
    intention.suspendedReason = before
    WaitEvents.reason[made] = reason
    WaitEvents.key[made] = key
    WaitEvents.isDropped[made] = isDropped
    return made
}
