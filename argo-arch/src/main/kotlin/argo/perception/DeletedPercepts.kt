package argo.perception

import argo.platform.Plans
import jason.asSemantics.Agent
import jason.asSemantics.Event
import jason.asSyntax.Literal
import jason.asSyntax.Trigger
import jason.asSyntax.Trigger.TEOperator
import jason.asSyntax.Trigger.TEType
import jason.bb.BeliefBase
import jason.bb.StructureWrapperForLiteral

/**
 * Adds the missing namespaces and negations to events of deleted percepts. When Jason deletes `left::dist(f,30)` and finds a plan for
 * `-left::dist(f,30)`, it makes the event `-dist(f,30)`; for `~open(door)` it makes `-open(door)`. For the agent's thread only.
 */
internal class DeletedPercepts {
    private var deleted: List<Literal> = emptyList()

    /** Called before Jason replaces all percepts of [agent] by [percepts]. */
    fun expect(agent: Agent, percepts: Collection<Literal>) {
        val believed = agent.bb.percepts.asSequence().filter { (it.ns != Literal.DefaultNS || it.negated()) && it.subjectToBUF() }.toList()
        val stay = if (believed.isEmpty()) emptySet() else percepts.mapTo(HashSet(), ::StructureWrapperForLiteral)
        deleted = believed.filter { StructureWrapperForLiteral(it) !in stay }.map { it.copy() as Literal }.filter { hasEvent(agent, it) }
    }

    private fun hasEvent(agent: Agent, percept: Literal) =
        agent.ts.c.hasListener() || Plans.of(agent).hasCandidate(Trigger(TEOperator.del, TEType.belief, percept))

    /** Corrects the events that Jason has added to [queue]. */
    fun mend(queue: Collection<Event>) {
        if (deleted.isEmpty()) return
        val waiting = deleted.toMutableList()
        deleted = emptyList()
        for (event in queue.reversed()) { // the new events are at the end
            if (waiting.isEmpty()) return
            val literal = deletedPercept(event) ?: continue
            val index = waiting.indexOfFirst { it.functor == literal.functor && it.terms.orEmpty() == literal.terms.orEmpty() }
            if (index >= 0) event.trigger.literal = waiting.removeAt(index).also(::perceivedAlone)
        }
    }

    private fun deletedPercept(event: Event): Literal? = event.trigger.takeIf { event.isExternal && isDeletion(it) }?.literal
        ?.takeIf { it.ns == Literal.DefaultNS && it.hasSource(BeliefBase.APercept) }

    private fun isDeletion(trigger: Trigger) = trigger.operator == TEOperator.del && trigger.type == TEType.belief

    private fun perceivedAlone(percept: Literal) {
        percept.clearAnnots()
        percept.addAnnot(BeliefBase.TPercept)
    }
}
