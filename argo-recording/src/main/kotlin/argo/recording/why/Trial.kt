package argo.recording.why

import argo.recording.Cycle
import argo.recording.Input
import argo.recording.RecordedAgent
import argo.recording.replay.ProgramFiles
import argo.recording.replay.RecordedAnswers
import argo.recording.replay.Recording
import argo.recording.replay.RecordingException
import argo.recording.replay.ReplayedAgent
import argo.recording.replay.ReplayedInputs
import jason.asSyntax.Literal
import java.util.concurrent.TimeUnit

/** Runs an agent of a recording again, up to a cycle. */
internal class Trial(
    private val recording: Recording,
    private val agent: RecordedAgent,
    private val programs: ProgramFiles,
    private val cycles: List<Cycle>,
    private val clock: RecordingClock,
) {
    /**
     * Runs it on what was recorded, up to the cycle [last], watched by what [traceOf] makes; [ran] is called behind each cycle. Returns
     * that, and what the agent has begun outside of its thread.
     * @throws RecordingException if it does something else than it did
     */
    fun asRecorded(last: Long, ran: (Trace) -> Unit = {}, traceOf: (ReplayedInputs, RecordedAnswers) -> Trace): Pair<Trace, List<Beginning>> {
        lateinit var trace: Trace
        lateinit var noting: NotingAnswers
        var differing: String? = null
        ReplayedAgent(
            recording, agent, programs,
            found = { cycle, what, recorded, now, cause ->
                if (!what.startsWith("result of ") && differing == null) {
                    differing = "cycle ${cycle.number}, $what: recorded ${recorded ?: "nothing"}, now ${now ?: "nothing"}; $cause"
                }
            },
            answersOf = { recorded -> NotingAnswers(recorded).also { noting = it } },
            boundaryOf = { inputs, answers -> traceOf(inputs, answers).also { made -> trace = begun(made) } },
        ).use { replayed ->
            for (cycle in cycles.takeWhile { it.index <= last }) {
                replayed.run(cycle)
                ran(trace)
                differing?.let { throw RecordingException("the replay of agent ${agent.name} differs from the recording at $it") }
            }
        }
        return trace to noting.begun
    }

    private fun begun(trace: Trace) = trace.apply { recording.start(agent.name)?.let(::beginAt) }

    /** Runs it up to the cycle [last] with percepts [changed] from the cycle [from] on, and returns the commands since then. */
    fun changed(begun: List<Beginning>, from: Long, last: Long, changed: (List<Literal>) -> List<Literal>): List<Trace.Issued> {
        lateinit var trace: Trace
        lateinit var altered: AlteredAnswers
        var isChanging = false
        val before = recording.start(agent.name)?.begun ?: 0
        ReplayedAgent(
            recording, agent, programs,
            senses = AlteredSenses { if (isChanging) changed(it) else it },
            answersOf = { recorded -> AlteredAnswers(recorded, begun, before) { trace.issue(null, it) }.also { altered = it } },
            boundaryOf = { inputs, answers -> begun(Trace(inputs, answers, clock)).also { trace = it } },
        ).use { replayed ->
            var earlier = 0
            val wanted = cycles.takeWhile { it.index <= last }
            for ((place, cycle) in wanted.withIndex()) {
                if (!isChanging && cycle.index >= from) {
                    isChanging = true
                    earlier = trace.issued.size
                }
                replayed.run(cycle)
                if (isChanging) between(replayed, altered, cycle, wanted.getOrNull(place + 1)?.ns)
            }
            return trace.issued.drop(earlier)
        }
    }

    /**
     * Runs the cycles that the changed agent needs between [cycle] and the one at [untilNs], in which the recorded one slept; behind the
     * last one, null, no time passes.
     */
    private fun between(replayed: ReplayedAgent, altered: AlteredAnswers, cycle: Cycle, untilNs: Long?) {
        val gapNs = if (untilNs == null) 0 else untilNs - cycle.ns
        val most = if (untilNs == null) MAX_BETWEEN else minOf(gapNs / CYCLE_NS, MAX_BETWEEN)
        var now = cycle.ns
        repeat(most.toInt()) {
            val c = replayed.ts.c
            val isBusy = c.hasEvent() || c.hasRunningIntention()
            val due = altered.dueNs?.let { maxOf(it, now) }
            if (!isBusy) now = due?.takeIf { it < (untilNs ?: (cycle.ns + 1)) } ?: return
            replayed.runBetween(Cycle(cycle.index, cycle.number, now, null, Input()))
        }
    }

    private companion object {
        /** A cycle takes about so long. */
        val CYCLE_NS = TimeUnit.MILLISECONDS.toNanos(1)
        const val MAX_BETWEEN = 500L
    }
}
