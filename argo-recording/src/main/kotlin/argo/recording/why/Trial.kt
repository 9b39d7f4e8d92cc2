package argo.recording.why

import argo.recording.Cycle
import argo.recording.RecordedAgent
import argo.recording.replay.ProgramFiles
import argo.recording.replay.RecordedAnswers
import argo.recording.replay.RecordedPercepts
import argo.recording.replay.Recording
import argo.recording.replay.RecordingException
import argo.recording.replay.ReplayedAgent
import argo.recording.replay.ReplayedInputs
import argo.recording.replay.ReplayedPercepts
import argo.recording.replay.WhatIf
import jason.asSyntax.Literal

internal class Trial(
    private val recording: Recording,
    private val agent: RecordedAgent,
    private val programs: ProgramFiles,
    private val cycles: List<Cycle>,
    private val clock: RecordingClock,
) {
    /**
     * Runs the agent on its recorded input up to the cycle [last], and calls [ran] after each cycle. Returns the trace that [traceOf]
     * makes.
     *
     * @throws RecordingException if the agent's course differs from the recorded one
     */
    fun asRecorded(last: Long, ran: (Trace) -> Unit = {}, traceOf: (ReplayedInputs, RecordedAnswers) -> Trace): Trace {
        lateinit var trace: Trace
        var differing: String? = null
        ReplayedAgent(
            recording, agent, programs,
            found = { cycle, what, recorded, now, cause ->
                if (!what.startsWith("result of ") && differing == null) {
                    differing = "cycle ${cycle.number}, $what: recorded ${recorded ?: "nothing"}, now ${now ?: "nothing"}; $cause"
                }
            },
            boundaryOf = { inputs, answers -> traceOf(inputs, answers).also { made -> trace = begun(made) } },
        ).use { replayed ->
            for (cycle in cycles.takeWhile { it.index <= last }) {
                replayed.run(cycle)
                ran(trace)
                differing?.let { throw RecordingException("the replay of agent ${agent.name} differs from the recording at $it") }
            }
        }
        return trace
    }

    private fun begun(trace: Trace) = trace.apply { recording.start(agent.name)?.let(::beginAt) }

    /**
     * Runs the agent up to the cycle [last]. From the cycle [from] on, [changed] changes the agent's percepts. Returns the commands since
     * [from]. Recorded commands have their recorded outcomes. Other commands end at once.
     */
    fun changed(from: Cycle, last: Long, changed: (List<Literal>) -> List<Literal>): List<String> {
        val wanted = cycles.asSequence().takeWhile { it.index <= last }
        val percepts = AlteredPercepts(from.index, changed)
        return WhatIf(recording, agent.name, null, percepts, wanted, usualNs = 0).use { it.commandsFrom(from.ns) }
    }
}

/** Perceives the recorded percepts. From the cycle with the index [from] on, [changed] changes the agent's percepts. */
internal class AlteredPercepts(
    private val from: Long,
    private val changed: (List<Literal>) -> List<Literal>,
    private val recorded: ReplayedPercepts = RecordedPercepts(),
) : ReplayedPercepts by recorded {
    override fun perceive(cycle: Cycle): List<Literal>? = recorded.perceive(cycle)?.let { if (cycle.index < from) it else changed(it) }
}
