package argo.recording.recorder

import argo.insides.Insides
import argo.platform.Plans
import jason.asSemantics.TransitionSystem

/**
 * The numbers of an agent's beliefs, events, intentions, plans and messages. If code changes a number, it does more than return a result.
 */
internal data class MindSizes(val beliefs: Int, val events: Int, val running: Int, val pending: Int, val plans: Int, val mail: Int) {
    companion object {
        fun of(ts: TransitionSystem): MindSizes = ts.c.run {
            val events = events.size + (if (Insides.atomicEvent[this] == null) 0 else 1) + pendingEvents.size
            val running = nbRunningIntentions + (if (Insides.atomicIntention[this] == null) 0 else 1)
            MindSizes(ts.ag.bb.size(), events, running, pendingIntentions.size, Plans.of(ts.ag).all.size, mailBox.size)
        }
    }
}
