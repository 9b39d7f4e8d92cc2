package argo.tools.why

import argo.filters.withControlsShown
import argo.mcap.McapReader
import argo.recording.replay.Recording
import argo.recording.why.Answer
import argo.recording.why.JointWhy
import argo.recording.why.NotAnswer
import argo.recording.why.Question
import argo.recording.why.Why
import argo.tools.command.ExitStatus
import argo.tools.command.ToolException
import argo.tools.command.requireFile
import argo.tools.command.withAll
import argo.tools.replay.JasonCommand
import kotlinx.serialization.json.Json
import picocli.CommandLine.Command
import picocli.CommandLine.Option
import picocli.CommandLine.Parameters
import java.nio.file.Path

@Command(
    name = "why",
    description = [
        "Tells why an agent in a recording (FILE.mcap) sent a command, back to the frames of the boards, or why it did not.",
        "QUESTION is a command or its functor: stop@12.3s is the one nearest to that second, 0.5 s off at most, stop#3 the third one, stop the last one;",
        "#17 is the command that the live view and the timeline call number 17.",
        "Of several recordings, as those of a fleet's computers, the first one, or that of --of, is asked about;",
        "messages are followed into the others.",
    ],
)
internal class WhyCommand : JasonCommand() {
    @Parameters(
        arity = "1..*", paramLabel = "FILE... QUESTION",
        description = ["recordings by agents' argo_record, and behind them a command: stop@12.3s, stop#3, stop or #17"],
    )
    private lateinit var operands: List<String>

    @Option(names = ["--not"], description = ["tells why the command was not sent up to that second, or at all"])
    private var isNot = false

    @Option(names = ["--had"], paramLabel = "PERCEPT", description = ["shows what it would have sent with this percept; may be repeated"])
    private var had: List<String> = emptyList()

    @Option(names = ["--of"], paramLabel = "AGENT", description = ["asks about this agent; needed if there are several and --not is given"])
    private var of: String? = null

    override fun call(): Int {
        if (operands.size < 2) misuse("it takes a recording and, behind it, a command such as stop@12.3s")
        val files = operands.dropLast(1).map(Path::of)
        val asked = Question.of(operands.last()) ?: misuse("a question is a command such as stop@12.3s, not '${operands.last()}'")
        if (isNot && had.isNotEmpty()) misuse("--not and --had exclude each other")
        if (isNot && asked.count != null) misuse("--not goes with a time, ${asked.text.ifEmpty { "stop" }}@12.3s, and not with a number")
        files.forEach(::requireRecording)
        tellUnusedOptions()
        if (!runsHere) return runElsewhere(*operands.toTypedArray())
        return withAll(files, { Recording(it) }) { recordings -> tell(files.map { "$it" }.zip(recordings).toMap(), asked) }
    }

    private fun requireRecording(file: Path) {
        requireFile(file)
        if (!McapReader.isMcap(file)) throw ToolException("$file is no recording of an agent, which the option argo_record makes")
    }

    private fun tell(recordings: Map<String, Recording>, asked: Question): Int {
        val (name, recording) = recordings.entries.find { of == null || of in it.value.agents } ?: throw ToolException(
            "${recordings.keys.joinToString()} has no agent $of; those that it has: " +
                recordings.values.flatMap { it.agents.keys }.joinToString(),
        )
        JointWhy(mapOf(name to recording) + recordings).use { if (isNot) printNot(it.first, recording, asked) else print(it, asked) }
        recordings.forEach { (name, one) -> one.problems.forEach { err.println("$name: ${withControlsShown(it)}") } }
        return if (recordings.values.all { it.problems.isEmpty() }) ExitStatus.DONE else ExitStatus.FAILED
    }

    private fun print(joint: JointWhy, asked: Question) {
        val why = joint.first
        val command = asked.find(why.commands.filter { of == null || it.agent == of })
        val answer = joint.follow(why.answer(command, isTrying = had.isEmpty()))
        val all = if (had.isEmpty()) answer else answer.copy(had = had.map { why.had(command, it) })
        if (json) out.println(JSON.encodeToString(Answer.serializer(), all))
        else WhyText().of(all).forEach { out.println(withControlsShown(it)) }
    }

    private fun printNot(why: Why, recording: Recording, asked: Question) {
        val agent = of ?: recording.agents.keys.singleOrNull()
            ?: misuse("--of names one of the agents: ${recording.agents.keys.joinToString()}")
        val answer = why.not(agent, asked)
        if (json) out.println(JSON.encodeToString(NotAnswer.serializer(), answer))
        else WhyText().of(answer).forEach { out.println(withControlsShown(it)) }
    }

    private companion object {
        val JSON = Json { encodeDefaults = true }
    }
}
