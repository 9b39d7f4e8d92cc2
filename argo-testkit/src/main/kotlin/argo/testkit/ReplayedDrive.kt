package argo.testkit

import argo.filters.PerceptionFilter
import argo.recording.replay.CommandDifference
import argo.recording.replay.Recording
import argo.recording.replay.RecordingException
import argo.recording.replay.TimedCommand
import argo.recording.replay.WhatIf
import kotlin.time.Duration
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.nanoseconds
import kotlin.time.toJavaDuration

/**
 * Runs an agent's current program on the percepts of a recorded drive. The option `argo_record` makes the recording:
 *
 *     test("the robot does in the corridor what it did") {
 *         replayed("corridor.mcap").shouldSendTheSame()
 *     }
 *
 * [WhatIf] tells when the result is exact.
 *
 * @param file the recording, a path from the test's working directory or from `src/test/resources` below it
 * @param agent the agent's name, or null if the recording has one agent
 * @param program the agent's current program, or null for the file with the recorded name. [argo.testkit.agent] tells where the program is
 * searched
 * @param filter the filter for percepts of boards, or null for the recorded filters
 * @throws IllegalArgumentException if the file, agent or program does not exist, or if the recording cannot be replayed
 */
fun replayed(
    file: String,
    agent: String? = null,
    program: String? = null,
    filter: PerceptionFilter? = null,
): ReplayedDrive = refusedInWords {
    Recording(found("recording", file, listOf("", "src/test/resources"))).use { recording ->
        val name = agent ?: recording.agents.keys.singleOrNull()
            ?: throw RecordingException("$file has the agents ${recording.agents.keys.joinToString()}; agent = \"…\" names one of them")
        val source = program ?: recording.agents[name]?.source.orEmpty().substringAfterLast('/')
        WhatIf(recording, name, found(source), filter).use { ReplayedDrive(file, name, it.run()) }
    }
}

private fun <T> refusedInWords(work: () -> T): T = try {
    work()
} catch (refused: RecordingException) {
    throw IllegalArgumentException(refused.message, refused)
}

/** An agent's current program on a recorded drive. [replayed] makes it. */
class ReplayedDrive internal constructor(private val file: String, private val agent: String, whatIf: WhatIf) {
    private val before = whatIf.commands.toList()
    private val now = whatIf.commandsNow.toList()
    private val firstNs = whatIf.firstNs ?: 0
    private val differenceWithin: (Duration) -> CommandDifference? =
        whatIf.endNs.let { end -> { within -> CommandDifference.first(before, now, within.toJavaDuration(), end) } }

    /** The commands of the recording, in order. */
    val recorded: List<String> get() = before.map { it.text }

    /** The commands of the current program, in order. */
    val sent: List<String> get() = now.map { it.text }

    /**
     * Expects the recorded commands in order, each at its recorded time.
     *
     * @param within the tolerance for the times
     * @throws AssertionError with the first different command
     */
    fun shouldSendTheSame(within: Duration = WITHIN): ReplayedDrive = apply {
        differenceWithin(within)?.let { throw AssertionError(reportOf(it)) }
    }

    private fun reportOf(difference: CommandDifference): String = with(difference) {
        val what = when (kind) {
            "missing" -> "it does not send ${described(recorded)}"
            "additional" -> "it sends ${described(now)}, which was not recorded"
            "other" -> "it sends ${described(now)} in place of ${described(recorded)}"
            else -> "it sends ${described(now)} $kind than recorded, ${described(recorded)}"
        }
        "expected that agent $agent sends what is recorded in $file, but $what\n" +
            "${if (same == 1) "1 command before is" else "$same commands before are"} the same\n" +
            "recorded: ${listed(this@ReplayedDrive.before, same)}\nsent now: ${listed(this@ReplayedDrive.now, same)}"
    }

    private fun described(command: TimedCommand?) = command?.let { sent ->
        "${sent.text} at ${at(sent)}${sent.place?.let { " ($it)" }.orEmpty()}"
    }

    private fun at(command: TimedCommand) = "${(command.ns - firstNs).nanoseconds.inWholeMilliseconds} ms"

    private fun listed(commands: List<TimedCommand>, first: Int): String {
        val shown = commands.drop(maxOf(0, first - SHOWN_BEFORE)).take(SHOWN).ifEmpty { return "nothing" }
        return shown.joinToString("") { "\n    ${at(it)}: ${it.text}${it.place?.let { place -> " ($place)" }.orEmpty()}" }
    }

    private companion object {
        /** The default tolerance for the times of commands. */
        val WITHIN = 100.milliseconds
        const val SHOWN_BEFORE = 3
        const val SHOWN = 7
    }
}
