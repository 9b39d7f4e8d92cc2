package argo.recording.why

import kotlinx.serialization.Serializable

/**
 * The reasons for which a command was issued.
 *
 * @property command the command
 * @property cause the step of a plan that issued it; null: no plan issued it, or the replay did not see the step
 * @property reflex the critical rule whose reflex it was; null: it was no reflex
 * @property frame the frame at the root: its percept began the intention, or met the critical rule; null: there is none
 * @property frames all frames that caused the command, [frame] first: also the frames of percepts in contexts and tests
 * @property had the counterfactuals: the agent's commands with another percept, if the question has one, or the search found one
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
 * A counterfactual: the agent's commands in a replay with another percept.
 *
 * @property percept the percept that the agent perceives in the replay
 * @property replaced the recorded percept that it replaces; null: it is additional
 * @property from the beginning of the first cycle in which the agent perceives it, in seconds
 * @property until the beginning of the last cycle in which the agent perceives it, which is the cycle of the command, in seconds
 * @property isSent whether the agent sends the command all the same
 * @property commands the commands that the agent sends in that time
 * @property recorded the recorded commands in that time
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
 * The reasons for which a command was not issued.
 *
 * @property command the command in the words of the question
 * @property seconds the end of the time that was searched, since the first cycle
 * @property plans the plans that would issue it, in the order of the program
 */
@Serializable
data class NotAnswer(val agent: String, val command: String, val seconds: Double, val plans: List<UnchosenPlan>)

/**
 * A plan that would have issued a command.
 *
 * @property place the plan's place in the program
 * @property trigger the plan's trigger
 * @property context the plan's context; null: it has none
 * @property step its step that issues the command or, of a plan [above], that leads to it
 * @property stepLine the line of that step
 * @property event the last event for which it was relevant; null: there was none
 * @property seconds the beginning of the cycle in which the agent chose that event, since the first cycle
 * @property cause the cause of the event
 * @property verdict the fate of the plan
 * @property conditions the parts of the plan's context at that event, up to the part that failed
 * @property chosen the plan that the agent chose in its place; null: none
 * @property missed the percepts that would have triggered it, or made its context true, but did not reach the agent
 * @property above if there was no event, the plans that would have made it
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

/** The fate of a plan. */
enum class Verdict {
    /** No event came for which the plan is relevant. */
    NO_EVENT,

    /** A part of the plan's context was not true. */
    NOT_APPLICABLE,

    /** The plan was applicable, but the agent chose another applicable plan. */
    NOT_CHOSEN,

    /** The plan was chosen, but its intention did not reach the step: the intention waits, has failed, or was dropped. */
    NOT_REACHED,

    /** The plan was chosen and issued the command, but at another time. */
    ISSUED,
}

/**
 * A percept that a board sent and that the agent did not perceive.
 *
 * @property text the percept
 * @property frame the frame that it stood in
 * @property rule the reason why the filter dropped it, if the recording has the filter
 */
@Serializable
data class Missed(val text: String, val frame: Frame, val rule: String? = null)
