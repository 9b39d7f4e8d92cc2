package argo.observing

/**
 * An order to an agent, from a person or from the agent's last run. The agent carries it out at the beginning of a reasoning cycle, between
 * two steps of its intentions. Literals and goals in orders are texts in Jason's notation. Immutable.
 */
sealed interface Order {
    /**
     * Makes the agent believe [literal], as a step `+literal` of a plan does. If [literal] begins with `-+`, it replaces a belief that
     * differs only in its arguments. A belief without a source gets `source(self)`, so that the agent's plans can change it.
     */
    data class Believe(val literal: String) : Order

    /** Makes the agent forget each belief that unifies with [literal]. If [literal] names a source, removes only this source. */
    data class Forget(val literal: String) : Order

    /** Makes the agent begin [goal], written `!goal` or `goal`, as a new intention. */
    data class Begin(val goal: String) : Order

    /** Makes the agent drop each intention and event with an achievement goal that unifies with [goal], like `.drop_desire`. */
    data class Drop(val goal: String) : Order

    /**
     * Makes the agent exchange its program for the program in [files]. Only plans and rules that differ are exchanged. Plans that were
     * added at run time stay. Intentions finish the plans that they have begun.
     *
     * @property files the program, followed by each file that it includes, in the order of their reading
     * @property gone the addresses of files that the program no longer includes
     */
    data class Reload(val files: List<ProgramFile>, val gone: Set<String> = emptySet()) : Order

    /**
     * Makes the agent continue from its last run, before its first cycle. The [beliefs] replace all initial beliefs and goals of the
     * agent's program. A belief with `+` in front is new to the agent and causes an event. Beliefs without `+` cause no events.
     */
    data class Resume(val beliefs: List<String>) : Order

    /**
     * Makes the agent begin the intentions of its last run again, by their [events]. An event is `!goal`, or `+belief` for a belief that
     * the agent has. The outcome reports goals without a plan.
     */
    data class BeginAnew(val events: List<String>) : Order
}

/**
 * A file of a program.
 *
 * @property within the address of the including file; empty for the program itself
 * @property name the file's name in the directive `include`; empty for the program itself
 * @property address the file's address, as Jason names it in plans and errors
 */
data class ProgramFile(val within: String, val name: String, val address: String, val text: String)

/**
 * The outcome of an [Order].
 *
 * @property refusal for a person: why the agent has not carried out the order; null if it has carried it out. A refused order changes
 * nothing, except if it fails in foreign code
 * @property told further lines of the report to the person
 */
data class Outcome(val refusal: String?, val told: List<String> = emptyList())
