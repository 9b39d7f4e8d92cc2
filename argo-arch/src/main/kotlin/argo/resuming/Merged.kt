package argo.resuming

import argo.filters.jason.PerceptReader
import argo.mind.Mind

/**
 * The kept state of an agent whose program may have changed since. If the program began with a belief and does not begin with it now, the
 * agent does not get the belief back. Beliefs and goals that the program begins with only now are added. The program may have one belief of
 * a predicate with its sources, as before, but with other arguments. Then the agent's only such belief becomes that one, even if the agent
 * has changed it.
 *
 * @param program the beliefs and goals that the program begins with now
 */
internal class Merged(state: State, program: Mind) {
    private val gone = goneFrom(state.mind.beliefs, state.program.beliefs, program.beliefs)
    private val begun = program.events - state.program.events.toSet() - state.mind.events.toSet()

    /** The beliefs that the agent gets back. */
    val beliefs: List<String> = state.mind.beliefs - gone

    /** The beliefs that are new to the agent. */
    val newBeliefs: List<String> = program.beliefs - state.program.beliefs.toSet() - beliefs.toSet()

    /** The events with which its intentions begin. */
    val events: List<String> = state.mind.events + begun

    /** The effects of the program's change, for a person; empty: there are none. */
    val told: String = listOf("not believed any more" to gone, "believed in addition" to newBeliefs, "begun in addition" to begun)
        .filter { (_, facts) -> facts.isNotEmpty() }
        .joinToString("") { (what, facts) -> "; by the changed program $what: ${facts.joinToString(" ")}" }
}

/** Returns those of [kept] that an agent loses if its program began with the beliefs [then], and begins with [now]. */
private fun goneFrom(kept: List<String>, then: List<String>, now: List<String>): Set<String> {
    val before = onlyOnes(then)
    val changed = onlyOnes(now).filter { (predicate, belief) -> before[predicate].let { it != null && it != belief } }
    val replaced = onlyOnes(kept).filterKeys { it in changed }.values
    return kept.intersect(then.toSet()) + replaced - now.toSet()
}

/** Returns those of [beliefs] that are the only belief of their predicate and sources among [beliefs]. */
private fun onlyOnes(beliefs: List<String>): Map<Any, String> =
    beliefs.groupBy(::predicate).filterValues { it.size == 1 }.mapValues { (_, same) -> same.single() }

private fun predicate(belief: String): Any = PerceptReader.read(belief).run { predicateIndicator to sources }
