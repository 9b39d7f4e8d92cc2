package argo.observing

/**
 * Pauses an agent between two of its reasoning cycles, and lets it go on. Any thread may call the functions, and none of them waits
 * for the agent.
 *
 * Before an agent is paused, its boards are made safe: each perceived board gets the command of the option `argo_safe`. An agent that is
 * paused perceives nothing, takes no mail, and carries out only what a person asks of an [ObservedAgent]. The world is not paused: its
 * boards are sensed, reflexes are sent, and the times of commands, `.wait` and `.at` run on. When the agent goes on, it perceives the
 * newest snapshot of each board, but no earlier snapshots.
 */
interface Pausing {
    /** The reason why the agent cannot be paused, in words; null: it can. If the agent cannot be paused, the functions do nothing. */
    val refusal: String?

    val state: PauseState

    /**
     * Pauses the agent before its next cycle, for [owner]; if it is paused already, for [owner] too: see [release]. Nobody can release a
     * stand without an owner.
     */
    fun pause(owner: Any = this)

    /** Lets the agent go on until a breakpoint, or until it is paused. */
    fun goOn()

    /**
     * Lets the agent go on until [stop], or until an earlier breakpoint. The agent is then paused for [owner], as after [pause].
     * @throws IllegalArgumentException if [stop] is about a plan that the agent does not have
     */
    fun goOnUntil(stop: StopAt, owner: Any = this)

    /**
     * Replaces the breakpoints of [owner] in [file] by those at [lines]. The agent is paused before it carries out the step at such a line,
     * or when it has chosen the plan whose trigger is there. At a reload breakpoints move with their plans. One that was set when its file
     * had been saved already is looked up in the new plans.
     *
     * @param owner the view or the debugger that sets them; any object, such as a [BreakpointOwner]
     * @param file the path of a program, or the last part of it
     * @return a breakpoint for each of [lines], in their order
     */
    fun breakAt(owner: Any, file: String, lines: List<Int>): List<Breakpoint>

    /** Returns the breakpoints of [owner]. */
    fun breakpoints(owner: Any): List<Breakpoint>

    /** Forgets the pauses that [owner] has asked for, and its breakpoints. An agent that is paused for [owner] and nobody else goes on. */
    fun release(owner: Any)

    /** Calls [listener] with each new state, on the thread of the change, until the result is closed. [listener] must not wait. */
    fun follow(listener: (PauseState) -> Unit): AutoCloseable

    /**
     * If the agent is paused, lets its thread do [look], which only reads beliefs and intentions, before the agent goes on. Returns false,
     * and does not call [look], if the agent is not paused.
     */
    fun look(look: () -> Unit): Boolean
}

/** The next place at which an agent is paused. */
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
        /** The plan itself and the plans that wait for it, but not the plans for its goals. */
        OVER,

        /** All plans. */
        INTO,

        /** The plans that wait for the plan. */
        OUT,
    }
}

/**
 * A breakpoint.
 *
 * @property file the file as the breakpoint's owner names it
 * @property wanted the line that was asked for
 * @property line the line before which the agent is paused: [wanted], or a later line; null: there is no such line
 * @property refusal the reason why there is no such line, in words; null: there is one
 */
data class Breakpoint(val file: String, val wanted: Int, val line: Int?, val refusal: String?)

/** An owner of breakpoints that is told when a reload has changed them. */
interface BreakpointOwner {
    /** Notes that [Pausing.breakpoints] has moved or lost breakpoints of this owner. Called by the agent's thread; must not wait. */
    fun breakpointsChanged()
}

/** The phases of a pause. */
enum class PausePhase { RUNNING, MAKING_SAFE, PAUSED }

/**
 * Whether an agent runs or is paused, and why. Immutable.
 *
 * @property why the reason why the agent is paused, in words; null: it is not
 * @property boards the result of making the boards safe, a sentence for each board; empty while the agent runs
 * @property place the step before which the agent is paused, or the plan that it has chosen; null: it has met no breakpoint
 * @property intention the number of the intention to look at first; null: no intention is special
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
