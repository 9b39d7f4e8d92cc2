package argo.tools.replay

import argo.filters.PerceptionFilter
import argo.recording.replay.CommandDifference
import argo.recording.replay.Recording
import argo.recording.replay.RecordingException
import argo.recording.replay.TimedCommand
import argo.recording.replay.WhatIf
import argo.tools.command.ToolException
import argo.tools.command.counted
import argo.tools.command.jsonOf
import argo.tools.command.requireFile
import argo.tools.command.secondsIn
import kotlinx.serialization.json.JsonObject
import java.nio.file.InvalidPathException
import java.nio.file.Path
import java.time.Duration

/**
 * Runs the agents of the recording [file] one by one with other programs or another filter.
 *
 * @param programs each one is `AGENT=FILE`, or only `FILE` if the recording has one agent
 * @param filter the filter that replaces the recorded filters, or null for no replacement. The filter applies to all agents if [programs]
 * is empty
 * @param within the tolerance for the times of commands that count as equal
 */
internal class AgentWhatIf(
    private val file: Path,
    private val programs: List<String>,
    private val filter: PerceptionFilter?,
    private val within: Duration,
) {
    /** @throws RecordingException if an agent cannot be run */
    fun run(): WhatIfReport = Recording(file).use { recording ->
        try {
            val wanted = programs.map { programOf(recording, it) }.ifEmpty { recording.agents.keys.map { it to null } }
            val results = wanted.map { (agent, program) -> run(recording, agent, program) }
            WhatIfReport(results, recording.problems)
        } catch (unreadable: IllegalArgumentException) {
            throw ToolException("a message in $file cannot be read: ${unreadable.message}")
        }
    }

    private fun run(recording: Recording, agent: String, program: Path?): WhatIfResult =
        WhatIf(recording, agent, program, filter).use { whatIf ->
            val problem = try {
                whatIf.run()
                null
            } catch (refused: RecordingException) {
                if (whatIf.firstNs == null) throw refused
                refused.message
            }
            WhatIfResult(
                agent, listOfNotNull(program, filter?.let { "filter ${it.name}" }).joinToString(" and "),
                whatIf.firstNs ?: throw ToolException("$file holds no cycle of agent $agent"),
                whatIf.commands.size, whatIf.commandsNow.size, whatIf.difference(within), problem,
            )
        }

    private fun programOf(recording: Recording, option: String): Pair<String, Path> {
        val named = recording.agents.keys.find { option.startsWith("$it=") }
        val agent = named ?: recording.agents.keys.singleOrNull() ?: throw ToolException(
            "$file has the agents ${recording.agents.keys.joinToString()}; --agent AGENT=FILE names one of them, \"$option\" names none",
        )
        val program = try {
            Path.of(if (named == null) option else option.removePrefix("$named="))
        } catch (wrong: InvalidPathException) {
            throw ToolException("\"$option\" names no file: ${wrong.message}")
        }
        requireFile(program)
        return agent to program
    }
}

/**
 * The result of [agent] with [what], another program or another filter.
 *
 * @property now the number of commands with [what]; [recorded] is the number in the recording
 * @property problem the reason why the run was not finished, or null if it was
 */
internal class WhatIfResult(
    val agent: String,
    val what: String,
    private val firstNs: Long,
    val recorded: Int,
    val now: Int,
    val difference: CommandDifference?,
    val problem: String?,
) {
    fun lines(): List<String> = buildList {
        add("agent $agent with $what: ${counted(recorded, "command")} recorded, $now now")
        if (difference == null) add("identical: the same commands at the same times")
        else {
            add("differs, behind ${counted(difference.same, "equal command")}: %.3f s, ${difference.kind}".format(seconds(difference.ns)))
            add("  recorded: ${described(difference.recorded)}")
            add("  now:      ${described(difference.now)}")
        }
    }

    private fun described(command: TimedCommand?) = command?.run {
        val to = port?.let { " to $it" }.orEmpty()
        val by = place?.let { ", $it" }.orEmpty()
        "$text$to at ${"%.3f".format(seconds(ns))} s, cycle $cycle$by"
    } ?: "nothing"

    fun json(): JsonObject = jsonOf(
        "agent" to agent, "with" to what, "identical" to (difference == null), "recorded" to recorded, "now" to now,
        "difference" to difference?.let {
            jsonOf(
                "kind" to it.kind, "seconds" to seconds(it.ns), "same" to it.same, "recorded" to it.recorded?.let(::jsonOf),
                "now" to it.now?.let(::jsonOf),
            )
        },
    )

    private fun jsonOf(it: TimedCommand) =
        jsonOf("text" to it.text, "port" to it.port, "seconds" to seconds(it.ns), "cycle" to it.cycle, "place" to it.place)

    private fun seconds(ns: Long) = secondsIn(ns - firstNs)
}

/** The results for all agents. [damage] describes the unreadable parts of the file. */
internal class WhatIfReport(private val results: List<WhatIfResult>, private val damage: List<String>) {
    val problems: List<String> get() = damage + results.mapNotNull { it.problem }

    val isIdentical: Boolean get() = results.all { it.difference == null }

    fun lines(): List<String> = results.flatMap { it.lines() }

    fun json(): JsonObject = jsonOf("identical" to isIdentical, "problems" to problems, "agents" to results.map { it.json() })
}
