package argo.tools.replay

import argo.recording.replay.Recording
import argo.recording.replay.RecordingException
import argo.recording.replay.Replay
import argo.tools.command.ToolException
import java.nio.file.Path

internal class AgentReplay(private val file: Path, private val options: AgentReplayOptions) {
    /**
     * Returns the result of the replay. With a port for debuggers, an agent waits before its first cycle until a debugger continues it.
     * [standing] then gets the agent's name, and the program files that have changed since the recording.
     * @throws RecordingException if no part of the recording can be replayed
     */
    fun run(standing: (agent: String, changed: List<Path>) -> Unit): ReplayReport = Recording(file).use { recording ->
        val unknown = options.of - recording.agents.keys
        if (unknown.isNotEmpty()) {
            throw ToolException("$file has no agent ${unknown.first()}; those that it has: ${recording.agents.keys.joinToString()}")
        }
        try {
            Replay(recording, options.isCheck, options.debugPort).use { replay(recording, it, standing) }
        } catch (unreadable: IllegalArgumentException) {
            throw ToolException("a message in $file cannot be read: ${unreadable.message}")
        }
    }

    private fun replay(recording: Recording, replay: Replay, standing: (String, List<Path>) -> Unit): ReplayReport {
        val firstNs = recording.firstNs
            ?: throw ToolException("$file holds no cycle of an agent; an agent that cannot be recorded says why in the log of its run")
        val beginNs = replay.nextNs ?: firstNs
        val endNs = options.until?.let { nsOf(it, recording, firstNs) } ?: Long.MAX_VALUE
        val cycles = cycles(recording, firstNs, endNs)
        if (options.from != null && cycles.isEmpty()) throw ToolException("$file has no cycle in the time of --from and --until")
        if (options.debugPort != null) replay.pause()?.let { standing(it, recording.changedFiles()) }
        val begin = System.nanoTime()
        val trouble = stopping { replay.run(endNs) }
        val elapsedNs = System.nanoTime() - begin
        val believers = if (options.until == null && options.from != null) emptySet() else options.of
        val shown = believers.ifEmpty { if (options.until == null) emptySet() else recording.agents.keys }
        val beginnings = recording.agents.keys.mapNotNull { agent -> recording.start(agent)?.let { agent to it } }.toMap()
        return ReplayReport(
            recording.agents.keys.toList(), beginnings, replay.cyclesRun, firstNs, (replay.lastNs ?: beginNs) - beginNs,
            elapsedNs,
            replay.differences, replay.refusals,
            shown.associateWith(replay::beliefs), cycles, recording.problems + listOfNotNull(trouble),
        )
    }

    private fun cycles(recording: Recording, firstNs: Long, endNs: Long): List<ShownCycle> {
        val beginNs = nsOf(options.from ?: return emptyList(), recording, firstNs)
        return recording.agents.keys.filter { options.of.isEmpty() || it in options.of }.flatMap { agent ->
            recording.cycles(agent).filter { it.ns in beginNs until endNs }.map { ShownCycle(agent, it) }
        }.sortedBy { it.cycle.ns }
    }

    private fun nsOf(moment: Moment, recording: Recording, firstNs: Long): Long = when (moment) {
        is Moment.Time -> firstNs + minOf(moment.ns, Long.MAX_VALUE - firstNs)
        is Moment.OfCycle -> {
            val agents = recording.agents.keys.filter { options.of.isEmpty() || it in options.of }
            agents.mapNotNull { agent -> recording.cycles(agent).find { it.number >= moment.number }?.ns }.minOrNull()
                ?: throw ToolException("no agent has a cycle ${moment.number} or a later one")
        }
    }

    /** Does [work]. Returns null on success, or otherwise the reason of the failure. */
    private fun stopping(work: () -> Unit): String? = try {
        work()
        null
    } catch (refused: RecordingException) {
        refused.message
    } catch (unreadable: IllegalArgumentException) {
        "a message in it cannot be read: ${unreadable.message}"
    }
}
