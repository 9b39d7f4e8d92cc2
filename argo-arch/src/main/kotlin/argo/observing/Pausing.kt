package argo.observing

/**
 * Has an agent stand between two of its reasoning cycles, and go on. Any thread may call the functions, and none of them waits for the
 * agent.
 *
 * The boards of an agent that is to stand are made safe first: each perceived board gets the command of the option `argo_safe`. An agent
 * that stands perceives nothing, takes no mail and carries nothing out but what a person asks of an [ObservedAgent]. The world does not
 * stand: its boards are sensed, reflexes are sent, and the times of commands, `.wait` and `.at` run on. When the agent goes on, it
 * perceives the newest snapshot of each board, and no earlier one.
 */
interface Pausing {
    /** The reason why the agent cannot stand, in words; null: it can. If it cannot, the functions do nothing. */
    val refusal: String?

    val state: PauseState

    /** Has the agent stand before its next cycle, or stand on, for [owner] too: see [release]. Without an owner, nobody releases it. */
    fun pause(owner: Any = this)

    /** Has the agent go on until a breakpoint, or until it is paused. */
    fun goOn()

    /**
     * Has the agent go on until [stop], or until an earlier breakpoint. Then it stands for [owner], as after [pause].
     * @throws IllegalArgumentException if [stop] is about a plan that the agent does not have
     */
    fun goOnUntil(stop: StopAt, owner: Any = this)

    /**
     * Replaces the breakpoints of [owner] in [file] by those at [lines]. The agent stands before it carries out the step at such a line, or
     * when it has chosen the plan whose trigger is there. At a reload breakpoints move with their plans. One that was set when its file had been
     * saved already is looked up in the new plans.
     *
     * @param owner the view or the debugger that sets them; any object, such as a [BreakpointOwner]
     * @param file the path of a program, or the last part of it
     * @return a breakpoint for each of [lines], in their order
     */
    fun breakAt(owner: Any, file: String, lines: List<Int>): List<Breakpoint>

    /** Returns the breakpoints of [owner]. */
    fun breakpoints(owner: Any): List<Breakpoint>

    /** Forgets what [owner] has asked for, and its breakpoints. An agent that stands for [owner] only goes on. */
    fun release(owner: Any)

    /** Calls [listener] with each new state, on the thread of the change, until the result is closed. [listener] must not wait. */
    fun follow(listener: (PauseState) -> Unit): AutoCloseable

    /**
     * If the agent stands, has its thread do [look], which only reads beliefs and intentions, before the agent goes on. Returns false, and
     * does not call [look], if the agent does not stand.
     */
    fun look(look: () -> Unit): Boolean
}

/** The next place at which an agent stands. */
sealed interface StopAt {
    /** The next cycle: the agent carries out one. */
    data object NextCycle : StopAt

    /** The choice of a plan with this label, such as `drive`, or with this trigger, such as `+!drive`; null: of any plan. */
    data class ChosenPlan(val plan: String?) : StopAt

    /** A percept or another belief that is new and unifies with [pattern], a literal such as `dist(front,_)`. */
    data class Belief(val pattern: String) : StopAt

    /** The next step of the intention with the number [intention], as Jason counts intentions. */
    data class Step(val intention: Int, val way: Way) : StopAt

    /** The plans of an intention whose steps count as next. */
    enum class Way {
        /** The plan itself and those that wait for it, but not those for its goals. */
        OVER,

        /** All plans. */
        INTO,

        /** Those that wait for the plan. */
        OUT,
    }
}

/**
 * A breakpoint.
 *
 * @property file the file as its owner names it
 * @property wanted the line that was asked for
 * @property line the line before which the agent stands, [wanted] or one behind it; null: there is none
 * @property refusal the reason why there is none, in words; null: there is one
 */
data class Breakpoint(val file: String, val wanted: Int, val line: Int?, val refusal: String?)

/** An owner of breakpoints that is told when a reload has changed them. */
interface BreakpointOwner {
    /** Notes that [Pausing.breakpoints] has moved or lost breakpoints of this owner. Called by the agent's thread; must not wait. */
    fun breakpointsChanged()
}

/** The phases of a pause. */
enum class PausePhase { RUNNING, MAKING_SAFE, STANDING }

/**
 * What an agent does as to pauses. Immutable.
 *
 * @property why the reason why the agent stands, in words; null: it does not
 * @property boards what became of the boards, a sentence for each; empty while the agent runs
 * @property place the step before which the agent stands, or the plan that it has chosen, if it met a breakpoint; else null
 * @property intention the number of the intention to look at first; null: none is distinguished
 * @property sinceNanos the time at which this state began, in ns of [ObservedAgent.nanos]
 */
data class PauseState(
    val phase: PausePhase,
    val why: String?,
    val boards: List<String>,
    val place: SourceLine?,
    val intention: Int?,
    val sinceNanos: Long,
)
