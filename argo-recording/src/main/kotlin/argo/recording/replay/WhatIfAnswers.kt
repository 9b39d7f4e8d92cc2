package argo.recording.replay

import argo.boundary.InternalCall
import argo.recording.Course
import argo.recording.Cycle
import argo.recording.End
import argo.recording.KeyFrame
import argo.recording.Mail
import argo.recording.agent.UnrecordableTerm
import argo.recording.agent.WatchedKind
import argo.recording.agent.textOf
import jason.asSemantics.Unifier
import jason.asSyntax.ASSyntax
import jason.asSyntax.ListTerm
import jason.asSyntax.Literal
import jason.asSyntax.StringTerm
import jason.asSyntax.Term
import java.util.PriorityQueue
import java.util.concurrent.Callable
import java.util.concurrent.ConcurrentLinkedQueue
import kotlin.random.Random

/**
 * Gives an agent the recorded results that are nearest in time, see [WhatIf]. The agent may differ from the recorded one. Notes the
 * commands that the agent sends.
 *
 * @param isCarryingOut whether to carry out the project's own actions and functions; if false, they have their recorded results
 * @param usualNs the duration of a command that was not recorded, in ns; null for the median of the recorded durations
 */
internal class WhatIfAnswers(private val recorded: NearestRecordedCalls, private val isCarryingOut: Boolean, usualNs: Long?) : Answers {
    private class Due(val ns: Long, val index: Long?, val order: Int, val carryOut: () -> Unit)

    private val due = PriorityQueue(compareBy<Due>({ it.ns }, { it.index ?: 0 }, { it.order }))
    private val left = ConcurrentLinkedQueue<Runnable>()
    private val unanswered = ArrayList<Mail>() // recorded messages that the agent has not sent so far
    private val random = Random(0)
    private val usualNs = usualNs ?: recorded.usualNs
    private var begun = 0
    private var underWay: NearestRecordedCalls.Made? = null
    private var isCommand = false
    private lateinit var inputs: ReplayedInputs
    private lateinit var cycle: Cycle

    val sent = ArrayList<TimedCommand>()

    val acted = ArrayList<TimedCommand>()

    override var isAsRecorded = true
        private set

    override val isOfRecordedProgram get() = !isCarryingOut

    override val isHeldAwake get() = left.isNotEmpty()

    /** The time of the first end that is due outside of recorded cycles, in ns; null if there is none. */
    val nextDueNs: Long? get() = due.filter { it.index == null }.minOfOrNull { it.ns }

    override fun begin(inputs: ReplayedInputs, start: KeyFrame?, timers: Map<Int, Callable<*>>) {
        this.inputs = inputs
        if (start == null) return
        begun = start.begun
        for ((number, work) in timers.toSortedMap()) {
            val dueNs = start.timers[number] ?: start.ns
            val end = recorded.takeTimer(number, dueNs)
            due += if (end != null) Due(end.ns, end.index, number) { work.call() } else Due(dueNs, null, number) { work.call() }
        }
    }

    override fun next(cycle: Cycle) {
        this.cycle = cycle
        unanswered += cycle.course.mail
    }

    fun ended(now: Course) {
        val before = cycle.course
        val isSame = cycle.index != BETWEEN && before.event?.let(::normal) == now.event?.let(::normal) && before.action == now.action &&
            before.step?.text?.let(::normal) == now.step?.text?.let(::normal) && before.step?.intention == now.step?.intention
        isAsRecorded = isAsRecorded && isSame
        if (unanswered.size > MOST_UNANSWERED) unanswered.subList(0, MOST_UNANSWERED / 2).clear()
    }

    override fun carryOut(cycle: Cycle) {
        while (true) due.peek()?.takeIf(::isDue)?.let { due.remove().carryOut() } ?: break
        while (true) left.poll()?.run() ?: break
    }

    private fun isDue(one: Due) = if (one.index != null) one.index <= cycle.index else one.ns <= cycle.ns

    override fun call(call: InternalCall, code: WatchedKind, live: (Unifier) -> Any): Any {
        if (code.isOfProject && isCarryingOut) return live(call.un)
        val args = call.args.map(::textOf)
        if (code == WatchedKind.SENDING) {
            val before = recorded.near(call.name, args, cycle.index, cycle.ns)
            return send(before?.call, call, live) { suspending(before, it) }
        }
        return when (call.name) {
            ACT -> act(call, recorded.near(ACT, args, cycle.index, cycle.ns))
            in LATE -> recorded.nearest(call.name, args, cycle.index, cycle.ns)?.let { answer(it, call) } ?: false
            in CHANCE -> recorded.nextOf(call.name, args)?.let { answer(it, call) } ?: drawn(call, live)
            else -> (recorded.near(call.name, args, cycle.index, cycle.ns) ?: recorded.firstOf(call.name, args))?.let { answer(it, call) }
                ?: call.name.startsWith("argo.").also { if (it) call.suspend?.invoke() }
        }
    }

    private fun drawn(call: InternalCall, live: (Unifier) -> Any): Any =
        if (call.name == RANDOM && call.args.size == 1) call.un.unifies(call.args[0], ASSyntax.createNumber(random.nextDouble()))
        else live(call.un)

