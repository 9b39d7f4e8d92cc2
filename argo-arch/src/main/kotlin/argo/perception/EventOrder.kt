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
 * Lets the percept events of several namespaces take turns in Jason's queue. Otherwise a board with many events would delay other boards,
 * since Jason takes one event a cycle.
 *
 * The turn of a percept event is its place among the percept events of its namespace, and a new event goes behind all events that have no
 * later turn. So no event goes in front of the first one of a namespace, and Jason reaches each event, however many come.
 *
 * @param queue the agent's event queue. Other threads may add events at the same time; no event is lost
 * @param waiting the number of events that were in the queue before those of the new snapshots; these keep their order
 */
internal fun takeTurns(queue: Queue<Event>, waiting: Int) {
    val isNew = queue.asSequence().drop(waiting).any(::isPerceptEvent)
    if (!isNew) return
    val all = generateSequence(queue::poll).toList()
    val (percepts, others) = all.drop(waiting).partition(::isPerceptEvent)
    val inTurn = all.take(waiting) + percepts
    val turns = turns(inTurn)
    val kept = turns.take(waiting).asReversed().runningReduce { later, turn -> minOf(later, turn) }.asReversed()
    queue.addAll(inTurn.zip(kept + turns.drop(waiting)).sortedBy { (_, turn) -> turn }.map { (event, _) -> event } + others)
}

/** Returns the turn of each event; an event of another kind has that of the percept event in front of it. */
private fun turns(events: List<Event>): List<Int> {
    val counts = HashMap<String, Int>()
    var turn = 0
    return events.map { event ->
        if (isPerceptEvent(event)) turn = counts.merge(event.trigger.literal.ns.functor, 1, Int::plus) ?: 1
        turn
    }
}
