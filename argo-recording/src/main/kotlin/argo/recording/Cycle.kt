package argo.recording

import argo.filters.matching.withoutSmoothed
import kotlinx.serialization.Serializable

/** A reasoning cycle of an agent, with its input and its course. Immutable. */
@Serializable
data class Cycle(
    @Holds("counts the recorded cycles of the agent, from 1; cycles in which nothing happened are not recorded")
    val index: Long,
    @Holds("Jason's number of the cycle")
    val number: Int,
    @Holds("when it began, in ns of the agent's clock")
    val ns: Long,
    @Holds("the values of Jason's counters, which all agents of a program share; missing: those after this agent's last cycle")
    val counters: List<Int>? = null,
    @Holds("the agent's input")
    val input: Input = Input(),
    @Holds("the agent's course")
    val course: Course = Course(),
    @Holds("whether the agent was being stopped: Jason may have ended the cycle anywhere")
    val isEnding: Boolean = false,
    @Holds("whether printed lines may be missing, as Java was ending")
    val missesPrints: Boolean = false,
    @Holds("the reason why no replay can have this cycle, so that each ends before it; missing: a replay can")
    val refusal: Refusal? = null,
)

/** The reason why a cycle cannot be replayed. */
@Serializable
data class Refusal(
    @Holds("the reason, a sentence for a person")
    val why: String,
    @Holds("whether the reason is the project's own code: replay --check carries that out again, and goes on")
    val isOfProject: Boolean = false,
)

/** The input that entered an agent in a cycle. */
@Serializable
data class Input(
    @Holds("the triggers of events that another thread put into the agent's queue after its last cycle, or in this one before it took them")
    val events: List<String> = emptyList(),
    @Holds("the messages of boards that it perceived, in their order")
    val snapshots: List<PerceivedSnapshot> = emptyList(),
    @Holds("the change of its percepts since its last perception; missing: neither its boards nor its environment had news")
    val percepts: PerceptChange? = null,
    @Holds("whether percept events of several boards took turns")
    val isOfSeveralBoards: Boolean = false,
    @Holds("percepts that meet critical rules, whose events came first")
    val critical: List<String> = emptyList(),
    @Holds("the messages of other agents that had come")
    val mail: List<Mail> = emptyList(),
    @Holds("the ends of operations that it had begun outside of its thread, in the order in which it took them in")
    val ends: List<End> = emptyList(),
    @Holds("the answers, y or n, each time that Jason asked whether the agent may sleep")
    val sleep: String = "",
    @Holds("the calls of internal actions and functions whose results do not follow from the program, in their order")
    val calls: List<Call> = emptyList(),
    @Holds("the filters that it changed to")
    val filters: List<FilterChange> = emptyList(),
    @Holds("whether a thread had changed the number of beliefs since the agent's last cycle")
    val isChangedOutside: Boolean = false,
    @Holds("by their places in the field events: the places in the queue of those behind which the agent had added other events since")
    val eventPlaces: Map<Int, Int> = emptyMap(),
    @Holds("the orders of a person that it was given, carried out or refused at the beginning of the cycle")
    val orders: List<GivenOrder> = emptyList(),
    @Holds("whether it carried out no intention, since it was to stand first, as at a breakpoint")
    val isHeld: Boolean = false,
)

/** Returns the texts of the terms that a replay reads. */
internal fun Input.texts(): Sequence<String> = events.asSequence() + percepts?.now.orEmpty() + mail.asSequence().map { it.content } +
    calls.asSequence().flatMap { it.answers }.flatMap { it.values }

/**
 * The change from one list of percepts to the next. The first [keep] and the last [keepLast] percepts stay. [now] replaces the percepts
 * between them.
 */
@Serializable
data class PerceptChange(
    @Holds("how many at the beginning stay")
    val keep: Int = 0,
    @Holds("the percepts behind those that stay at the beginning, unless take counts them")
    val now: List<String> = emptyList(),
    @Holds("how many at the end stay")
    val keepLast: Int = 0,
    @Holds("how many percepts of the cycle's snapshots, as the filters let them through, come before those that take counts")
    internal val skip: Int = 0,
    @Holds("how many percepts behind those that stay at the beginning are those of the cycle's snapshots; 0: see now")
    internal val take: Int = 0,
    @Holds("the percepts among those that take counts that differ from the board's text, by their place from 0")
    internal val others: Map<Int, String> = emptyMap(),
)

