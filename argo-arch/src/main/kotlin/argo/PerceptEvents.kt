package argo

import jason.asSemantics.Event
import jason.bb.BeliefBase
import java.util.Collections
import java.util.IdentityHashMap

/**
 * Knows whether the events of the last snapshot have been taken from Jason's event queue. Later ones, such as those of a busy
 * Jason environment, do not count, or they could keep the agent from its sensors for good. Belongs to the agent's thread.
 *
 * @param queue the agent's event queue
 */
internal class PerceptEvents(private val queue: () -> Collection<Event>) {
    private var awaited: MutableSet<Event>? = null

    /** A snapshot is being handed over: what it adds to the queue is awaited. */
    fun handedOver() {
        awaited = null
    }

    /** Whether some of the last snapshot's events are still in the queue. */
    fun wait(): Boolean {
        val still = queue().filterTo(identitySet()) { event -> awaited?.contains(event) ?: isPerceptEvent(event) }
        awaited = still
        return still.isNotEmpty()
    }

    private fun identitySet(): MutableSet<Event> = Collections.newSetFromMap(IdentityHashMap())
}

private fun isPerceptEvent(event: Event): Boolean =
    event.isExternal && event.trigger.isUpdate && event.trigger.literal.hasSource(BeliefBase.APercept)
