package argo.tools.recording

import argo.mcap.McapChannel
import argo.mcap.McapException
import argo.mcap.McapMessage
import argo.mcap.McapReader
import argo.mcap.RosMessages
import argo.tools.command.DataCommand
import argo.tools.command.ExitStatus
import argo.tools.command.ToolException
import argo.tools.command.jsonOf
import argo.tools.command.nanosOf
import argo.tools.command.printable
import argo.tools.command.requireFile
import argo.tools.command.secondsIn
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
        "Shows what a recording in the MCAP format (FILE.mcap) holds, or a bag of ROS 2 in that format: with --messages each message, " +
            "with --file a file inside.",
        "Of a recording that was cut off or is damaged it shows the whole parts; then the exit status is 1.",
    ],
)
internal class RecordingCommand : DataCommand() {
    @Parameters(index = "0", paramLabel = "FILE", description = ["a recording or a bag in the MCAP format"])
    private lateinit var file: Path

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

    override fun call(): Int {
        if (wantsMessages && inside != null) misuse("--messages and --file exclude each other")
        if (!wantsMessages && (topics != null || from != null || until != null)) misuse("--topic, --from and --until go with --messages")
        requireFile(file)
        return McapReader(file).use { recording ->
            val name = inside
            when {
                name != null -> printFile(recording, name)
                wantsMessages -> printMessages(recording)
                json -> out.println(RecordingContents(recording).json())
                else -> RecordingContents(recording).lines("$file").forEach { out.println(printable(it)) }
            }
            val problems = recording.problems + unread
            problems.forEach { err.println("$file: ${printable(it)}") }
            if (problems.isEmpty()) ExitStatus.DONE else ExitStatus.FAILED
        }
    }

    private fun printFile(recording: McapReader, name: String) {
        val found = recording.attachments.find { it.name == name }
        if (found == null) {
            val names = recording.attachments.joinToString { it.name }.ifEmpty { "none" }
            throw ToolException("$file holds no file $name; those that it holds: $names")
        }
        out.print(found.text)
    }

    private fun printMessages(recording: McapReader) {
        val unknown = topics.orEmpty() - recording.channels.map { it.topic }.toSet()
        if (unknown.isNotEmpty()) {
            throw ToolException("$file has no topic ${unknown.first()}; those that it has: ${recording.channels.joinToString { it.topic }}")
        }
        val start = recording.times?.first ?: return err.println("$file has no message")
        val begin = start.after(from) ?: start
        val end = start.after(until) ?: Long.MAX_VALUE
        if (end <= begin) misuse("--until is later than ${if (from == null) "0" else "--from"}")
        val printed = recording.messages(begin, end, topics).onEach { print(it, start) }.count()
        if (printed == 0) err.println("$file has no such message in that time")
    }

    private val unread = LinkedHashSet<String>()
    private val bag = HashMap<Int, RosMessages?>() // the types of ROS 2, by channel; null: it is another's, or cannot be read

    /** Returns [message] as text; one of ROS 2 in JSON. */
    private fun textOf(message: McapMessage): String = bag.getOrPut(message.channel.id) { typeOf(message.channel) }?.let { type ->
        try {
            "${type.read(message.data)}"
        } catch (unreadable: McapException) {
            "(${message.data.size} bytes)".also { unread += "messages of ${message.channel.topic} are left out: ${unreadable.message}" }
        }
    } ?: message.text

    private fun typeOf(channel: McapChannel): RosMessages? = try {
        RosMessages.of(channel)
    } catch (unreadable: McapException) {
        null.also { unread += "messages of ${channel.topic} are shown as they are: ${unreadable.message}" }
    }

    private fun print(message: McapMessage, start: Long) {
        val seconds = secondsIn(message.logTimeNs - start)
        if (json) {
            val members = arrayOf("topic" to message.channel.topic, "seconds" to seconds, "ns" to message.logTimeNs)
            out.println(jsonOf(*members, "message" to parsed(textOf(message))))
        } else {
            out.println("%9.3f s  %s  %s".format(seconds, printable(message.channel.topic), printable(textOf(message))))
        }
    }

    private fun parsed(text: String): JsonElement = try {
        Json.parseToJsonElement(text)
    } catch (_: SerializationException) {
        JsonPrimitive(text) // another program's recording may contain other formats
    }

    private fun Long.after(seconds: BigDecimal?): Long? = seconds?.let {
        val ns = nanosOf(it) ?: misuse("$it is no second of a recording")
        this + minOf(ns, Long.MAX_VALUE - this)
    }
}