/** A message between agents, as Jason's `.send` makes it. */
@Serializable
data class Mail(
    @Holds("the message's kind, such as tell or achieve")
    val performative: String,
    @Holds("the agent that sent it")
    val sender: String?,
    @Holds("the agent that it is for; everybody: all")
    val receiver: String?,
    @Holds("the content")
    val content: String,
    @Holds("its name")
    val id: String,
    @Holds("the name of the message that it answers")
    val inReplyTo: String? = null,
    @Holds("why it could not be sent; missing: it was sent")
    val failure: String? = null,
    @Holds("the annotations of the failed plan besides error_msg, such as error(receiver_not_found)")
    val errors: List<String> = emptyList(),
)

/** An order to the agent, from a person or from the agent's last run. */
@Serializable
data class GivenOrder(
    @Holds("its kind: believe, forget, begin, drop or reload; of the agent's last run: resume or begin_anew")
    val kind: String,
    @Holds("the belief or goal, as the person wrote it; of the last run: one on each line, those with an event behind + or !")
    val text: String = "",
    @Holds("of a reload: the program, and behind it each file that it includes")
    val files: List<GivenFile> = emptyList(),
    @Holds("of a reload: the addresses of files that the program included before")
    val gone: Set<String> = emptySet(),
)

@Serializable
data class GivenFile(
    @Holds("the address of the file that includes it; empty: the program itself does")
    val within: String,
    @Holds("its name in the directive include; empty: it is the program itself")
    val name: String,
    @Holds("its address, as Jason names it")
    val address: String,
    @Holds("its content")
    val text: String,
)

/** The end of an operation that an agent began outside of its thread. */
@Serializable
data class End(
    @Holds("its number, in the order in which the agent began things; 0: another thread began it")
    val number: Int,
    @Holds("timer, call of an internal action, action of the environment; left by another thread: work if of the project, else thread")
    val kind: String,
    @Holds("why it failed; missing: it did not")
    val failure: CallFailure? = null,
    @Holds("the thread that left the work")
    val thread: String? = null,
    @Holds("the answer of the board to a command; missing: none was asked for, or there is none")
    val answer: String? = null,
)

/** The failure of a call. */
@Serializable
data class CallFailure(
    @Holds("the atom of the annotation error(…) of the failed plan")
    val error: String,
    @Holds("the message for a person")
    val message: String,
)

/** A call of an internal action, or of an arithmetic function. */
@Serializable
data class Call(
    @Holds("the action or function as the agent writes it")
    val name: String,
    @Holds("its arguments as they were when it was called")
    val args: List<String> = emptyList(),
    @Holds("the texts of the arguments with variables, by their place from 0, for each solution; none: the call was not true")
    val answers: List<Map<Int, String>> = emptyList(),
    @Holds("whether there may have been further solutions")
    val isBacktracking: Boolean = false,
    @Holds("why it failed; missing: it did not")
    val failure: CallFailure? = null,
    @Holds("the number of the operation that it began outside of the agent's thread; the end of that has the same number")
    val number: Int? = null,
    @Holds("the commands that it sent to boards")
    val commands: List<Sent> = emptyList(),
    @Holds("whether the project wrote the action or function: a replay with --check carries it out again")
    val isOfProject: Boolean = false,
    @Holds("the value of a function")
    val value: String? = null,
)

/** A command. */
@Serializable
data class Sent(
    @Holds("counts the agent's commands, from 1")
    val number: Long,
    @Holds("the port of its board")
    val port: String,
    @Holds("what is sent")
    val text: String,
)

/** A change of the filter through which the agent perceives. */
@Serializable
data class FilterChange(
    @Holds("the port of the only board that is perceived so; missing: all boards are")
    val port: String? = null,
    @Holds("the name of the filter; missing: everything is kept")
    val name: String? = null,
    @Holds("the attachment that holds it, in XML")
    val file: String? = null,
)

/** The course of a cycle: the agent's choices, steps and actions. */
@Serializable
data class Course(
    @Holds("the trigger of the event that was chosen")
    val event: String? = null,
    @Holds("the plan that was chosen for it")
    val plan: Place? = null,
    @Holds("the step of an intention that was carried out")
    val step: Step? = null,
    @Holds("the action that the environment was to carry out")
    val action: String? = null,
    @Holds("the messages to other agents")
    val mail: List<Mail> = emptyList(),
    @Holds("the lines that plans printed")
    val printed: List<String> = emptyList(),
    @Holds("how many beliefs the agent had at the end")
    val beliefs: Int = 0,
)

