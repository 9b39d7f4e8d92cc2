package argo.recording.recorder

import jason.asSemantics.CircumstanceListener
import jason.asSemantics.Event
import java.util.concurrent.ConcurrentLinkedQueue

/**
 * The events that come into an agent's queue by another thread, at any moment of a cycle or between two.
 *
 * @param isOwn whether the calling thread carries out a cycle of the agent
 */
internal class ForeignEvents(private val isOwn: () -> Boolean) : CircumstanceListener {
    @Transient
    private val added = ConcurrentLinkedQueue<Event>()

    /** Any thread. */
    override fun eventAdded(event: Event) {
        if (!isOwn()) added += event
    }

    fun isEmpty(): Boolean = added.isEmpty()

    /** Takes those that have come. */
    fun take(): List<Event> = generateSequence { added.poll() }.toList()

    /** Takes [event], if it is one of them. */
    fun take(event: Event): Boolean = added.removeIf { it === event }
}
