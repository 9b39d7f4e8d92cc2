package argo.perception

import jason.asSemantics.Event
import jason.asSyntax.Literal
import jason.asSyntax.Trigger.TEOperator
import jason.asSyntax.Trigger.TEType
import jason.bb.BeliefBase
import jason.bb.StructureWrapperForLiteral
import java.util.Queue

/**
 * Moves the events of the new percepts in [critical] to the front of [queue]. Within these and within all other events, the order stays.
 * Other threads may add events at the same time; no event is lost.
 */
internal fun bringForward(queue: Queue<Event>, critical: Collection<Literal>) {
    val wanted = critical.mapTo(HashSet(), ::StructureWrapperForLiteral)
    if (queue.none { tellsOf(it, wanted) }) return
    val waiting = generateSequence(queue::poll).toList() // the whole queue: a partial move could miss another thread's event
    val (urgent, others) = waiting.partition { tellsOf(it, wanted) }
    queue.addAll(urgent)
    queue.addAll(others)
}

private fun tellsOf(event: Event, percepts: Set<StructureWrapperForLiteral>): Boolean {
    val trigger = event.trigger
    return event.isExternal && trigger.operator == TEOperator.add && trigger.type == TEType.belief &&
        trigger.literal.hasSource(BeliefBase.APercept) && StructureWrapperForLiteral(trigger.literal) in percepts
}

/**
 * Lets the percept events of several boards take turns in Jason's queue. Otherwise a board with many events would delay other boards, since
 * Jason takes one event a cycle.
 *
 * @param queue the agent's event queue. Other threads may add events at the same time; no event is lost
 * @param waiting the number of events that were in the queue before those of the new snapshots
 * @param boardOf returns the board of a percept; null: no board
 */
internal fun takeTurns(queue: Queue<Event>, waiting: Int, boardOf: (Literal) -> Any?) {
    val isNew = queue.asSequence().drop(waiting).any(::isPerceptEvent)
    if (!isNew) return
    val all = generateSequence(queue::poll).toList()
    val (percepts, others) = all.drop(waiting).partition(::isPerceptEvent)
    val lanes = listOf(all.take(waiting)) + percepts.groupBy { boardOf(it.trigger.literal) }.values
    queue.addAll(inTurns(lanes) + others)
}

/** Returns the first element of each list in [lanes], then the second element of each, and so on. */
private fun <T> inTurns(lanes: List<List<T>>): List<T> =
    (0 until lanes.maxOf { it.size }).flatMap { i -> lanes.mapNotNull { it.getOrNull(i) } }
