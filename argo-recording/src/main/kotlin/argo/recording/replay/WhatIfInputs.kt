package argo.recording.replay

import argo.boundary.Boundary
import argo.boundary.InternalCall
import argo.boundary.Perception
import argo.observing.CommandFailure
import argo.recording.Call
import argo.recording.CallFailure
import argo.recording.Course
import argo.recording.Cycle
import argo.recording.End
import argo.recording.KeyFrame
import argo.recording.Mail
import argo.recording.agent.CallWatch
import argo.recording.agent.Counters
import argo.recording.agent.CourseWatch
import argo.recording.agent.Keeper
import argo.recording.agent.ProgramParts
import argo.recording.agent.WatchedCode
import argo.recording.agent.WatchedKind
import argo.recording.agent.complete
import argo.recording.agent.contentOf
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
import jason.asSyntax.ListTerm
import jason.asSyntax.Literal
import jason.asSyntax.StringTerm
import jason.asSyntax.Term
import jason.util.RunnableSerializable
import java.util.PriorityQueue
import java.util.concurrent.Callable
import java.util.concurrent.ConcurrentLinkedQueue
import java.util.concurrent.Delayed
import java.util.concurrent.FutureTask
import java.util.concurrent.ScheduledFuture
import java.util.concurrent.TimeUnit
import kotlin.random.Random

/**
 * Gives an agent that may be another than the recorded one what was recorded, at the recorded times, and notes the commands that it sends.
 * What it asks for is answered as the recording answered the same near that time: see [WhatIf].
 *
 * @param isCarryingOut whether the project's own actions and functions are carried out; otherwise they give what they gave
 */
