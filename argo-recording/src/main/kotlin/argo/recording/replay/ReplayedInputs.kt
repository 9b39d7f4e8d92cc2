package argo.recording.replay

import argo.boundary.Boundary
import argo.boundary.InternalCall
import argo.boundary.Perception
import argo.observing.CommandFailure
import argo.recording.Call
import argo.recording.CallFailure
import argo.recording.Cycle
import argo.recording.End
import argo.recording.KeyFrame
import argo.recording.Mail
import argo.recording.agent.Begun
import argo.recording.agent.CallWatch
import argo.recording.agent.Counters
import argo.recording.agent.CourseWatch
import argo.recording.agent.Keeper
import argo.recording.agent.ProgramParts
import argo.recording.agent.UnknownCodeException
import argo.recording.agent.UnrecordableTerm
import argo.recording.agent.WatchedCode
import argo.recording.agent.WatchedKind
import argo.recording.agent.bound
import argo.recording.agent.callFailure
import argo.recording.agent.complete
import argo.recording.agent.contentOf
import argo.recording.agent.evaluationFailed
import argo.recording.agent.literalOf
import argo.recording.agent.literalText
import argo.recording.agent.mailOf
import argo.recording.agent.termOf
import argo.recording.agent.textOf
import argo.recording.agent.triggerOf
import argo.recording.agent.watch
import jason.JasonException
import jason.asSemantics.ActionExec
import jason.asSemantics.Message
import jason.asSemantics.TransitionSystem
import jason.asSemantics.Unifier
import jason.asSyntax.ASSyntax
import jason.asSyntax.Literal
import jason.asSyntax.Term
import jason.util.RunnableSerializable
import java.util.concurrent.Callable
import java.util.concurrent.Delayed
import java.util.concurrent.FutureTask
import java.util.concurrent.LinkedBlockingQueue
import java.util.concurrent.ScheduledFuture
import java.util.concurrent.TimeUnit

/** Takes what differs from a recording: the kind, what was recorded, what came now, and the cause if that is known. */
internal typealias DifferenceSink = (what: String, recorded: String?, now: String?, cause: String?) -> Unit

/**
 * Gives an agent what was recorded, cycle by cycle, and notes where it does something else than it did.
 *
 * @param found takes what differs
 * @param isChecking whether the project's own actions and functions are carried out again, to compare what they give
 */
