package argo.recording

import kotlinx.serialization.Serializable

/**
 * A reasoning cycle of an agent: what entered it, and what came of that. Nothing of it changes.
 *
 * @property index counts the recorded cycles of an agent, from 1; cycles in which nothing happened are not recorded
 * @property number Jason's number of the cycle
 * @property ns when it began, in ns of the agent's clock
 * @property counters where Jason's counters stood, which all agents of a program share; null: where this agent's last cycle left them
 */
@Serializable
data class Cycle(
    val index: Long,
    val number: Int,
    val ns: Long,
    val counters: List<Int>? = null,
    val input: Input = Input(),
    val course: Course = Course(),
)

/**
 * What entered an agent in a cycle.
 *
 * @property events triggers that another thread had put into its event queue since its last cycle
 * @property percepts how what it perceived differs from what it perceived before; null: its boards and its environment had nothing for it
 * @property isOfSeveralBoards whether percept events of several boards took turns
 * @property boards the percepts of events that took turns, each with the port of its board
 * @property critical percepts that meet critical rules, whose events came first
 * @property mail the messages that had come
 * @property ends what had ended that it had begun outside of its thread, in the order in which it was carried out
 * @property sleep whether it might have slept, each time that Jason asked: `y` or `n`
 * @property calls the calls of internal actions and functions whose results are not in the program, in their order
 */
@Serializable
data class Input(
    val events: List<String> = emptyList(),
    val percepts: PerceptChange? = null,
    val isOfSeveralBoards: Boolean = false,
    val boards: Map<String, String> = emptyMap(),
    val critical: List<String> = emptyList(),
    val mail: List<Mail> = emptyList(),
    val ends: List<End> = emptyList(),
    val sleep: String = "",
    val calls: List<Call> = emptyList(),
)

/**
 * How a list of percepts differs from the one before: the first [keep] and the last [keepLast] stay, [now] stands between them.
 */
@Serializable
data class PerceptChange(val keep: Int = 0, val now: List<String> = emptyList(), val keepLast: Int = 0)

/** A message between agents: what is said and to whom, as of Jason's internal action `.send`. */
@Serializable
data class Mail(
    val performative: String,
    val sender: String?,
    val receiver: String?,
    val content: String,
    val id: String,
    val inReplyTo: String? = null,
    val failure: String? = null,
)

/**
 * Something has ended that an agent began outside of its thread.
 *
 * @property number its number, in the order in which the agent began things; 0: another thread began it
 * @property kind `timer`, `call` of an internal action, `action` of the environment, or `thread`: work that another thread left
 * @property failure why it failed; null: it did not
 * @property thread the thread that left the work
 */
@Serializable
data class End(val number: Int, val kind: String, val failure: CallFailure? = null, val thread: String? = null)

/**
 * Why a call failed: the atom of the annotation `error(…)`, and the message for a person.
 */
@Serializable
data class CallFailure(val error: String, val message: String)

/**
 * A call of an internal action, or of an arithmetic function.
 *
 * @property name the action as the agent writes it
 * @property args its arguments as they were when it was called
 * @property answers the arguments with the values that were found for their variables, once for each way; of a function its value
 * @property isBacktracking whether there may have been other ways
 * @property failure why it failed; null: it did not
 * @property number what it began outside of the agent's thread; see [End.number]
 * @property commands what it had sent to boards
 * @property isOfProject whether the project wrote the action or function: a replay carries it out again
 */
@Serializable
data class Call(
    val name: String,
    val args: List<String> = emptyList(),
    val answers: List<List<String>> = emptyList(),
    val isBacktracking: Boolean = false,
    val failure: CallFailure? = null,
    val number: Int? = null,
    val commands: List<Sent> = emptyList(),
    val isOfProject: Boolean = false,
)

/** A command: its number, as of [argo.observing.IssuedCommand], the port of its board, and its text. */
@Serializable
data class Sent(val number: Long, val port: String, val text: String)

/**
 * What came of a cycle.
 *
 * @property event the trigger of the event that was chosen
 * @property plan the plan that was chosen for it
 * @property step the step of an intention that was carried out
 * @property action the action that the environment was to carry out
 * @property mail the messages to other agents
 * @property printed the lines that plans printed
 * @property beliefs how many beliefs the agent had at the end
 */
@Serializable
data class Course(
    val event: String? = null,
    val plan: Place? = null,
    val step: Step? = null,
    val action: String? = null,
    val mail: List<Mail> = emptyList(),
    val printed: List<String> = emptyList(),
    val beliefs: Int = 0,
)

/** Where a plan stands. */
@Serializable
data class Place(val label: String?, val file: String?, val line: Int?)

/**
 * A step of an intention.
 *
 * @property intention its number, counted for each agent
 * @property depth how many plans the intention consisted of
 * @property plan the plan that the step is of
 * @property line the line of the step in [Place.file]
 * @property text the step as the plan has it; null: the plan had ended
 */
@Serializable
data class Step(val intention: Int, val depth: Int, val plan: Place, val line: Int?, val text: String?)

/**
 * A message of a board that the agent perceived.
 *
 * @property port the port that it came from
 * @property namespace where it is believed; null: in the default namespace
 * @property receivedNs when its last byte came, in ns of the agent's clock
 * @property texts the percepts as they came off the line
 * @property kept those that the filter let through, and those that stand in for held-back ones; null: all
 */
@Serializable
data class PerceivedSnapshot(
    val port: String,
    val namespace: String? = null,
    val receivedNs: Long,
    val texts: List<String>,
    val kept: List<String>? = null,
)

/** What became of a command, and when, in ns of the agent's clock. */
@Serializable
data class CommandEnd(val number: Long, val port: String, val text: String, val ns: Long, val failure: CallFailure? = null)

/**
 * The agent of a recording, in its metadata.
 *
 * @property source the name of the attachment that holds its program
 * @property options its options in the `.mas2j`
 * @property isConditional whether Jason left out parts of a cycle that had nothing to do, as its Local infrastructure does
 */
data class RecordedAgent(
    val name: String,
    val source: String,
    val agentClass: String,
    val archClass: String,
    val beliefBase: String,
    val options: Map<String, String>,
    val isConditional: Boolean,
)
