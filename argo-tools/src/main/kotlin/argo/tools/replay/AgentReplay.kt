package argo.tools.replay

import argo.recording.replay.Recording
import argo.recording.replay.RecordingException
import argo.recording.replay.Replay
import argo.tools.command.ToolException
import java.nio.file.Path

/** Replays the agents of the recording [file] before [untilNs], counted from the first cycle; null: to the end. */
internal class AgentReplay(private val file: Path, private val untilNs: Long?, private val believers: Set<String>) {
    /** @throws RecordingException if none of it can be replayed */
    fun run(): ReplayReport = Recording(file).use { recording ->
        val unknown = believers - recording.agents.keys
        if (unknown.isNotEmpty()) {
            throw ToolException("$file has no agent ${unknown.first()}; those that it has: ${recording.agents.keys.joinToString()}")
        }
        Replay(recording).use { replay(recording, it) }
    }

    private fun replay(recording: Recording, replay: Replay): ReplayReport {
        val firstNs = replay.nextNs ?: throw ToolException("$file holds no cycle of an agent")
        val begin = System.nanoTime()
        val trouble = stopping { replay.run(untilNs?.let { firstNs + minOf(it, Long.MAX_VALUE - firstNs) } ?: Long.MAX_VALUE) }
        val elapsedNs = System.nanoTime() - begin
        val shown = believers.ifEmpty { if (untilNs == null) emptySet() else recording.agents.keys }
        return ReplayReport(
            recording.agents.keys.toList(), replay.cyclesRun, firstNs, (replay.lastNs ?: firstNs) - firstNs, elapsedNs, replay.differences,
            shown.associateWith(replay::beliefs), recording.problems + listOfNotNull(trouble),
        )
    }

    /** Why [work] could not be done to its end; null: it was. */
    private fun stopping(work: () -> Unit): String? = try {
        work()
        null
    } catch (refused: RecordingException) {
        refused.message
    } catch (unreadable: IllegalArgumentException) {
        "a message in it cannot be read: ${unreadable.message}"
    }
}
