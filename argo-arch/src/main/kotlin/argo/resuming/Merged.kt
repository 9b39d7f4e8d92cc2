package argo.resuming

import argo.filters.jason.PerceptReader
import argo.mind.Mind

/**
 * A kept state for an agent whose program may have changed since then. Beliefs that the program began with then, and does not begin with
 * now, are not resumed; beliefs and goals that it begins with only now come in addition. If the program had one belief of a predicate with
 * the same sources then, and has another one now, this takes the place of the agent's only one, also if the agent has changed it.
 *
 * @param program what the program begins with now
 */
internal class Merged(state: State, program: Mind) {
    private val gone = goneFrom(state.mind.beliefs, state.program.beliefs, program.beliefs)
    private val begun = program.events - state.program.events.toSet() - state.mind.events.toSet()

    /** The beliefs that the agent has again. */
    val beliefs: List<String> = state.mind.beliefs - gone

    /** The beliefs that are new to the agent. */
    val newBeliefs: List<String> = program.beliefs - state.program.beliefs.toSet() - beliefs.toSet()

    /** The events with which its intentions begin. */
    val events: List<String> = state.mind.events + begun

    /** What the change of the program changes, for a person; empty: nothing. */
    val told: String = listOf("not believed any more" to gone, "believed in addition" to newBeliefs, "begun in addition" to begun)
        .filter { (_, facts) -> facts.isNotEmpty() }
        .joinToString("") { (what, facts) -> "; by the changed program $what: ${facts.joinToString(" ")}" }
}

/** Returns which of [kept] an agent loses whose program began with the beliefs [then], and begins with those of [now]. */
private fun goneFrom(kept: List<String>, then: List<String>, now: List<String>): Set<String> {
    val before = onlyOnes(then)
    val changed = onlyOnes(now).filter { (predicate, belief) -> before[predicate].let { it != null && it != belief } }
    val replaced = onlyOnes(kept).filterKeys { it in changed }.values
    return kept.intersect(then.toSet()) + replaced - now.toSet()
}

/** Returns those of [beliefs] that are the only one of their predicate and sources, by these. */
private fun onlyOnes(beliefs: List<String>): Map<Any, String> =
    beliefs.groupBy(::predicate).filterValues { it.size == 1 }.mapValues { (_, same) -> same.single() }

private fun predicate(belief: String): Any = PerceptReader.read(belief).run { predicateIndicator to sources }