internal open class ReplayedInputs(
    private val found: DifferenceSink,
    private val isChecking: Boolean = false,
) : Boundary, Keeper, CallWatch {
    private val begun = Begun()
    private val left = LinkedBlockingQueue<Runnable>()
    private val ids = HashMap<String, String>() // of messages: as recorded, and now
    private var percepts: List<Literal> = emptyList()
    private var calls: MutableList<Call> = ArrayList()
    private val taken = ArrayList<Call>()
    private val known = HashMap<String, Literal>()
    private var sent: MutableList<Mail> = ArrayList()
    private var sleep = ArrayDeque<Char>()
    private var counters: List<Int> = emptyList() // behind the agent's last cycle
    private var underWay: Call? = null
    private var isAsking = false

    /** The agent's transition system. There from [begin] on. */
    protected lateinit var ts: TransitionSystem
        private set

    /** The cycle that is replayed. */
    lateinit var cycle: Cycle
        private set

    lateinit var course: CourseWatch
        private set

    private lateinit var code: WatchedCode

    /** The recorded calls that the agent has made again in this cycle, in its order. */
    val repeated: List<Call> get() = taken

    /** Calls of the project's own actions and functions so far, for the likely cause of a difference. */
    val projectCalls = LinkedHashSet<String>()

    /** The agent of [ts] has been read, and begins as its program has it, or as it was at [start]. */
    fun begin(ts: TransitionSystem, start: KeyFrame? = null) {
        this.ts = ts
        course = CourseWatch(ts)
        val program = ProgramParts(ts.ag)
        code = guarded(ts, this) { watch(ts) }
        if (start == null) return
        val timers = Restoration(start, ts, program, code, course).restore()
        percepts = start.perceived.map(::perceptOf)
        restore(start.begun, timers.mapValues { (_, work) -> { _: End -> work.call() } })
    }

    /** The agent had begun [last] things outside of its thread, of which [open] have not ended. */
    protected open fun restore(last: Int, open: Map<Int, (End) -> Unit>) = begun.restore(last, open)

    /** The next cycle is [cycle]. */
    fun next(cycle: Cycle) {
        this.cycle = cycle
        Counters.write(cycle.counters ?: counters) // another agent may have been replayed since
        calls = cycle.input.calls.toMutableList()
        taken.clear()
        sent = cycle.course.mail.toMutableList()
        sleep = ArrayDeque(cycle.input.sleep.toList())
        cycle.input.events.forEach { text -> reading("events") { triggerOf(text) }?.let(ts.c::addExternalEv) }
    }

    override fun cycleStarting(ts: TransitionSystem) {
        course.begin()
        guarded(ts, this) { code.apply { watchAdded() } }
        Keeper.within(this) { carryOut(cycle.input.ends) }
        Keeper.begin(this, ts)
    }

    override fun perceive(live: () -> Perception): Perception {
        val change = cycle.input.percepts ?: return Perception(null)
        percepts = reading("percepts") { change.appliedTo(percepts, ::perceptOf) } ?: return Perception(null)
        val waiting = if (cycle.input.isOfSeveralBoards) ts.c.events.size else null
        return Perception(perceived(percepts).toMutableList(), waiting, hasNamespaces = true)
    }

    /** The literal of a percept, read once for each text, as when it was perceived: Jason copies what it believes. */
    private fun perceptOf(text: String): Literal {
        if (known.size >= MAX_KNOWN) known.clear()
        return known.getOrPut(text) { literalOf(text) }
    }

    /** What the agent perceives where it was recorded to perceive [percepts]. */
    protected open fun perceived(percepts: List<Literal>): List<Literal> = percepts

    override fun newlyCritical(live: () -> List<Literal>) = cycle.input.critical.map(::literalOf)

    override fun boardOf(percept: Literal, live: () -> String?) = cycle.input.boards[literalText(percept)]

    override fun takeMail(live: () -> Unit) {
        cycle.input.mail.forEach { mail -> reading("message of ${mail.sender}") { messageOf(mail) }?.let(ts.c::addMsg) }
        Keeper.current = this
    }

    /** Carries out what had ended that the agent had begun. */
    protected open fun carryOut(ends: List<End>) = ends.forEach(::carryOut)

    /** The agent begins something of the kind that [End.kind] names; [what] describes it, [complete] is for its end. Returns its number. */
    protected open fun begin(kind: String, what: String, delayNs: Long, complete: (End) -> Unit): Int = begun.begin(complete)

    /** What a call gives that was not recorded, of Jason or ARGO. */
    protected open fun unrecorded(call: InternalCall): Any = false

    /** Does [work], which only asks: its calls give what was recorded in this cycle, and count as none. For the agent's thread. */
    fun <T> asking(work: () -> T): T {
        val around = isAsking
        val counters = Counters.read()
        isAsking = true
        try {
            return work()
        } finally {
            isAsking = around
            Counters.write(counters)
        }
    }

    private fun messageOf(mail: Mail): Message {
        val content = contentOf(mail.content, ts.ag)
        return Message(mail.performative, mail.sender, mail.receiver, content, mail.id).apply {
            inReplyTo = mail.inReplyTo?.let { ids[it] ?: it }
        }
    }

    private fun carryOut(end: End) {
        if (end.number != 0) {
            if (!begun.carryOut(end)) found("end of a ${end.kind}", "number ${end.number}", null, null)
            return
        }
        val work = left.poll(THREAD_PATIENCE_S, TimeUnit.SECONDS)
        if (work != null) return work.run()
        found("work of thread ${end.thread}", "in this cycle", null, "the project's threads are not recorded")
    }

    override fun call(call: InternalCall, live: () -> Any): Any = call(call, WatchedKind.OUTSIDE) { live() }

    override fun call(call: InternalCall, code: WatchedKind, live: (Unifier) -> Any): Any {
        val recorded = take(call.name, call.args.map(::textOf))
        if (recorded == null) {
            if (isAsking) return false
            foundCall(normal("$call"))
            return if (code == WatchedKind.OUTSIDE || !isChecking) unrecorded(call) else live(call.un)
        }
        if (isAsking) return if (recorded.failure != null || call.suspend != null) false else answer(recorded, call)
        if (code != WatchedKind.OUTSIDE) projectCalls += call.name
        if (code == WatchedKind.SUSPENDING) return if (isChecking) live(call.un) else unresumed(call)
        if (code == WatchedKind.PROJECT && isChecking) compare(recorded, call, live)
        recorded.failure?.let { throw JasonException(it.message, if (it.error.isEmpty()) null else termOf(it.error)) }
        return reading("result of ${call.name}") { answer(recorded, call) } ?: false
    }

    /** What [read] makes of recorded texts; null: one of them is of a term that no recording can hold. */
    private fun <T : Any> reading(what: String, read: () -> T): T? = try {
        read()
    } catch (refused: UnrecordableTerm) {
        null.also { found("the $what", refused.message, null, "a recording cannot hold ${refused.message}, so the replay ends here") }
    }

    private fun unresumed(call: InternalCall): Any {
        found(
            "call", null, normal("$call"),
            "the project's action ${call.name} has a thread resume its intention, and only --check carries it out again",
        )
        return false
    }

    private fun answer(recorded: Call, call: InternalCall): Any {
        if (recorded.isBacktracking) return recorded.answers.map { answer -> call.un.clone().also { bind(call, it, answer) } }.iterator()
        if (recorded.answers.isEmpty()) return false
        val suspend = call.suspend
        if (suspend != null) {
            val around = underWay
            underWay = recorded
            suspend()
            underWay = around
            return true
        }
        bind(call, call.un, recorded.answers.first())
        return true
    }

    /** Carries the project's own action out again, and compares what it gives. */
    private fun compare(recorded: Call, call: InternalCall, live: (Unifier) -> Any) {
        val un = call.un.clone()
        val now = try {
            when (val result = live(un)) {
                is Iterator<*> -> result.asSequence().take(recorded.answers.size).map { bound(call, it as Unifier) }.toList().toString()
                true -> listOf(bound(call, un)).toString()
                else -> NOT_TRUE
            }
        } catch (failed: JasonException) {
            "${callFailure(failed)}"
        } catch (broken: RuntimeException) {
            "$broken"
        }
        val before = recorded.failure?.toString() ?: if (recorded.answers.isEmpty()) NOT_TRUE else recorded.answers.toString()
        if (normal(before) == normal(now)) return
        found("${Difference.RESULT}${recorded.name}", normal(before), normal(now), notRecorded(recorded.name, "action"))
    }

    override fun evaluate(name: String, args: Array<Term>, isOfProject: Boolean, live: () -> Double): Double {
        val call = take(name, args.map(::textOf))
        call?.failure?.let { throw evaluationFailed(it) }
        val recorded = call?.value
        if (recorded == null) {
            if (!isAsking) foundCall("$name(${args.joinToString(",")})")
            return if (isOfProject && !isChecking) Double.NaN else live()
        }
        if (isOfProject && !isAsking) projectCalls += name
        if (isOfProject && !isAsking && isChecking) {
            val now = "${live()}"
            if (now != recorded) found("${Difference.RESULT}$name", recorded, now, notRecorded(name, "function"))
        }
        return recorded.toDouble()
    }

    /** The agent makes a call [now] that was not recorded; where Jason ended the cycle it might have followed. */
    private fun foundCall(now: String) {
        if (!cycle.isEnding) found("call", calls.firstOrNull()?.let(::described), now, null)
    }

    private fun notRecorded(name: String, kind: String) =
        "the project's $kind $name gives another result for the same arguments: it reads a clock, chance, a file or what a thread changes"

    /** The recorded call of [name] with [args]; it is taken once. */
    private fun take(name: String, args: List<String>): Call? {
        fun isAsked(it: Call) = it.name == name && it.args.map(::normal) == args.map(::normal)
        if (isAsking) return cycle.input.calls.find(::isAsked)
        val index = calls.indexOfFirst(::isAsked)
        return if (index < 0) null else calls.removeAt(index).also(taken::add)
    }

    override fun suspended(complete: (CommandFailure?) -> Unit): (CommandFailure?) -> Unit {
        val number = begin("call", underWay?.let(::described).orEmpty(), 0) { end -> complete(end.failure?.let(::Failed)) }
        if (underWay?.number != number) found("number of a call", "${underWay?.number}", "$number", null)
        return {}
    }

    private class Failed(failure: CallFailure) : CommandFailure {
        override val error = failure.error
        override val cause = failure.message
    }

    override fun <V> timer(work: Callable<V>, delayNs: Long, schedule: (Callable<V>) -> ScheduledFuture<V>): ScheduledFuture<V> {
        begin("timer", "$delayNs", delayNs) { work.call() }
        return Never(work)
    }

    override fun left(work: RunnableSerializable) {
        left += work
    }

    override fun act(action: ActionExec, live: (ActionExec) -> Unit) {
        begin("action", "${action.actionTerm}", 0) { end ->
            complete(action, end)
            ts.c.addFeedbackAction(action)
        }
    }

    override fun send(message: Message, live: () -> Unit) = sending(message)

    override fun broadcast(message: Message, live: () -> Unit) = sending(message.clone().apply { receiver = receiver ?: "everybody" })

    private fun sending(message: Message) {
        val recorded = sent.removeFirstOrNull()
        recorded?.let { ids[it.id] = message.msgId }
        course.sent(mailOf(message, recorded?.failure))
        recorded?.failure?.let { throw JasonException(it) }
    }

    override fun canSleep(live: () -> Boolean): Boolean = sleep.removeFirstOrNull() != 'n'

    override fun ruleApplied() {
        if (::course.isInitialized && Keeper.current === this) course.ruleApplied()
    }

    override fun cycleFinished() {
        Keeper.current = null
        counters = Counters.read()
        calls.firstOrNull()?.let { found("call", described(it), null, null) }
    }

    private fun described(call: Call) = normal("${call.name}(${call.args.joinToString(",")})")

    /** A timer whose time is given by the recording. */
    private class Never<V>(work: Callable<V>) : FutureTask<V>(work), ScheduledFuture<V> {
        override fun getDelay(unit: TimeUnit) = Long.MAX_VALUE

        override fun compareTo(other: Delayed) = 0
    }

    private companion object {
        /** How long work of a thread of the project's is waited for that was left in the recorded cycle. */
        const val THREAD_PATIENCE_S = 5L
        const val MAX_KNOWN = 4096
        const val NOT_TRUE = "false"
    }
}

/** Binds the variables in the arguments of [call] to what was recorded as its [answer]. */
internal fun bind(call: InternalCall, un: Unifier, answer: Map<Int, String>) = answer.forEach { (place, text) ->
    call.args.getOrNull(place)?.let { un.unifies(it, termOf(text)) }
}

/**
 * Has [asked] asked about the code of the agent of [ts], which [watch] does, also what it looks up later.
 * @throws RecordingException if it has code that cannot be watched
 */
internal fun guarded(ts: TransitionSystem, asked: CallWatch, watch: () -> WatchedCode): WatchedCode = try {
    watch().also { (ts.ag as GuardedAgent).begin(it, asked) }
} catch (unknown: UnknownCodeException) {
    throw RecordingException("the recording of agent ${ts.agArch.agName} cannot be replayed: ${unknown.message}")
}
