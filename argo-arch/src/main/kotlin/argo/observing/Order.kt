package argo.observing

/**
 * An order to an agent, from a person or from the agent's last run. The agent carries it out at the beginning of a reasoning cycle, between
 * two steps of its intentions. Its texts are in Jason's notation. Immutable.
 */
sealed interface Order {
    /**
     * Makes the agent believe [literal], as a step `+literal` of a plan does; `-+literal` replaces beliefs that differ only in their
     * arguments. Without a source the belief gets `source(self)`, like the agent's own, so that its plans can change it.
     */
    data class Believe(val literal: String) : Order

    /** Makes the agent forget each belief that unifies with [literal]; if [literal] names a source, only the belief of that source. */
    data class Forget(val literal: String) : Order

    /** Makes the agent begin [goal], `!goal` or `goal`, as an intention of its own. */
    data class Begin(val goal: String) : Order

    /** Makes the agent drop each intention and event with an achievement goal that unifies with [goal], like `.drop_desire`. */
    data class Drop(val goal: String) : Order

    /**
     * Makes the agent exchange its program for the program in [files]: the plans and rules that differ. Plans that the agent has got at run
     * time stay, and its intentions finish the plans that they have begun.
     *
     * @property files the texts of the program and then of each file that it includes, as they were read
     * @property gone the addresses of files that the program included before
     */
    data class Reload(val files: List<ProgramFile>, val gone: Set<String> = emptySet()) : Order

    /**
     * Makes the agent, which has not begun, go on from its last run: it believes [beliefs] in place of all beliefs and goals that its
     * program begins with. They cause no events, except those that begin with `+`, which are new to the agent.
     */
    data class Resume(val beliefs: List<String>) : Order

    /**
     * Makes the agent begin the intentions of its last run anew, with their [events]: `!goal`, or `+belief` of a belief that it has. The
     * outcome reports goals without a plan.
     */
    data class BeginAnew(val events: List<String>) : Order
}

/**
 * A file of a program.
 *
 * @property within the address of the including file; empty: the program itself
 * @property name the file's name in the directive `include`; empty: the file is the program itself
 * @property address the file's address, as Jason names it in plans and errors
 */
data class ProgramFile(val within: String, val name: String, val address: String, val text: String)

/**
 * The outcome of an [Order].
 *
 * @property refusal the reason why the agent has refused the order, for a person; the agent is then unchanged, unless foreign code failed.
 * Null: the agent has carried the order out
 * @property told further lines for the person
 */
data class Outcome(val refusal: String?, val told: List<String> = emptyList())
