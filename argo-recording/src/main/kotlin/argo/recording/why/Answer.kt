package argo.recording.why

import kotlinx.serialization.Serializable

/**
 * The reasons for which a [command] was issued.
 *
 * @property cause the step of a plan that issued the command; null if there is none, or if the replay did not see it
 * @property reflex the critical rule, if the command was its reflex; null for other commands
 * @property frame the frame with the percept that began the intention or met the critical rule; null if there is none
 * @property frames all frames that caused the command: [frame] first, then the frames of percepts in contexts and tests
 * @property sent if the root is a message: the message's sending, then the recorded earlier sendings that led to it
 * @property had the counterfactuals: the agent's commands with another percept, which the question names or the search finds
 */
@Serializable
data class Answer(
    val command: RecordedCommand,
    val cause: StepCause? = null,
    val reflex: ReflexCause? = null,
    val frame: Frame? = null,
    val frames: List<Frame> = emptyList(),
    val had: List<Had> = emptyList(),
    val sent: List<SentCause> = emptyList(),
)

/**
 * The sending of a message, in the recording of its sender.
 *
 * @property file the recording
 * @property agent the sender
 * @property seconds the time of the sending, since the first cycle of [file]
 * @property delayMs the ms until the receiver took the message, corrected by the difference of the clocks; null if not known
 * @property clock the difference between the clocks of [file] and of the first recording, in words; null if [file] is the first
 * @property cause the step that sent the message; null if it was not found
 * @property trouble the reason why [cause] is null, in words
 */
@Serializable
data class SentCause(
    val file: String,
    val agent: String,
    val seconds: Double,
    val delayMs: Double? = null,
    val clock: String? = null,
    val cause: StepCause? = null,
    val trouble: String? = null,
)

/**
 * A counterfactual: the agent's commands in a replay with another percept.
 *
 * @property percept the percept that the agent perceives in the replay
 * @property replaced the recorded percept that [percept] replaces; null if [percept] is additional
 * @property from the beginning of the first cycle in which the agent perceives [percept], in seconds
 * @property until the beginning of the command's cycle, the last cycle in which the agent perceives [percept], in seconds
 * @property isSent whether the agent still sends the command
 * @property commands the agent's commands from [from] to [until]
 * @property recorded the recorded commands from [from] to [until]
 * @property isDropped whether the filter drops [percept]; if true, the agent perceives nothing in place of [percept]
 */
@Serializable
data class Had(
    val percept: String,
    val replaced: String? = null,
    val from: Double,
    val until: Double,
    val isSent: Boolean,
    val commands: List<String>,
    val recorded: List<String>,
    val isDropped: Boolean = false,
)

/**
 * The reasons for which a command was not issued.
 *
 * @property command the command in the words of the question
 * @property seconds the end of the searched time, in seconds since the first cycle
 * @property plans the plans that would issue the command, in the order of the program
 */
@Serializable
data class NotAnswer(val agent: String, val command: String, val seconds: Double, val plans: List<UnchosenPlan>)

/**
 * A plan that would have issued a command.
 *
 * @property context the plan's context; null if it has none
 * @property step the step that issues the command; for a plan in [above], the step that leads to the plan below
 * @property stepLine the line of [step]
 * @property event the last event for which the plan was relevant; null if there was none
 * @property seconds the beginning of the cycle in which the agent chose [event], since the first cycle
 * @property conditions the parts of the plan's context at [event], up to the first that failed
 * @property chosen the plan that the agent chose instead; null if it chose none
 * @property missed percepts that did not reach the agent, although they would have triggered the plan or made its context true
 * @property above if [event] is null, the plans that would have caused an event for this plan
 */
@Serializable
data class UnchosenPlan(
    val place: argo.recording.Place,
    val trigger: String,
    val context: String? = null,
    val step: String,
    val stepLine: Int? = null,
    val event: String? = null,
    val seconds: Double? = null,
    val cause: Cause? = null,
    val verdict: Verdict,
    val conditions: List<Condition> = emptyList(),
    val chosen: PlanCause? = null,
    val missed: List<Missed> = emptyList(),
    val above: List<UnchosenPlan> = emptyList(),
)

/** The outcome of a plan. */
enum class Verdict {
    /** No event came for which the plan is relevant. */
    NO_EVENT,

    /** A part of the plan's context was not true. */
    NOT_APPLICABLE,

    /** The plan was applicable, but the agent chose another applicable plan. */
    NOT_CHOSEN,

    /** The agent chose the plan, but its intention did not reach the step. The intention waits, has failed, or was dropped. */
    NOT_REACHED,

    /** The agent chose the plan and issued the command, but at another time. */
    ISSUED,
}

/**
 * A percept that a board sent but the agent did not perceive.
 *
 * @property rule the reason why the filter dropped the percept, if the recording contains the filter
 */
@Serializable
data class Missed(val text: String, val frame: Frame, val rule: String? = null)
