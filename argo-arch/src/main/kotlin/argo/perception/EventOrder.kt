package argo.perception

import jason.asSemantics.Event
import jason.asSyntax.Literal
import jason.asSyntax.Trigger.TEOperator
import jason.asSyntax.Trigger.TEType
import jason.bb.BeliefBase
import jason.bb.StructureWrapperForLiteral
import java.util.Queue

/**
 * Moves the events of the new percepts in [critical] to the front of [queue]. The order of these events, and of all others, does not
 * change. Other threads may add events meanwhile, and no event is lost.
 */
internal fun bringForward(queue: Queue<Event>, critical: Collection<Literal>) {
    val wanted = critical.mapTo(HashSet(), ::StructureWrapperForLiteral)
    if (queue.none { tellsOf(it, wanted) }) return
    val waiting = generateSequence(queue::poll).toList() // the whole queue, since a partial move could miss another thread's event
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
 * Lets the percept events of several namespaces take turns in Jason's queue. Jason takes one event in a cycle, so a board with many events
 * would otherwise delay other boards.
 *
 * The turn of a percept event is its position among the percept events of its namespace. A new event is put after all events with an equal
 * or earlier turn. Therefore no event gets in front of the first event of a namespace. Jason reaches each event, even if new ones keep
 * coming.
 *
 * @param queue the agent's event queue. Other threads may add events meanwhile, and no event is lost
 * @param waiting the number of older events, which were in the queue before the events of the new snapshots. Older events keep their order
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

/** Returns the turn of each event. An event of another kind has the turn of the percept event before it. */
private fun turns(events: List<Event>): List<Int> {
    val counts = HashMap<String, Int>()
    var turn = 0
    return events.map { event ->
        if (isPerceptEvent(event)) turn = counts.merge(event.trigger.literal.ns.functor, 1, Int::plus) ?: 1
        turn
    }
}
