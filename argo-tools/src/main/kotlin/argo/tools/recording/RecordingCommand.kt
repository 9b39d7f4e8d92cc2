package argo.tools.recording

import argo.filters.withControlsShown
import argo.mcap.McapReader
import argo.recording.replay.ClockDifference
import argo.tools.command.DataCommand
import argo.tools.command.ExitStatus
import argo.tools.command.ToolException
import argo.tools.command.jsonOf
import argo.tools.command.nanosOf
import argo.tools.command.requireFile
import argo.tools.command.secondsIn
import argo.tools.command.withAll
import kotlinx.serialization.SerializationException
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonPrimitive
import picocli.CommandLine.Command
import picocli.CommandLine.Option
import picocli.CommandLine.Parameters
import java.math.BigDecimal
import java.nio.file.Path

@Command(
    name = "recording",
    description = [
        "Shows what a recording in the MCAP format (FILE.mcap) holds, with --messages each message, with --file a file inside.",
        "A bag of ROS 2 in that format is shown likewise, its messages in JSON.",
        "The messages of several recordings, as of a fleet's computers, are in one order: messages of agents show how the clocks differ.",
        "Of a recording that was cut off or is damaged it shows the whole parts; then the exit status is 1.",
    ],
)
internal class RecordingCommand : DataCommand() {
    @Parameters(arity = "1..*", paramLabel = "FILE", description = ["recordings, or bags of ROS 2, in the MCAP format"])
    private lateinit var files: List<Path>

    @Option(names = ["--messages"], description = ["prints the messages in their order, with their seconds since the first one"])
    private var wantsMessages = false

    @Option(names = ["--topic"], paramLabel = "TOPIC", description = ["only messages of this topic; may be given several times"])
    private var topics: Set<String>? = null

    @Option(names = ["--from"], paramLabel = "S", description = ["messages from this second on"])
    private var from: BigDecimal? = null

    @Option(names = ["--until"], paramLabel = "S", description = ["messages before this second"])
    private var until: BigDecimal? = null

    @Option(names = ["--file"], paramLabel = "NAME", description = ["prints the file of this name inside, and nothing else"])
    private var inside: String? = null

    private val texts = MessageTexts()

    override fun call(): Int {
        if (wantsMessages && inside != null) misuse("--messages and --file exclude each other")
        if (!wantsMessages && (topics != null || from != null || until != null)) misuse("--topic, --from and --until go with --messages")
        if (inside != null && files.size > 1) misuse("--file goes with one recording, not with ${files.size}")
        files.forEach(::requireFile)
        return withAll(files, { McapReader(it) }) { show(files.zip(it).toMap()) }
    }

    private fun show(recordings: Map<Path, McapReader>): Int {
        if (wantsMessages) printMessages(JointMessages(recordings), recordings) else recordings.forEach(::printContents)
        recordings.forEach { (file, one) -> one.problems.forEach { err.println("$file: ${withControlsShown(it)}") } }
        texts.problems.forEach { err.println(withControlsShown(it)) }
        return if (texts.problems.isEmpty() && recordings.values.all { it.isComplete }) ExitStatus.DONE else ExitStatus.FAILED
    }

    private fun printContents(file: Path, recording: McapReader) {
        val name = inside
        when {
            name != null -> printFile(file, recording, name)
            json -> out.println(RecordingContents(recording).json())
            else -> RecordingContents(recording).lines("$file").forEach { out.println(withControlsShown(it)) }
        }
    }

    private fun printFile(file: Path, recording: McapReader, name: String) {
        val found = recording.attachments.find { it.name == name }
        if (found == null) {
            val names = recording.attachments.joinToString { it.name }.ifEmpty { "none" }
            throw ToolException("$file holds no file $name; those that it holds: $names")
        }
        out.print(found.text)
    }

    private fun printMessages(joint: JointMessages, recordings: Map<Path, McapReader>) {
        val known = recordings.values.flatMap { one -> one.channels.map { it.topic } }
        val unknown = topics.orEmpty() - known.toSet()
        val file = files.joinToString()
        if (unknown.isNotEmpty()) throw ToolException("$file has no topic ${unknown.first()}; those that it has: ${known.joinToString()}")
        val start = joint.firstNs ?: return err.println("$file has no message")
        files.drop(1).forEach { err.println(clock(it, joint.differences[it])) }
        val begin = start.after(from) ?: start
        val end = start.after(until) ?: Long.MAX_VALUE
        if (end <= begin) misuse("--until is later than ${if (from == null) "0" else "--from"}")
        val printed = joint.between(begin, end, topics).onEach { print(it, start) }.count()
        if (printed == 0) err.println("$file has no such message in that time")
    }

    private fun clock(file: Path, difference: ClockDifference?) =
        if (difference == null) "$file: no message of agents connects it with ${files.first()}, so its times are those of its own clock"
        else "$file: compared with ${files.first()}, its clock is $difference"

    private fun print(timed: JointMessages.Timed, start: Long) {
        val message = timed.message
        val seconds = secondsIn(timed.ns - start)
        if (json) {
            val from = if (files.size == 1) emptyArray() else arrayOf("file" to "${timed.file}")
            val members = arrayOf("topic" to message.channel.topic, "seconds" to seconds, "ns" to message.logTimeNs)
            out.println(jsonOf(*from, *members, "message" to parsed(texts.of(message))))
        } else {
            val from = if (files.size == 1) "" else "${timed.file}  "
            val words = listOf(message.channel.topic, texts.of(message)).joinToString("  ", transform = ::withControlsShown)
            out.println("%9.3f s  %s%s".format(seconds, from, words))
        }
    }

    private fun parsed(text: String): JsonElement = try {
        Json.parseToJsonElement(text)
    } catch (_: SerializationException) {
        JsonPrimitive(text) // recordings of other programs may contain other formats
    }

    private fun Long.after(seconds: BigDecimal?): Long? = seconds?.let {
        val ns = nanosOf(it) ?: misuse("$it is no second of a recording")
        this + minOf(ns, Long.MAX_VALUE - this)
    }
}
