package argo.recording.recorder

import jason.asSemantics.CircumstanceListener
import jason.asSemantics.Event
import jason.asSyntax.Literal
import jason.bb.BeliefBase
import java.util.concurrent.ConcurrentLinkedQueue

/**
 * Collects the events that other threads put into an agent's queue, at any moment of a cycle or between two.
 *
 * @param isOwn returns true if the calling thread carries out a cycle of the agent
 */
internal class ForeignEvents(private val isOwn: () -> Boolean) : CircumstanceListener {
    @Transient
    private val added = ConcurrentLinkedQueue<Event>()

    /** Collects [event] if another thread adds it. Any thread. */
    override fun eventAdded(event: Event) {
        if (!isOwn()) added += event
    }

    val size: Int get() = added.size

    /** Returns true if a collected event is of a belief in [beliefs]: then the thread has added that belief, too. */
    fun addBeliefs(beliefs: BeliefBase): Boolean = added.map { it.trigger }.any { !it.isGoal && it.isAddition && it.literal in beliefs }

    private operator fun BeliefBase.contains(literal: Literal) = contains(literal) != null

    fun take(): List<Event> = generateSequence { added.poll() }.toList()

    /** Takes [event]; returns false if it is not among the collected ones. */
    fun take(event: Event): Boolean = added.removeIf { it === event }
}