/** The place of a plan in a program. */
@Serializable
data class Place(
    @Holds("the label of the plan")
    val label: String? = null,
    @Holds("the file")
    val file: String? = null,
    @Holds("the line of its trigger")
    val line: Int? = null,
)

/** A step of an intention. */
@Serializable
data class Step(
    @Holds("the number of the intention, counted for each agent")
    val intention: Int,
    @Holds("how many plans the intention consisted of")
    val depth: Int,
    @Holds("the plan that the step is of; missing: the one chosen in this cycle")
    val plan: Place = Place(),
    @Holds("the line of the step in the file of its plan")
    val line: Int? = null,
    @Holds("the step as the plan has it; missing: the plan had ended")
    val text: String? = null,
)

/** A message that the agent perceived from a board. */
@Serializable
data class PerceivedSnapshot(
    @Holds("the port that it came from")
    val port: String,
    @Holds("where it is believed; missing: in the default namespace")
    val namespace: String? = null,
    @Holds("when its last byte came, in ns of the agent's clock")
    val receivedNs: Long,
    @Holds("the percepts as they came off the line")
    val texts: List<String>,
    @Holds("those that the filter let through, and those that stand in for held-back ones; missing: all")
    val kept: List<String>? = null,
) {
    /** The texts that the filter held back. */
    val heldBack: Set<String> get() = heldBack(texts, kept).toSet()
}

/** Returns the [texts] that a filter held back. [kept] are the texts that the filter let through; null if it held none back. */
internal fun heldBack(texts: List<String>, kept: List<String>?): List<String> =
    kept?.let { texts - it.mapTo(HashSet(), ::withoutSmoothed) }.orEmpty()

/** The outcome of a command. */
@Serializable
data class CommandEnd(
    @Holds("the number of the command")
    val number: Long,
    @Holds("the port of its board; missing: see the call that sent it")
    val port: String? = null,
    @Holds("the text, if the computer sent it as a reflex; missing: see the call that sent it")
    val text: String? = null,
    @Holds("when it was issued, in ns of the agent's clock; missing: in the cycle whose call sent it")
    val issuedNs: Long? = null,
    @Holds("when its outcome was known, in ns of the agent's clock")
    val ns: Long,
    @Holds("why it failed; missing: it did not")
    val failure: CallFailure? = null,
)

/** The reflex of a critical rule, and its outcome. */
@Serializable
data class ReflexEnd(
    @Holds("the command")
    val command: String,
    @Holds("the critical rule in words")
    val rule: String,
    @Holds("whether the board watched the rule, and carried its reflex out; otherwise the computer sent it as a command")
    val isByBoard: Boolean,
    @Holds("when its outcome was known, in ns of the agent's clock")
    val ns: Long,
    @Holds("why it failed; missing: it did not")
    val failure: CallFailure? = null,
)

/** The reason why the agent asked to save the recording at this point. */
@Serializable
internal data class Mark(
    @Holds("the argument of argo.record")
    val why: String,
)

/** An agent's beliefs and events just after Jason read its program. The program may draw numbers or read clocks while Jason reads it. */
@Serializable
data class Beginning(val beliefs: List<String>, val events: List<String>)

/**
 * The description of the recorded agent in the metadata of a recording.
 *
 * @property source the name of the attachment with the agent's program
 * @property options the agent's options in the `.mas2j`
 * @property isConditional whether Jason skipped those parts of a cycle that had no work, as its Local infrastructure does
 * @property address the address of the program in Jason's annotations and errors; null if it is not known
 * @property beginning the agent's beliefs and events at the beginning; null if they are not known
 * @property firstLabel Jason's number for the agent's first plan without a name; null if all plans have names
 * @property config Jason's settings for all agents
 */
data class RecordedAgent(
    val name: String,
    val source: String,
    val agentClass: String,
    val archClass: String,
    val beliefBase: String,
    val options: Map<String, String>,
    val isConditional: Boolean,
    val address: String? = null,
    val beginning: Beginning? = null,
    val firstLabel: Int? = null,
    val config: Map<String, String> = emptyMap(),
)
