package argo.recording.replay

import argo.boundary.InternalCall
import argo.recording.Call
import argo.recording.Cycle
import argo.recording.End
import argo.recording.KeyFrame
import argo.recording.Mail
import argo.recording.agent.UnrecordableTerm
import argo.recording.agent.WatchedKind
import argo.recording.agent.evaluationFailed
import argo.recording.agent.termOf
import argo.recording.agent.textOf
import jason.JasonException
import jason.asSemantics.Unifier
import jason.asSyntax.Term
import java.util.concurrent.Callable
import java.util.concurrent.Delayed
import java.util.concurrent.FutureTask
import java.util.concurrent.ScheduledFuture
import java.util.concurrent.TimeUnit

/**
 * What an agent that runs on a recording is answered where it asks, and when something ends that it begins outside of its thread. Belongs
 * to one agent, and to its thread, except for [left].
 */
internal interface Answers {
    /** True if the agent has done step by step what was recorded. */
    val isAsRecorded: Boolean get() = true

    /** What waits for an outcome, as it was recorded; empty: that is not known. */
    val suspending: String get() = ""

    /** True if the agent has work though it was recorded to rest. */
    val isHeldAwake: Boolean get() = false

    /** The agent of [inputs] begins, at [start] with [timers] under way, by their numbers; null: as its program has it. */
    fun begin(inputs: ReplayedInputs, start: KeyFrame?, timers: Map<Int, Callable<*>>)

    /** The next cycle is [cycle]. */
    fun next(cycle: Cycle)

    /** Carries out what ends before [cycle]. */
    fun carryOut(cycle: Cycle)

    /** The port by which [percept] came, a text of [argo.recording.agent.literalText]; null: that of no board. */
    fun boardOf(percept: String): String?

    /** What [call] gives; [live] carries it out. */
    fun call(call: InternalCall, code: WatchedKind, live: (Unifier) -> Any): Any

    /** What the function [name] gives for [args]; [live] evaluates it. */
    fun evaluate(name: String, args: Array<Term>, isOfProject: Boolean, live: () -> Double): Double

    /** The agent begins [work]. */
    fun begun(work: BegunWork)

    /** Another thread leaves [work] for the agent's next cycle. Any thread. */
    fun left(work: Runnable)

    /** The recorded message in whose place the agent sends [mail]; null: none. */
    fun sent(mail: Mail): Mail?

    /** Recorded texts of the [what] are of a term that no recording can hold. */
    fun refused(what: String, why: UnrecordableTerm)

    /** The cycle is over. */
    fun cycleFinished() = Unit
}

/**
 * Something that an agent begins outside of its thread.
 *
 * @property cycle in which it does so
 * @property kind as [End.kind] has it
 * @property what describes it
 * @property delayNs how long it takes, if it is a timer
 * @property isDropped whether the agent wants it no more
 * @property complete is for its end
 */
internal class BegunWork(
    val cycle: Cycle,
    val kind: String,
    val what: String,
    val delayNs: Long,
    val isDropped: () -> Boolean = { false },
    val complete: (End) -> Unit,
)

/** A timer whose time is given by the recording. */
internal class Unscheduled<V>(work: Callable<V>) : FutureTask<V>(work), ScheduledFuture<V> {
    override fun getDelay(unit: TimeUnit) = Long.MAX_VALUE

    override fun compareTo(other: Delayed) = 0
}

/** How [args] of a call are compared. */
internal fun compared(args: List<Term>): List<String> = args.map { normal(textOf(it)) }

/** Returns true if it was a call of [name] with [args], as [compared] has them. */
internal fun Call.isOf(name: String, args: List<String>) = this.name == name && this.args.map(::normal) == args

/** What the function gave; null: it is none. Throws what it threw. */
internal fun Call.valueOrFailure(): Double? {
    failure?.let { throw evaluationFailed(it) }
    return value?.toDouble()
}

/** Gives [call] what [recorded] gave, and fails as that did; [suspending] stands around the suspension of its intention. */
internal fun answer(recorded: Call, call: InternalCall, suspending: (suspend: () -> Unit) -> Unit = { it() }): Any {
    recorded.failure?.let { throw JasonException(it.message, if (it.error.isEmpty()) null else termOf(it.error)) }
    if (recorded.isBacktracking) return recorded.answers.map { answer -> call.un.clone().also { bind(call, it, answer) } }.iterator()
    if (recorded.answers.isEmpty()) return false
    val suspend = call.suspend
    if (suspend == null) bind(call, call.un, recorded.answers.first()) else suspending(suspend)
    return true
}

/** Binds the variables in the arguments of [call] to what was recorded as its [answer]. */
private fun bind(call: InternalCall, un: Unifier, answer: Map<Int, String>) = answer.forEach { (place, text) ->
    call.args.getOrNull(place)?.let { un.unifies(it, termOf(text)) }
}
