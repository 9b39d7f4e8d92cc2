package argo.perception

import jason.asSemantics.Event
import jason.asSyntax.Literal
import jason.asSyntax.Trigger.TEOperator
import jason.asSyntax.Trigger.TEType
import jason.bb.BeliefBase
import jason.bb.StructureWrapperForLiteral
import java.util.Queue

/**
 * Puts the events of new [critical] percepts before all others in [queue], each kind in its order. Other threads may add events meanwhile;
 * none is lost.
 */
internal fun bringForward(queue: Queue<Event>, critical: Collection<Literal>) {
    val wanted = critical.mapTo(HashSet(), ::StructureWrapperForLiteral)
    if (queue.none { tellsOf(it, wanted) }) return
    val waiting = generateSequence(queue::poll).toList() // in parts of the queue an event of another thread could be passed over
    val (urgent, others) = waiting.partition { tellsOf(it, wanted) }
    queue.addAll(urgent)
    queue.addAll(others)
}

private fun tellsOf(event: Event, percepts: Set<StructureWrapperForLiteral>): Boolean {
    val trigger = event.trigger
    return event.isExternal && trigger.operator == TEOperator.add && trigger.type == TEType.belief &&
        trigger.literal.hasSource(BeliefBase.APercept) && StructureWrapperForLiteral(trigger.literal) in percepts
}
