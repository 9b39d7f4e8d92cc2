package argo.observing

/**
 * Pauses an agent between two of its reasoning cycles, and lets it continue. Any thread may call the functions. None of them waits for the
 * agent.
 *
 * Before an agent is paused, its boards are made safe: each perceived board gets the command of the option `argo_safe`. A paused agent
 * perceives nothing, takes no mail, and carries out only what a person asks of an [ObservedAgent]. The world is not paused. The agent's
 * boards are still sensed, reflexes are sent, and the times of commands, `.wait` and `.at` run on. When the agent continues, it perceives
 * the newest snapshot of each board, but no earlier snapshots.
 */
interface Pausing {
    /** The reason why the agent cannot be paused, in words; null if it can be paused. If there is a reason, the functions do nothing. */
    val refusal: String?

    val state: PauseState

    /**
     * Pauses the agent for [owner], before the agent's next cycle. If the agent is already paused, the pause gets [owner] as a further
     * owner, see [release]. A pause for the default owner lasts until somebody calls [goOn] or [goOnUntil].
     */
    fun pause(owner: Any = this)

    /** Lets the agent continue until a breakpoint, or until it is paused. */
    fun goOn()

    /**
     * Lets the agent continue until [stop], or until an earlier breakpoint. The agent is then paused for [owner], as after [pause].
     *
     * @throws IllegalArgumentException if [stop] cannot be read, or names a plan that the agent does not have
     */
    fun goOnUntil(stop: StopAt, owner: Any = this)

    /**
     * Replaces the breakpoints of [owner] in [file] by breakpoints at [lines]. A breakpoint at a step pauses the agent before the step. A
     * breakpoint at the trigger of a plan pauses the agent when it has chosen the plan.
     *
     * At a reload, breakpoints move with their plans. A breakpoint that was set after its file had been saved already belongs to the new
     * text. The reload searches the new text for its line.
     *
     * @param owner any object that stands for the view or the debugger; a [BreakpointOwner] is told of changes
     * @param file the path of a program, or the last part of it
     * @return a breakpoint for each of [lines], in their order
     */
    fun breakAt(owner: Any, file: String, lines: List<Int>): List<Breakpoint>

    fun breakpoints(owner: Any): List<Breakpoint>

    /** Forgets the pauses and the breakpoints of [owner]. If the agent is paused only for [owner], it continues. */
    fun release(owner: Any)

    /**
     * Calls [listener] with each new state, until the returned object is closed. The thread that changes the state makes the call.
     * [listener] must not wait.
     */
    fun follow(listener: (PauseState) -> Unit): AutoCloseable

    /**
     * If the agent is paused, returns true, and the agent's thread calls [look] before the agent continues. [look] may only read beliefs
     * and intentions. If the agent is not paused, returns false and does not call [look].
     */
    fun look(look: () -> Unit): Boolean
}

/** The next place at which an agent is paused. */
sealed interface StopAt {
    /** After the next cycle. */
    data object NextCycle : StopAt

    /** The choice of a plan with the label or trigger [plan], such as `drive` or `+!drive`. If [plan] is null, the choice of any plan. */
    data class ChosenPlan(val plan: String?) : StopAt

    /** A new belief, perceived or not, that unifies with [pattern], a literal such as `dist(front,_)`. */
    data class Belief(val pattern: String) : StopAt

    /** The next step of the intention with the number [intention], as Jason counts intentions. */
    data class Step(val intention: Int, val way: Way) : StopAt

    /** The plans of an intention among which the next step is sought. */
    enum class Way {
        /** The current plan and the plans that wait for it, but not the plans for its goals. */
        OVER,

        /** All plans. */
        INTO,

        /** The plans that wait for the current plan. */
        OUT,
    }
}

/**
 * A breakpoint.
 *
 * @property file the file as the breakpoint's owner names it
 * @property wanted the line for which the owner asked
 * @property line the line before which the agent is paused: [wanted], or a later line with a step; null if there is none
 * @property refusal the reason, in words, why [line] is null; null if there is a line
 */
data class Breakpoint(val file: String, val wanted: Int, val line: Int?, val refusal: String?)

/** An owner of breakpoints that is told when a reload has changed them. */
interface BreakpointOwner {
    /** Called by the agent's thread when a reload has moved or removed breakpoints of this owner. Must not wait. */
    fun breakpointsChanged()
}

enum class PausePhase { RUNNING, MAKING_SAFE, PAUSED }

/**
 * Whether an agent runs or is paused, and why. Immutable.
 *
 * @property why the reason why the agent is paused, in words; null if it is not paused
 * @property boards the result of making the boards safe, a sentence for each board; empty while the agent runs
 * @property place the line of the next step, or of the chosen plan; null if no line is known
 * @property intention the number of the intention that a person wants to see first; null if no intention is special
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
