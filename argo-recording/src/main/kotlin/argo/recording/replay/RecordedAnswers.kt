package argo.recording.replay

import argo.boundary.InternalCall
import argo.recording.Call
import argo.recording.Cycle
import argo.recording.End
import argo.recording.KeyFrame
import argo.recording.Mail
import argo.recording.agent.PendingOperations
import argo.recording.agent.UnrecordableTerm
import argo.recording.agent.WatchedKind
import argo.recording.agent.bound
import argo.recording.agent.callFailure
import argo.recording.agent.thrownFailure
import jason.JasonException
import jason.asSemantics.Unifier
import jason.asSyntax.Term
import java.util.concurrent.Callable
import java.util.concurrent.LinkedBlockingQueue
import java.util.concurrent.TimeUnit

/** Takes a difference from a recording: its kind, the recorded value, the value in the replay, and the cause, if known. */
internal typealias DifferenceSink = (what: String, recorded: String?, now: String?, cause: String?) -> Unit

/**
 * Gives the recorded results to an agent that must repeat its recording. Reports each difference. If [isChecking] is true, carries out the
 * project's own actions and functions again, and compares their results.
 */
internal class RecordedAnswers(private val isChecking: Boolean, private val found: DifferenceSink) : Answers {
    private val open = PendingOperations()
    private val left = LinkedBlockingQueue<Runnable>()
    private var calls: MutableList<Call> = ArrayList()
    private val taken = ArrayList<Call>()
    private var sent: MutableList<Mail> = ArrayList()
    private var underWay: Call? = null
    private lateinit var cycle: Cycle

    /** The recorded calls that the agent has repeated in this cycle, in the order of the repetition. */
    val repeated: List<Call> get() = taken

    /** The project's actions and functions that the agent has called. If a difference appears, its cause is probably among them. */
    val projectCalls = LinkedHashSet<String>()

    override val suspending: String get() = underWay?.let(::described).orEmpty()

    override fun begin(inputs: ReplayedInputs, start: KeyFrame?, timers: Map<Int, Callable<*>>) {
        if (start != null) open.restore(start.begun, timers.mapValues { (_, work) -> { _: End -> work.call() } })
    }

    override fun next(cycle: Cycle) {
        this.cycle = cycle
        calls = cycle.input.calls.toMutableList()
        taken.clear()
        sent = cycle.course.mail.toMutableList()
    }

    override fun carryOut(cycle: Cycle) = cycle.input.ends.forEach(::carryOut)

    private fun carryOut(end: End) {
        if (end.number != 0) {
            if (!open.carryOut(end)) found("end of a ${end.kind}", "number ${end.number}", null, null)
            return
        }
        if (end.kind == WORK && !isChecking) return // if the work had an effect, the replay has already ended
        val work = left.poll(THREAD_PATIENCE_S, TimeUnit.SECONDS)
        if (work != null) return work.run()
        found("work of thread ${end.thread}", "in this cycle", null, "the project's threads are not recorded")
    }

    override fun call(call: InternalCall, code: WatchedKind, live: (Unifier) -> Any): Any {
        val recorded = take(call.name, call.args)
        if (code == WatchedKind.SENDING) return send(recorded, call, live) { suspending(recorded, it) }
        if (recorded == null) {
            foundCall(normal("$call"))
            return if (code.isOfProject && isChecking) live(call.un) else false
        }
        if (code.isOfProject) projectCalls += call.name
        if (code == WatchedKind.SUSPENDING && isChecking) return live(call.un)
        if (code == WatchedKind.PROJECT && isChecking) compare(recorded, call, live)
        return answer(recorded, call) { suspending(recorded, it) }
    }

    private fun suspending(recorded: Call?, suspend: () -> Unit) {
        val around = underWay
        underWay = recorded
        suspend()
        underWay = around
    }

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
        } catch (broken: Exception) {
            "${thrownFailure(broken)}"
        }
        val before = recorded.failure?.toString() ?: if (recorded.answers.isEmpty()) NOT_TRUE else recorded.answers.toString()
        if (normal(before) == normal(now)) return
        found("${Difference.RESULT}${recorded.name}", normal(before), normal(now), notRecorded(recorded.name, "action"))
    }

    override fun evaluate(name: String, args: Array<Term>, isOfProject: Boolean, live: () -> Double): Double {
        val recorded = take(name, args)?.valueOrFailure()
        if (recorded == null) {
            foundCall("$name(${args.joinToString(",")})")
            return if (isOfProject && !isChecking) Double.NaN else live()
        }
        if (isOfProject) projectCalls += name
        if (isOfProject && isChecking) {
            val (before, now) = "$recorded" to "${live()}"
            if (now != before) found("${Difference.RESULT}$name", before, now, notRecorded(name, "function"))
        }
        return recorded
    }

    /**
     * Reports the agent's call [now], which was not recorded. If Jason ended the recorded cycle early, does not report it, since the call
     * might have come later.
     */
    private fun foundCall(now: String) {
        if (!cycle.isEnding) found("call", calls.firstOrNull()?.let(::described), now, null)
    }

    private fun notRecorded(name: String, kind: String) =
        "the project's $kind $name gives another result for the same arguments: it reads a clock, chance, a file or data of a thread"

    /** Returns the recorded call of [name] with [args]; null if there is none. Returns each call once. */
    private fun take(name: String, args: Array<Term>): Call? {
        val texts = compared(args.asList())
        val index = calls.indexOfFirst { it.isOf(name, texts) }
        return if (index < 0) null else calls.removeAt(index).also(taken::add)
    }

    override fun begun(work: BegunWork) {
        val number = open.begin(work.complete)
        if (work.kind == CALL && underWay?.number != number) found("number of a call", "${underWay?.number}", "$number", null)
    }

    override fun left(work: Runnable) {
        left += work
    }

    override fun sent(mail: Mail): Mail? = sent.removeFirstOrNull()

    override fun refused(what: String, why: UnrecordableTerm) =
        found("the $what", why.message, null, "a recording cannot hold ${why.message}, so the replay ends here")

    override fun cycleFinished() {
        calls.firstOrNull()?.let { found("call", described(it), null, null) }
    }

    private fun described(call: Call) = normal("${call.name}(${call.args.joinToString(",")})")

    private companion object {
        const val CALL = "call"
        const val WORK = "work"

        /** The longest wait, in s, for work that a thread of the project left in the recorded cycle. */
        const val THREAD_PATIENCE_S = 5L
        const val NOT_TRUE = "false"
    }
}
