package argo.perception

import jason.asSemantics.Event
import jason.asSyntax.Literal
import java.util.Queue

/**
 * Orders the percept events of several boards in turns in Jason's queue, of which Jason takes one a cycle, so that a board with many events
 * does not delay the others.
 *
 * @param queue the agent's event queue; other threads may add events meanwhile; none is lost
 * @param waiting the number of events in it before those of the new snapshots were added
 * @param boardOf returns the board of a percept; null: none has it
 */
internal fun takeTurns(queue: Queue<Event>, waiting: Int, boardOf: (Literal) -> Any?) {
    val isNew = queue.asSequence().drop(waiting).any(::isPerceptEvent)
    if (!isNew) return
    val all = generateSequence(queue::poll).toList()
    val (percepts, others) = all.drop(waiting).partition(::isPerceptEvent)
    val lanes = listOf(all.take(waiting)) + percepts.groupBy { boardOf(it.trigger.literal) }.values
    queue.addAll(inTurns(lanes) + others)
}

/** Returns the first of each of [lanes], then the second of each, and so on. */
private fun <T> inTurns(lanes: List<List<T>>): List<T> =
    (0 until lanes.maxOf { it.size }).flatMap { i -> lanes.mapNotNull { it.getOrNull(i) } }