internal class WhatIfInputs(
    private val recorded: RecordedCalls,
    private val senses: Senses,
    private val isCarryingOut: Boolean,
) : Boundary, Keeper, CallWatch {
    private class Due(val ns: Long, val index: Long?, val order: Int, val carryOut: () -> Unit)

    private val due = PriorityQueue(compareBy<Due>({ it.ns }, { it.index ?: 0 }, { it.order }))
    private val left = ConcurrentLinkedQueue<Runnable>()
    private val ids = HashMap<String, String>() // of messages: as recorded, and now
    private val unanswered = ArrayList<Mail>() // recorded ones that it has not sent yet
    private val boards = HashMap<String, String>()
    private val random = Random(0)
    private var begun = 0
    private var sleep = ArrayDeque<Char>()
    private var cycle: Cycle? = null
    private var underWay: RecordedCalls.Made? = null
    private var isCommand = false
    private lateinit var ts: TransitionSystem
    private lateinit var course: CourseWatch
    private lateinit var code: WatchedCode

    /** The time, in ns of the recorded agent's clock. */
    var ns = 0L
        private set

    /** Whether the agent has done step by step what was recorded. */
    var isAsRecorded = true
        private set

    /** The commands that it has sent. */
    val sent = ArrayList<SentCommand>()

    /** When the first thing ends that does not end in a recorded cycle; null: none does. */
    val nextDueNs: Long? get() = due.filter { it.index == null }.minOfOrNull { it.ns }

    /**
     * The agent of [ts] has been read, and begins as its program has it, or as it was at [start].
     *
     * @param recorded the agent as it was recorded, if the one of [ts] has another program
     */
    fun begin(ts: TransitionSystem, start: KeyFrame? = null, recorded: TransitionSystem? = null) {
        this.ts = ts
        course = CourseWatch(ts)
        val program = ProgramParts((recorded ?: ts).ag)
        code = guarded(ts, this) { watch(ts) }
        if (recorded != null) guarded(recorded, this) { watch(recorded) } // the intentions that are under way are of its plans
        if (start != null) beginAt(start, Restoration(start, ts, program, code, course, isProgram = recorded == null).restore())
    }

    private fun beginAt(start: KeyFrame, timers: Map<Int, Callable<*>>) {
        ns = start.ns
        begun = start.begun
        senses.begin(start.perceived.map(::literalOf))
        for ((number, work) in timers.toSortedMap()) {
            val dueNs = start.timers[number] ?: start.ns
            val end = recorded.takeTimer(number, dueNs)
            due += if (end != null) Due(end.ns, end.index, number) { work.call() } else Due(dueNs, null, number) { work.call() }
        }
    }

    /** The next cycle is at [ns], with what entered the agent in the recorded [cycle]; null: one of its own, which nothing enters. */
    fun next(cycle: Cycle?, ns: Long) {
        this.cycle = cycle
        this.ns = ns
        sleep = ArrayDeque(if (isAsRecorded) cycle?.input?.sleep.orEmpty().toList() else emptyList())
        if (cycle == null) return
        if (isAsRecorded) cycle.counters?.let(Counters::write)
        unanswered += cycle.course.mail
        boards += cycle.input.boards
        cycle.input.events.forEach { ts.c.addExternalEv(triggerOf(it)) }
    }

    /** The cycle is over. */
    fun end() {
        val now = course.end().course()
        val before = cycle?.course
        val isSame = before != null && before.event?.let(::normal) == now.event?.let(::normal) && before.action == now.action &&
            before.step?.text?.let(::normal) == now.step?.text?.let(::normal) && before.step?.intention == now.step?.intention
        isAsRecorded = isAsRecorded && isSame
        sleep.clear()
        if (unanswered.size > MOST_UNANSWERED) unanswered.subList(0, MOST_UNANSWERED / 2).clear()
    }

    fun close() = course.close()

    override fun cycleStarting(ts: TransitionSystem) {
        course.begin()
        guarded(ts, this) { code.apply { watchAdded() } }
        Keeper.within(this) {
            while (true) due.peek()?.takeIf(::isDue)?.let { due.remove().carryOut() } ?: break
            while (true) left.poll()?.run() ?: break
        }
        Keeper.begin(this, ts)
    }

    override fun perceive(live: () -> Perception): Perception {
        val percepts = senses.perceive(cycle, ns) ?: return Perception(null)
        val isOfSeveral = cycle?.input?.isOfSeveralBoards == true
        return Perception(percepts.toMutableList(), if (isOfSeveral) ts.c.events.size else null, hasNamespaces = true)
    }

    override fun newlyCritical(live: () -> List<Literal>): List<Literal> = senses.takeNewlyCritical()

    override fun boardOf(percept: Literal, live: () -> String?): String? = boards[literalText(percept)]

    override fun takeMail(live: () -> Unit) {
        cycle?.input?.mail?.forEach { ts.c.addMsg(messageOf(it)) }
        Keeper.current = this
    }

    private fun isDue(one: Due) = cycle.let { now -> if (one.index != null) now != null && one.index <= now.index else one.ns <= ns }

    private fun messageOf(mail: Mail): Message {
        val content = contentOf(mail.content, ts.ag)
        return Message(mail.performative, mail.sender, mail.receiver, content, mail.id).apply {
            inReplyTo = mail.inReplyTo?.let { ids[it] ?: it }
        }
    }

    override fun call(call: InternalCall, live: () -> Any): Any = call(call, WatchedKind.OUTSIDE) { live() }

    override fun call(call: InternalCall, code: WatchedKind, live: (Unifier) -> Any): Any {
        if (code != WatchedKind.OUTSIDE && isCarryingOut) return live(call.un)
        val args = call.args.map(::textOf)
        return when (call.name) {
            ACT -> act(call, recorded.near(ACT, args, cycle?.index, ns))
            in LATE -> recorded.nearest(call.name, args, cycle?.index, ns)?.let { answer(it, call) } ?: false
            in CHANCE -> recorded.nextOf(call.name, args)?.let { answer(it, call) } ?: drawn(call, live)
            else -> (recorded.near(call.name, args, cycle?.index, ns) ?: recorded.firstOf(call.name, args))?.let { answer(it, call) }
                ?: call.name.startsWith("argo.").also { if (it) call.suspend?.invoke() }
        }
    }

    private fun drawn(call: InternalCall, live: (Unifier) -> Any): Any =
        if (call.name == RANDOM && call.args.size == 1) call.un.unifies(call.args[0], ASSyntax.createNumber(random.nextDouble()))
        else live(call.un)

    private fun act(call: InternalCall, before: RecordedCalls.Made?): Any {
        val commands = before?.call?.commands.orEmpty().map { it.port to it.text }.ifEmpty {
            if (before?.call?.failure == null) listOf(portIn(call) to textOfCommand(call.args[0])) else emptyList()
        }
        commands.forEach { (port, text) -> sent += SentCommand(ts.agArch.cycleNumber, ns, port, text, place()) }
        isCommand = true
        try {
            if (before != null) return answer(before, call)
            call.suspend?.invoke()
            return true
        } finally {
            isCommand = false
        }
    }

    private fun portIn(call: InternalCall) = (call.args.getOrNull(1) as? ListTerm)?.filterIsInstance<Literal>()
        ?.find { it.functor == "port" && it.arity == 1 }?.getTerm(0)?.let { if (it is StringTerm) it.string else "$it" }

    private fun textOfCommand(command: Term) = when {
        command is StringTerm -> command.string
        command is Literal && command.ns != Literal.DefaultNS -> "${command.cloneNS(Literal.DefaultNS)}"
        else -> "$command"
    }

    private fun place(): String? = ts.c.selectedIntention?.takeUnless { it.isFinished }?.peek()?.let { means ->
        val step = course.placeOf(means.plan)
        placeOf(step.file, means.currentStep?.srcInfo?.srcLine ?: step.line)
    }

    private fun answer(before: RecordedCalls.Made, call: InternalCall): Any {
        val answered = before.call
        answered.failure?.let { throw JasonException(it.message, if (it.error.isEmpty()) null else termOf(it.error)) }
        if (answered.isBacktracking) return answered.answers.map { answer -> call.un.clone().also { bind(call, it, answer) } }.iterator()
        if (answered.answers.isEmpty()) return false
        val suspend = call.suspend ?: return true.also { bind(call, call.un, answered.answers.first()) }
        val around = underWay
        underWay = before
        suspend()
        underWay = around
        return true
    }

    override fun evaluate(name: String, args: Array<Term>, isOfProject: Boolean, live: () -> Double): Double {
        if (isOfProject && isCarryingOut) return live()
        return recorded.nextOf(name, args.map(::textOf))?.call?.value?.toDouble()
            ?: if (name == "math.random" && args.isEmpty()) random.nextDouble() else if (isOfProject) Double.NaN else live()
    }

    override fun suspended(complete: (CommandFailure?) -> Unit): (CommandFailure?) -> Unit {
        begun++
        val before = underWay
        val end = before?.call?.number?.let(recorded::endOf)
        fun carryOut(failure: CallFailure?) = complete(failure?.let(::Failed))
        when {
            before == null -> endIn(if (isCommand) recorded.usualNs else 0) { carryOut(null) }
            end == null -> Unit // it did not end before the recording did
            before.index == cycle?.index -> endWith(end) { carryOut(end.end.failure) }
            else -> endIn(end.ns - before.ns) { carryOut(end.end.failure) }
        }
        return {}
    }

    private class Failed(failure: CallFailure) : CommandFailure {
        override val error = failure.error
        override val cause = failure.message
    }

    override fun <V> timer(work: Callable<V>, delayNs: Long, schedule: (Callable<V>) -> ScheduledFuture<V>): ScheduledFuture<V> {
        val number = ++begun
        val future = Kept(work)
        val carryOut = { if (!future.isCancelled) work.call() }
        val dueNs = ns + delayNs
        val end = if (isAsRecorded && isStepOf(cycle?.course)) recorded.takeTimer(number, dueNs) else recorded.timer(dueNs)
        if (end != null) endWith(end) { carryOut() } else endIn(delayNs) { carryOut() }
        return future
    }

    /** Whether the step that is carried out is the recorded one. */
    private fun isStepOf(before: Course?) = before?.step?.text?.let(::normal) == course.step?.step()?.text?.let(::normal)

    override fun left(work: RunnableSerializable) {
        left += work
    }

    override fun act(action: ActionExec, live: (ActionExec) -> Unit) {
        val number = ++begun
        fun carryOut(end: End) {
            complete(action, end)
            ts.c.addFeedbackAction(action)
        }
        val end = if (isAsRecorded && cycle?.course?.action == "${action.actionTerm}") recorded.endOf(number) else null
        if (end != null) endWith(end) { carryOut(end.end) } else endIn(recorded.usualNs) { carryOut(End(number, "action")) }
    }

    private fun endIn(delayNs: Long, carryOut: () -> Unit) {
        due += Due(ns + delayNs, null, begun, carryOut)
    }

    private fun endWith(end: RecordedCalls.Ended, carryOut: () -> Unit) {
        due += Due(end.ns, end.index, begun, carryOut)
    }

    override fun send(message: Message, live: () -> Unit) = sending(message)

    override fun broadcast(message: Message, live: () -> Unit) = sending(message.clone().apply { receiver = receiver ?: "everybody" })

    private fun sending(message: Message) {
        val now = mailOf(message)
        val index = unanswered.indexOfFirst {
            it.performative == now.performative && it.receiver == now.receiver && normal(it.content) == normal(now.content)
        }
        if (index < 0) return
        val before = unanswered.removeAt(index)
        ids[before.id] = now.id
        before.failure?.let { throw JasonException(it) }
    }

    override fun canSleep(live: () -> Boolean): Boolean = sleep.removeFirstOrNull() != 'n' && left.isEmpty()

    override fun ruleApplied() {
        if (::course.isInitialized && Keeper.current === this) course.ruleApplied()
    }

    override fun cycleFinished() {
        Keeper.current = null
    }

    /** A timer that ends when [WhatIfInputs] says so. */
    private class Kept<V>(work: Callable<V>) : FutureTask<V>(work), ScheduledFuture<V> {
        override fun getDelay(unit: TimeUnit) = Long.MAX_VALUE

        override fun compareTo(other: Delayed) = 0
    }

    private companion object {
        const val ACT = "argo.act"
        const val RANDOM = ".random"

        /** How many recorded messages are kept for what the agent may send yet. */
        const val MOST_UNANSWERED = 1000

        /** What is true only about the time at which it was asked. */
        val LATE = setOf("argo.age", "argo.skew", "argo.can", "argo.explain")

        /** What is given in the order of asking. */
        val CHANCE = setOf(RANDOM, ".shuffle", ".time", ".date", ".nano_time")
    }
}
