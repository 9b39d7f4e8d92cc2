package argo.recording.why

import kotlinx.serialization.Serializable

/**
 * Why a command was issued.
 *
 * @property command the command
 * @property cause the step of a plan that issued it; null: no plan did, or it was not seen
 * @property reflex the critical rule whose reflex it was; null: it was none
 * @property frame the frame at the root: its percept began the intention, or met the critical rule; null: there is none
 * @property frames all frames that the command came of, [frame] first: also those of percepts in contexts and tests
 * @property had what the agent would have done with another percept, if that was asked or found
 */
@Serializable
data class Answer(
    val command: RecordedCommand,
    val cause: StepCause? = null,
    val reflex: ReflexCause? = null,
    val frame: Frame? = null,
    val frames: List<Frame> = emptyList(),
    val had: List<Had> = emptyList(),
)

/**
 * What the agent does in a replay in which it perceives something else.
 *
 * @property percept what it perceives
 * @property replaced the percept that it stands for; null: it comes besides
 * @property from when the first cycle began in which it is perceived, in seconds
 * @property until when the last cycle began in which it is, which is that of the command
 * @property isSent whether the command is sent all the same
 * @property commands what the agent sends in that time
 * @property recorded what it had sent in that time
 * @property isDropped whether the filter drops [percept], so that the agent perceives nothing in its place
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
 * Why a command was not issued.
 *
 * @property command the command that was asked about, as it was asked
 * @property seconds until when was looked, since the first cycle
 * @property plans the plans that would issue it, in the order of the program
 */
@Serializable
data class NotAnswer(val agent: String, val command: String, val seconds: Double, val plans: List<UnchosenPlan>)

/**
 * A plan that would have issued a command.
 *
 * @property place where it stands
 * @property trigger its trigger
 * @property context its context; null: it has none
 * @property step its step that issues the command or, of a plan [above], that leads to it
 * @property stepLine the line of that step
 * @property event the last event for which it was relevant; null: there was none
 * @property seconds when the cycle began in which that event was chosen
 * @property cause what the event came of
 * @property verdict what became of the plan
 * @property conditions the parts of its context then, up to the one that failed
 * @property chosen the plan that was chosen in its place; null: none
 * @property missed percepts that would have begun it, or made its context true, and did not reach the agent
 * @property above if there was no event: the plans that would have made it
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

/** What became of a plan. */
enum class Verdict {
    /** No event came for which it is relevant. */
    NO_EVENT,

    /** A part of its context was not true. */
    NOT_APPLICABLE,

    /** It was applicable, and another plan that was, too, was chosen. */
    NOT_CHOSEN,

    /** It was chosen, but its intention did not come to the step: it waits, has failed, or was dropped. */
    NOT_REACHED,

    /** It was chosen, and issued the command, at another time. */
    ISSUED,
}

/**
 * A percept that a board sent and that the agent did not perceive.
 *
 * @property text the percept
 * @property frame the frame that it stood in
 * @property rule why the filter dropped it, as far as the recording has the filter
 */
@Serializable
data class Missed(val text: String, val frame: Frame, val rule: String? = null)
