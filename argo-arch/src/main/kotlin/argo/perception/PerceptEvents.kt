package argo.perception

import argo.platform.Platform
import argo.platform.nowMs
import jason.asSemantics.Event
import jason.asSyntax.Literal
import jason.bb.BeliefBase
import java.util.Collections
import java.util.IdentityHashMap

/**
 * Tracks if the events of the last snapshot of a board have been taken from Jason's event queue. Later ones, such as those of a busy Jason
 * environment, do not count, or they could keep the agent from its sensors for good. Any thread may call [wait]; the rest belongs to the
 * agent's.
 *
 * @param queueStands returns true if Jason takes no event from the queue now, as while an atomic plan runs or waits. That plan must see the
 * world too, so then only [STANDING_MS] are awaited and no event: each snapshot adds events that the agent works off afterwards, and Jason
 * goes through all of them in each cycle
 * @param nowMs a clock in ms that never goes back
 * @param isOwn whether a percept event is of the board, or of none that the agent perceives; asked by any thread
 * @param queue the agent's event queue, which any thread may go through
 */
internal class PerceptEvents(
    private val queueStands: () -> Boolean = { false },
    private val nowMs: () -> Long = Platform.system.nowMs,
    private val isOwn: (Literal) -> Boolean = { true },
    private val queue: () -> Collection<Event>,
) {
    /** The percept events that were in the queue once the last snapshot had been taken in; null: it has not been, or the queue stands. */
    @Volatile
    private var awaited: Set<Event>? = null

    @Volatile
    private var handedOverMs = Long.MIN_VALUE / 2

    /** Notes that a snapshot is being handed over: its events in the queue are awaited. */
    fun handedOver() {
        awaited = null
        handedOverMs = nowMs()
    }

    /** Notes that the last snapshot has been taken in: later events than those in the queue now are not its own. */
    fun takenIn() {
        if (awaited != null || queueStands()) return // once for each snapshot: an atomic plan can leave tens of thousands of events
        awaited = queue().filterTo(Collections.newSetFromMap(IdentityHashMap())) { awaits(it) }
    }

    /** Returns true if some of the last snapshot's events are still in the queue, or it is too early to add to a queue that stands. */
    fun wait(): Boolean =
        if (queueStands()) nowMs() - handedOverMs < STANDING_MS else awaited?.isEmpty() != true && queue().any { awaits(it) }

    /** Returns the number of events in the queue, of any kind. Any thread. */
    fun waiting(): Int = queue().size

    private fun awaits(event: Event): Boolean = awaited?.contains(event) ?: (isPerceptEvent(event) && isOwn(event.trigger.literal))

    companion object {
        /** The least time in ms between two snapshots that are handed over while Jason takes no event. */
        const val STANDING_MS = 100
    }
}

/** Returns true if [event] tells that a percept came or went. */
internal fun isPerceptEvent(event: Event): Boolean =
    event.isExternal && event.trigger.isUpdate && event.trigger.literal.hasSource(BeliefBase.APercept)
