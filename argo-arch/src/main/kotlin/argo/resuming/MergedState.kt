package argo.resuming

import argo.filters.jason.PerceptReader
import argo.mind.Mind

/**
 * The kept state of an agent, adapted to a program that may have changed since. If an initial belief was removed from the program, the
 * agent does not get it back. New initial beliefs and goals are added.
 *
 * An initial belief with changed arguments replaces the agent's belief, even if the agent has changed its belief. The program and the agent
 * must each have only one belief of this predicate from these sources.
 *
 * @param program the initial beliefs and goals of the program now
 */
internal class MergedState(state: State, program: Mind) {
    private val gone = goneFrom(state.mind.beliefs, state.program.beliefs, program.beliefs)
    private val begun = program.events - state.program.events.toSet() - state.mind.events.toSet()

    /** The beliefs that the agent gets back. */
    val beliefs: List<String> = state.mind.beliefs - gone

    /** The beliefs that are new to the agent. */
    val newBeliefs: List<String> = program.beliefs - state.program.beliefs.toSet() - beliefs.toSet()

    /** The events with which the agent's intentions begin. */
    val events: List<String> = state.mind.events + begun

    /** The effects of the program's change on the agent, for a person; empty if there are none. */
    val told: String = listOf("not believed any more" to gone, "believed in addition" to newBeliefs, "begun in addition" to begun)
        .filter { (_, facts) -> facts.isNotEmpty() }
        .joinToString("") { (what, facts) -> "; by the changed program $what: ${facts.joinToString(" ")}" }
}

/** Returns the beliefs in [kept] that an agent loses if the initial beliefs of its program were [then], and are [now]. */
private fun goneFrom(kept: List<String>, then: List<String>, now: List<String>): Set<String> {
    val before = onlyOnes(then)
    val changed = onlyOnes(now).filter { (predicate, belief) -> before[predicate].let { it != null && it != belief } }
    val replaced = onlyOnes(kept).filterKeys { it in changed }.values
    return kept.intersect(then.toSet()) + replaced - now.toSet()
}

/** Returns the beliefs that share their predicate and sources with no other in [beliefs]. The keys are predicate and sources. */
private fun onlyOnes(beliefs: List<String>): Map<Any, String> =
    beliefs.groupBy(::predicate).filterValues { it.size == 1 }.mapValues { (_, same) -> same.single() }

private fun predicate(belief: String): Any = PerceptReader.read(belief).run { predicateIndicator to sources }
