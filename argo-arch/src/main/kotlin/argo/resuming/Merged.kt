package argo.resuming

import argo.mind.Mind

/**
 * A kept state for an agent whose program may have changed since then. Beliefs that the program began with then, and does not begin with
 * now, are not resumed; beliefs and goals that it begins with only now come in addition.
 *
 * @param program what the program begins with now
 */
internal class Merged(state: State, program: Mind) {
    private val gone = state.mind.beliefs.intersect(state.program.beliefs.toSet() - program.beliefs.toSet())
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
