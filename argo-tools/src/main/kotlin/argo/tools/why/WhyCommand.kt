package argo.tools.why

import argo.mcap.McapReader
import argo.recording.replay.Recording
import argo.recording.why.Answer
import argo.recording.why.NotAnswer
import argo.recording.why.Question
import argo.recording.why.Why
import argo.tools.command.ExitStatus
import argo.tools.command.ToolException
import argo.tools.command.printable
import argo.tools.command.requireFile
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
    ],
)
internal class WhyCommand : JasonCommand() {
    @Parameters(index = "0", paramLabel = "FILE", description = ["a recording by an agent's argo_record"])
    private lateinit var file: Path

    @Parameters(index = "1", paramLabel = "QUESTION", description = ["a command: stop@12.3s, stop#3, stop or #17"])
    private lateinit var question: String

    @Option(names = ["--not"], description = ["tells why the command was not sent up to that second, or at all"])
    private var isNot = false

    @Option(names = ["--had"], paramLabel = "PERCEPT", description = ["shows what it would have sent with this percept; may be repeated"])
    private var had: List<String> = emptyList()

    @Option(names = ["--of"], paramLabel = "AGENT", description = ["asks about this agent; needed if there are several and --not is given"])
    private var of: String? = null

    override fun call(): Int {
        val asked = Question.of(question) ?: misuse("a question is a command such as stop@12.3s, not '$question'")
        if (isNot && had.isNotEmpty()) misuse("--not and --had exclude each other")
        if (isNot && asked.count != null) misuse("--not goes with a time, ${asked.text.ifEmpty { "stop" }}@12.3s, and not with a number")
        requireFile(file)
        if (!McapReader.isMcap(file)) throw ToolException("$file is no recording of an agent, which the option argo_record makes")
        if (!runsHere) return runElsewhere("$file", question)
        return Recording(file).use { recording ->
            val agent = of
            if (agent != null && agent !in recording.agents) {
                throw ToolException("$file has no agent $agent; those that it has: ${recording.agents.keys.joinToString()}")
            }
            Why(recording).use { if (isNot) printNot(it, recording, asked) else print(it, asked) }
            recording.problems.forEach { err.println("$file: ${printable(it)}") }
            if (recording.problems.isEmpty()) ExitStatus.DONE else ExitStatus.FAILED
        }
    }

    private fun print(why: Why, asked: Question) {
        val command = asked.find(why.commands.filter { of == null || it.agent == of })
        val answer = why.answer(command, isTrying = had.isEmpty())
        val all = if (had.isEmpty()) answer else answer.copy(had = had.map { why.had(command, it) })
        if (json) out.println(JSON.encodeToString(Answer.serializer(), all)) else WhyText().of(all).forEach { out.println(printable(it)) }
    }

    private fun printNot(why: Why, recording: Recording, asked: Question) {
        val agent = of ?: recording.agents.keys.singleOrNull()
            ?: misuse("--of names one of the agents: ${recording.agents.keys.joinToString()}")
        val answer = why.not(agent, asked)
        if (json) out.println(JSON.encodeToString(NotAnswer.serializer(), answer))
        else WhyText().of(answer).forEach { out.println(printable(it)) }
    }

    private companion object {
        val JSON = Json { encodeDefaults = true }
    }
}
