package argo.recording.recorder

import jason.asSemantics.CircumstanceListener
import jason.asSemantics.Event
import jason.asSyntax.Literal
import jason.bb.BeliefBase
import java.util.Collections
import java.util.IdentityHashMap

/**
 * Collects the events that other threads put into an agent's queue at any time. Safe for use by several threads.
 *
 * Jason puts an event into the queue before it tells its listeners. The agent may then select another thread's event before this class
 * learns of the event. Therefore this class also notes the agent's own events. If a selected event is not noted, it comes from another
 * thread.
 *
 * @param waiting returns the events that wait in the agent; those that wait at the beginning count as the agent's own
 * @param isOwn returns true if the calling thread carries out a cycle of the agent
 */
internal class ForeignEvents(private val waiting: () -> Collection<Event>, private val isOwn: () -> Boolean) : CircumstanceListener {
    @Transient
    private val added = ArrayList<Event>()

    @Transient
    private val known = identitySet(waiting())

    @Transient
    private var most = MANY

    @Transient
    private val early = identitySet(emptyList()) // events that were selected before Jason told this listener

    /** Collects [event] if another thread adds it. */
    @Synchronized
    override fun eventAdded(event: Event) {
        if (isOwn()) known += event else if (!early.remove(event)) added += event
    }

    val size: Int @Synchronized get() = added.size

    /** Returns true if another thread has added a belief: a collected event is the addition of a belief in [beliefs]. */
    @Synchronized
    fun addBeliefs(beliefs: BeliefBase): Boolean = added.map { it.trigger }.any { !it.isGoal && it.isAddition && it.literal in beliefs }

    private operator fun BeliefBase.contains(literal: Literal) = contains(literal) != null

    @Synchronized
    fun take(): List<Event> = added.toList().also {
        known += it
        added.clear()
    }

    /** Takes [event], which the agent has selected in this cycle. Returns true if another thread added the event. */
    @Synchronized
    fun takeSelected(event: Event): Boolean {
        val isForeign = event !in known && (added.removeIf { it === event } || event.isExternal.also { if (it) early += event })
        if (known.size > most) { // an event may be selected again; past events are forgotten now and then
            known.retainAll(identitySet(waiting()))
            most = maxOf(MANY, 2 * known.size)
        }
        return isForeign
    }

    private companion object {
        const val MANY = 1024

        fun identitySet(events: Collection<Event>): MutableSet<Event> =
            Collections.newSetFromMap(IdentityHashMap<Event, Boolean>()).apply { addAll(events) }
    }
}
