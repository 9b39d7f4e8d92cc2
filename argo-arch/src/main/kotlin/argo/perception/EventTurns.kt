package argo.perception

import jason.asSemantics.Event
import jason.asSyntax.Literal
import java.util.Queue

/**
 * Has the percept events of several boards take turns in Jason's queue, which takes one a cycle, so that a board with many of them does not
 * delay the others.
 *
 * @param queue the agent's event queue; other threads may add events meanwhile, of which none is lost
 * @param waiting how many events waited in it before those of the new snapshots were added
 * @param boardOf the board that says a percept; null: none does
 */
internal fun takeTurns(queue: Queue<Event>, waiting: Int, boardOf: (Literal) -> Any?) {
    val isNew = queue.asSequence().drop(waiting).any(::isPerceptEvent)
    if (!isNew) return
    val all = generateSequence(queue::poll).toList()
    val (percepts, others) = all.drop(waiting).partition(::isPerceptEvent)
    val lanes = listOf(all.take(waiting)) + percepts.groupBy { boardOf(it.trigger.literal) }.values
    queue.addAll(inTurns(lanes) + others)
}

/** The first of each of [lanes], then the second of each, and so on. */
private fun <T> inTurns(lanes: List<List<T>>): List<T> =
    (0 until lanes.maxOf { it.size }).flatMap { i -> lanes.mapNotNull { it.getOrNull(i) } }
