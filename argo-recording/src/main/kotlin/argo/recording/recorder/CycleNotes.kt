package argo.recording.recorder

import argo.observing.IssuedCommand
import argo.recording.Call
import argo.recording.CallFailure
import argo.recording.Cycle
import argo.recording.End
import argo.recording.FilterChange
import argo.recording.GivenOrder
import argo.recording.Input
import argo.recording.Mail
import argo.recording.PerceivedSnapshot
import argo.recording.PerceptChange
import argo.recording.Refusal
import argo.recording.Sent
import argo.recording.agent.CourseNote
import argo.recording.agent.laterText
import argo.recording.agent.literalText
import argo.recording.agent.textOf
import jason.asSyntax.Literal
import jason.asSyntax.Term

/** Collects an agent's input in a cycle. Only for the agent's thread and, after the cycle, for the thread that stores the cycle. */
internal class CycleNotes(val ns: Long) {
    var counters: List<Int>? = null
    var events: List<String> = emptyList()
    var eventPlaces: Map<Int, Int> = emptyMap()
    val snapshots = ArrayList<PerceivedSnapshot>()
    var percepts: PerceptNote? = null
    var isOfSeveralBoards = false
    var critical: List<String> = emptyList()
    val mail = ArrayList<Mail>()
    val ends = ArrayList<End>()
    val sleep = StringBuilder()
    val calls = ArrayList<CallNote>()
    val filters = ArrayList<FilterChange>()
    var isChangedOutside = false
    var isHeld = false
    var orders: List<GivenOrder> = emptyList()

    /** The reason why no replay can repeat this cycle; null if none is known. */
    var refusal: Refusal? = null
        private set

    var underWay: CallNote? = null

    /** True if the cycle begins with work from earlier cycles. If work only removes an ended intention, no other field shows it. */
    var isAtWork = false

    var isSending = false

    /**
     * Notes that no replay can repeat this cycle, because of [why]. If [isOfProject] is true, a replay that carries out the project's code
     * can repeat the cycle.
     */
    fun refuse(why: String, isOfProject: Boolean = true) {
        val known = refusal
        if (known == null || known.isOfProject && !isOfProject) refusal = Refusal(why, isOfProject)
    }

    fun end() = calls.forEach(CallNote::end)

    fun isNothing() = events.isEmpty() && percepts == null && mail.isEmpty() && ends.isEmpty() && calls.isEmpty() && critical.isEmpty() &&
        filters.isEmpty() && orders.isEmpty() && !isChangedOutside && !isHeld && refusal == null

    /** Returns the agent's input. Call this function after the cycle. */
    fun input() = Input(
        events, snapshots, percepts?.change(), isOfSeveralBoards, critical,
        mail, ends, "$sleep", calls.map(CallNote::call), filters, isChangedOutside, eventPlaces, orders, isHeld,
    )
}

/**
 * The change from the previous percepts, see [PerceptChange]. Jason believes copies of the literals, which share sets and maps with them.
 */
internal class PerceptNote(private val keep: Int, private val now: List<Literal>, private val keepLast: Int) {
    private val texts = laterText(now) { now.map(::literalText) }

    val size: Int get() = now.size

    fun change() = PerceptChange(keep, texts(), keepLast)
}

/** A recorded cycle. The thread that stores the cycle makes its texts. Immutable. */
internal class CycleNote(
    val index: Long,
    val number: Int,
    private val notes: CycleNotes,
    private val course: CourseNote,
    private val isEnding: Boolean,
    private val missesPrints: Boolean,
) {
    val ns: Long = notes.ns

    val percepts: Int get() = notes.percepts?.size ?: 0
    val snapshots: List<PerceivedSnapshot> get() = notes.snapshots

    fun cycle() = Cycle(index, number, ns, notes.counters, notes.input(), course.course(), isEnding, missesPrints, notes.refusal)
}

/**
 * A call with a result that becomes known later, perhaps in parts during the cycle. [args] are the arguments of the action or function.
 * Jason has copied them, but the project's code may change them.
 */
internal class CallNote(val name: String, args: Array<Term>, val isOfProject: Boolean) {
    private val args: () -> List<String> = laterText(args.asList(), isOfProject) { args.map(::textOf) }
    private val answers = ArrayList<Map<Int, String>>()
    private val commands = ArrayList<Sent>()
    private var hasEnded = false
    var value: String? = null
    var isBacktracking = false
    var failure: CallFailure? = null
    var number: Int? = null

    /** Adds another answer to the call. If a loop finds the answer in a later cycle, ignores the answer and returns false. */
    fun answered(answer: Map<Int, String>): Boolean = !hasEnded && answers.add(answer)

    fun sent(command: IssuedCommand) {
        commands += Sent(command.number, command.port, command.text)
    }

    fun end() {
        hasEnded = true
    }

    fun call() = Call(name, args(), answers, isBacktracking, failure, number, commands, isOfProject, value)
}
