package argo.observing

/**
 * An order of a person to an agent, or of an earlier run of it. The agent carries it out at the beginning of a reasoning cycle, between two
 * steps of its intentions. Its texts are in Jason's notation. Immutable.
 */
sealed interface Order {
    /**
     * Has the agent believe [literal], as a step `+literal` of a plan does; `-+literal` takes the place of beliefs that differ only in their
     * arguments. Without a source the belief gets `source(self)`, like the agent's own, so that its plans can change it.
     */
    data class Believe(val literal: String) : Order

    /** Has the agent forget each belief that unifies with [literal]; if it names a source, only the belief of that source. */
    data class Forget(val literal: String) : Order

    /** Has the agent begin [goal], `!goal` or `goal`, as an intention of its own. */
    data class Begin(val goal: String) : Order

    /** Has the agent drop each intention and event with an achievement goal that unifies with [goal], like `.drop_desire`. */
    data class Drop(val goal: String) : Order

    /**
     * Has the agent exchange its program for the one in [files]: the plans and rules that differ. Plans that it has got at run time stay, and
     * its intentions finish the plans that they have begun.
     *
     * @property files the program, and behind it each file that it includes, as they were read
     * @property gone the addresses of files that the program included before
     */
    data class Reload(val files: List<ProgramFile>, val gone: Set<String> = emptySet()) : Order

    /**
     * Has the agent, which has not begun, go on from its last run: it believes [beliefs] in place of all that its program begins with,
     * goals included. They cause no events, except those that begin with `+`, which it learns only now.
     */
    data class Resume(val beliefs: List<String>) : Order

    /**
     * Has the agent begin its intentions of its last run anew, with their [events]: `!goal`, or `+belief` of a belief that it has. Goals
     * without a plan are told.
     */
    data class BeginAnew(val events: List<String>) : Order
}

/**
 * A file of a program.
 *
 * @property within the address of the file that includes it; empty: the program itself does
 * @property name its name in the directive `include`; empty: it is the program itself
 * @property address its address, as Jason names it in plans and errors
 */
data class ProgramFile(val within: String, val name: String, val address: String, val text: String)

/**
 * The outcome of an [Order].
 *
 * @property refusal the reason for which the agent has refused the order, for a person; the agent is unchanged, unless code has
 *   failed. Null: it is carried out
 * @property told further lines for the person
 */
data class Outcome(val refusal: String?, val told: List<String> = emptyList())