    private fun act(call: InternalCall, before: NearestRecordedCalls.Made?): Any {
        val commands = before?.call?.commands.orEmpty().map { it.port to it.text }.ifEmpty {
            if (before?.call?.failure == null) listOf(portIn(call) to textOfCommand(call.args[0])) else emptyList()
        }
        commands.forEach { (port, text) -> sent += command(port, text) }
        isCommand = true
        try {
            if (before != null) return answer(before, call)
            call.suspend?.invoke()
            return true
        } finally {
            isCommand = false
        }
    }

    private fun command(port: String?, text: String) = TimedCommand(inputs.ts.agArch.cycleNumber, cycle.ns, port, text, place())

    private fun portIn(call: InternalCall) = (call.args.getOrNull(1) as? ListTerm)?.filterIsInstance<Literal>()
        ?.find { it.functor == "port" && it.arity == 1 }?.getTerm(0)?.let { if (it is StringTerm) it.string else "$it" }

    private fun textOfCommand(command: Term) = when {
        command is StringTerm -> command.string
        command is Literal && command.ns != Literal.DefaultNS -> "${command.cloneNS(Literal.DefaultNS)}"
        else -> "$command"
    }

    private fun place(): String? = inputs.ts.c.selectedIntention?.takeUnless { it.isFinished }?.peek()?.let { means ->
        val step = inputs.course.placeOf(means.plan)
        placeOf(step.file, means.currentStep?.srcInfo?.srcLine ?: step.line)
    }

    private fun answer(before: NearestRecordedCalls.Made, call: InternalCall): Any = answer(before.call, call) { suspending(before, it) }

    private fun suspending(before: NearestRecordedCalls.Made?, suspend: () -> Unit) {
        val around = underWay
        underWay = before
        suspend()
        underWay = around
    }

    override fun evaluate(name: String, args: Array<Term>, isOfProject: Boolean, live: () -> Double): Double {
        if (isOfProject && isCarryingOut) return live()
        return recorded.nextOf(name, args.map(::textOf))?.call?.value?.toDouble()
            ?: if (name == "math.random" && args.isEmpty()) random.nextDouble() else if (isOfProject) Double.NaN else live()
    }

    override fun begun(work: BegunWork) {
        val number = ++begun
        val carryOut = { end: End? -> if (!work.isDropped()) work.complete(End(number, work.kind, end?.failure, answer = end?.answer)) }
        when (work.kind) {
            "call" -> suspended(carryOut)
            "timer" -> timer(work.delayNs, carryOut)
            else -> {
                acted += command(null, normal(work.what))
                val end = if (isAsRecorded && cycle.course.action == work.what) recorded.endOf(number) else null
                if (end != null) endWith(end, carryOut) else endIn(usualNs, carryOut)
            }
        }
    }

    private fun suspended(carryOut: (End?) -> Unit) {
        val before = underWay
        val end = before?.call?.number?.let(recorded::endOf)
        when {
            before == null -> endIn(if (isCommand) usualNs else 0, carryOut)
            end == null -> Unit // the recording ended before the call
            before.index == cycle.index -> endWith(end, carryOut)
            else -> endIn(end.ns - before.ns) { carryOut(end.end) }
        }
    }

    private fun timer(delayNs: Long, carryOut: (End?) -> Unit) {
        val dueNs = cycle.ns + delayNs
        val end = if (isAsRecorded && isStepOf(cycle.course)) recorded.takeTimer(begun, dueNs) else recorded.timer(dueNs)
        if (end != null) endWith(end, carryOut) else endIn(delayNs, carryOut)
    }

    private fun isStepOf(before: Course) = before.step?.text?.let(::normal) == inputs.course.step?.step()?.text?.let(::normal)

    private fun endIn(delayNs: Long, carryOut: (End?) -> Unit) {
        due += Due(cycle.ns + delayNs, null, begun) { carryOut(null) }
    }

    private fun endWith(end: NearestRecordedCalls.Ended, carryOut: (End?) -> Unit) {
        due += Due(end.ns, end.index, begun) { carryOut(end.end) }
    }

    override fun left(work: Runnable) {
        left += work
    }

    override fun sent(mail: Mail): Mail? {
        val index = unanswered.indexOfFirst {
            it.performative == mail.performative && it.receiver == mail.receiver && normal(it.content) == normal(mail.content)
        }
        return if (index < 0) null else unanswered.removeAt(index)
    }

    override fun refused(what: String, why: UnrecordableTerm) = throw why

    companion object {
        private const val ACT = "argo.act"
        private const val RANDOM = ".random"

        /** The largest number of recorded messages that are kept for comparison with later messages of the agent. */
        private const val MOST_UNANSWERED = 1000

        /** The actions with answers that are true only at the time of the question. */
        private val LATE = setOf("argo.age", "argo.skew", "argo.can", "argo.explain")

        private val CHANCE = setOf(RANDOM, ".shuffle", ".time", ".date", ".nano_time")

        /** The index of an additional cycle, which was not recorded and has no input. */
        const val BETWEEN = 0L
    }
}
