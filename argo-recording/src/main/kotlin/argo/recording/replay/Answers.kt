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
import argo.recording.agent.exception
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
 * Answers an agent's questions in a replay, and ends the operations that the agent begins outside of its thread. Each agent has its own
 * answers. Only [left] may be called on any thread, all other functions on the agent's thread.
 */
internal interface Answers {
    /** True if the agent has repeated each step of the recording so far. */
    val isAsRecorded: Boolean get() = true

    /** True if the agent has the recorded program, and so follows recorded reloads. */
    val isOfRecordedProgram: Boolean get() = true

    /** The recorded call that waits for an outcome, in words; empty if it is not known. */
    val suspending: String get() = ""

    /** True if the agent has work although it rested in the recording. */
    val isHeldAwake: Boolean get() = false

    /**
     * Begins the agent of [inputs] at [start]. If [start] is null, begins at the beginning of its program. [timers] has the running timers,
     * by number.
     */
    fun begin(inputs: ReplayedInputs, start: KeyFrame?, timers: Map<Int, Callable<*>>)

    fun next(cycle: Cycle)

    fun carryOut(cycle: Cycle)

    /** Returns the result of [call]. [live] carries the call out. */
    fun call(call: InternalCall, code: WatchedKind, live: (Unifier) -> Any): Any

    /** Returns the value of the function [name] for [args]. [live] evaluates the function. */
    fun evaluate(name: String, args: Array<Term>, isOfProject: Boolean, live: () -> Double): Double

    fun begun(work: BegunWork)

    /** Takes [work] that another thread leaves for the agent's next cycle. Any thread may call this function. */
    fun left(work: Runnable)

    /** Returns the recorded message that corresponds to the agent's message [mail]; null if there is none. */
    fun sent(mail: Mail): Mail?

    /** Notes that the text recorded for [what] is refused. It replaces a term that no recording can contain. */
    fun refused(what: String, why: UnrecordableTerm)

    /** Called at the end of the cycle. */
    fun cycleFinished() = Unit
}

/**
 * An operation that an agent begins outside of its thread, in [cycle].
 *
 * @property kind the operation's kind, as in [End.kind]
 * @property delayNs the delay of a timer, in ns
 * @property isDropped returns true if the agent has given the operation up
 */
internal class BegunWork(
    val cycle: Cycle,
    val kind: String,
    val what: String,
    val delayNs: Long,
    val isDropped: () -> Boolean = { false },
    val complete: (End) -> Unit,
)

/** A timer that ends only when the recording requires it. */
internal class Unscheduled<V>(work: Callable<V>) : FutureTask<V>(work), ScheduledFuture<V> {
    override fun getDelay(unit: TimeUnit) = Long.MAX_VALUE

    override fun compareTo(other: Delayed) = 0
}

internal fun compared(args: List<Term>): List<String> = args.map { normal(textOf(it)) }

internal fun Call.isOf(name: String, args: List<String>) = this.name == name && this.args.map(::normal) == args

/** Returns the recorded value of the called function, or throws the recorded failure. Returns null if the agent called an action. */
internal fun Call.valueOrFailure(): Double? {
    failure?.let { throw evaluationFailed(it) }
    return value?.toDouble()
}

/** Gives [call] the result or failure of [recorded]. [suspending] gets the function that suspends the intention. */
internal fun answer(recorded: Call, call: InternalCall, suspending: (suspend: () -> Unit) -> Unit = { it() }): Any {
    recorded.failure?.let { throw it.exception() }
    if (recorded.isBacktracking) return recorded.answers.map { answer -> call.un.clone().also { bind(call, it, answer) } }.iterator()
    if (recorded.answers.isEmpty()) return false
    val suspend = call.suspend
    if (suspend == null || recorded.number == null) bind(call, call.un, recorded.answers.first()) else suspending(suspend)
    return true
}

/**
 * Lets [live] carry out [call], which sends a message. As in [recorded], the intention then waits or its plan fails. Outside of a fleet
 * [recorded] is null, and no intention waits.
 */
internal fun send(recorded: Call?, call: InternalCall, live: (Unifier) -> Any, suspending: (suspend: () -> Unit) -> Unit): Any {
    val result = try {
        live(call.un)
    } catch (failed: JasonException) {
        throw recorded?.failure?.exception() ?: failed
    }
    if (recorded?.number != null) call.suspend?.let(suspending)
    return result
}

private fun bind(call: InternalCall, un: Unifier, answer: Map<Int, String>) = answer.forEach { (place, text) ->
    call.args.getOrNull(place)?.let { un.unifies(it, termOf(text)) }
}
