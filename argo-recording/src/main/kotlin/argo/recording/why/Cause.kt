package argo.recording.why

import argo.recording.Place
import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable
import kotlinx.serialization.Transient

/** A cause of something in a recording. In JSON its `type` is the name of its kind. Times are in seconds since the first cycle. */
@Serializable
sealed interface Cause {
    /** The causes of this cause. */
    val causes: List<Cause> get() = emptyList()

    /** The length of the longest chain of causes that begins with this one. */
    val depth: Int get() = 1
}

/**
 * A message of a board, with its percepts.
 *
 * @property number counts the messages of boards that the agent perceived, from 1
 * @property port the port by which the message came
 * @property namespace the namespace in which its percepts are believed; null for the default namespace
 * @property seconds the time of the message's last byte
 * @property cycle Jason's number of the cycle in which the agent perceived the message
 * @property texts the percepts as they came off the line
 * @property kept the percepts that the filter let through; null for all
 */
@Serializable
data class Frame(
    val number: Int,
    val port: String,
    val namespace: String? = null,
    val seconds: Double,
    val cycle: Int,
    val texts: List<String>,
    val kept: List<String>? = null,
)

/**
 * The arrival or the departure of a percept.
 *
 * @property isGone true for a departure
 * @property seconds the beginning of the cycle in which the agent noticed the change
 * @property frame the frame that brought the percept, or the first frame without it; null if no board sent it
 * @property from the percept's source if no board sent it: `argo`, which adds the states of ports, or `environment`
 * @property filter why the filter let the percept through; null if there was no filter, or if the reason is not known
 */
@Serializable
@SerialName("percept")
data class PerceptCause(
    val belief: String,
    val isGone: Boolean = false,
    val seconds: Double,
    val frame: Frame? = null,
    val from: String? = null,
    val filter: String? = null,
) : Cause

/**
 * The reflex of a filter's critical rule, sent without a plan.
 *
 * @property isByBoard whether the board watched the rule and carried the reflex out; if false, the computer sent it
 * @property failure the reason why the reflex failed; null if it succeeded
 * @property percept the percept that met the rule; null if the agent perceived no frame with it
 */
@Serializable
@SerialName("reflex")
data class ReflexCause(val rule: String, val isByBoard: Boolean, val failure: String? = null, val percept: PerceptCause? = null) : Cause {
    override val causes get() = listOfNotNull(percept)

    @Transient
    override val depth: Int = 1 + causes.size
}

/**
 * A message of another agent.
 *
 * @property id the message's name
 * @property seconds the beginning of the cycle in which the agent took the message
 */
@Serializable
@SerialName("message")
data class MessageCause(
    val sender: String,
    val performative: String,
    val content: String,
    val seconds: Double,
    val id: String = "",
) : Cause

/**
 * An order to the agent, from a person or from the agent's last run.
 *
 * @property kind `believe`, `forget`, `begin`, `drop` or `reload`; for an order of the last run `resume` or `begin_anew`
 * @property text the belief or goal, as the person wrote it. An order of the last run has one on each line. Empty if there is none
 */
@Serializable
@SerialName("order")
data class OrderCause(val kind: String, val text: String, val seconds: Double) : Cause

/** A goal or a belief that the agent had at its beginning. */
@Serializable
@SerialName("beginning")
data class BeginningCause(val text: String, val file: String? = null, val line: Int? = null) : Cause

/** A cause that the recording does not contain, or that is too far back. [why] is the reason, in words. */
@Serializable
@SerialName("unknown")
data class UnknownCause(val text: String, val why: String) : Cause

/**
 * A step of a plan.
 *
 * @property step the step's text in the plan
 * @property line the step's line in [Place.file] of the plan
 * @property seconds the beginning of the step's cycle
 * @property plan the plan with this step, and the reasons why the agent chose the plan
 * @property tests the tests and conditions in the plan's body that led to the step
 */
@Serializable
@SerialName("step")
data class StepCause(
    val step: String,
    val line: Int? = null,
    val seconds: Double,
    val plan: PlanCause,
    val tests: List<Condition> = emptyList(),
) : Cause {
    override val causes get() = listOf(plan) + tests.flatMap { it.causes }

    @Transient
    override val depth: Int = 1 + causes.maxOf { it.depth }
}

/**
 * The choice of a plan for an event.
 *
 * @property seconds the beginning of the cycle of the choice
 * @property cycle Jason's number of the cycle of the choice
 * @property conditions the parts of the plan's context with their values at the choice
 * @property again how often the plan had called itself before, each time as its last step
 */
@Serializable
@SerialName("plan")
data class PlanCause(
    val place: Place,
    val trigger: String,
    val seconds: Double,
    val cycle: Int,
    val conditions: List<Condition> = emptyList(),
    val event: Cause,
    val again: Int = 0,
) : Cause {
    override val causes get() = listOf(event) + conditions.flatMap { it.causes }

    @Transient
    override val depth: Int = 1 + causes.maxOf { it.depth }
}

/**
 * A part of the context of a plan, or a test in its body.
 *
 * @property text the condition's text in the program
 * @property value [text] with the values of its variables; equal to [text] if it has no variables
 * @property holds whether the condition was true
 * @property causes the causes of the beliefs on which the condition depends
 */
@Serializable
data class Condition(val text: String, val value: String, val holds: Boolean = true, val causes: List<Cause> = emptyList())

/** Returns all percepts among this cause and its own causes. If the root is a percept, it comes first. */
fun Cause.percepts(): List<PerceptCause> = (listOfNotNull(this as? PerceptCause) + causes.flatMap { it.percepts() }).distinct()

/** Returns the frames of all percepts among this cause and its own causes. */
fun Cause.frames(): List<Frame> = percepts().mapNotNull { it.frame }.distinct()

/** Returns the root of this cause: the percept, the message or the program's goal that began the intention. */
fun Cause.root(): Cause = when (this) {
    is StepCause -> plan.root()
    is PlanCause -> event.root()
    is ReflexCause -> percept ?: this
    else -> this
}
