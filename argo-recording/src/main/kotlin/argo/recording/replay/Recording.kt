package argo.recording.replay

import argo.mcap.McapReader
import argo.recording.CommandEnd
import argo.recording.Cycle
import argo.recording.FORMAT
import argo.recording.RecordedAgent
import argo.recording.agentMetadata
import argo.recording.whole
import kotlinx.serialization.KSerializer
import kotlinx.serialization.json.Json
import java.io.IOException
import java.nio.file.Path

/**
 * A recording of agents. For one thread.
 *
 * @param file the file
 * @throws IOException if it cannot be read
 * @throws RecordingException if it is no recording of agents, or of a newer version
 */
class Recording(private val file: Path) : AutoCloseable {
    private val reader = McapReader(file)
    private val metadata = reader.metadata.associate { it.name to it.values }

    init {
        try {
            checkFormat()
        } catch (refused: RecordingException) {
            reader.close()
            throw refused
        }
    }

    /** The agents, by their names. */
    val agents: Map<String, RecordedAgent> = metadata.filterKeys { it.startsWith(agentMetadata("")) }
        .map { (name, values) -> agentOf(name.removePrefix(agentMetadata("")), values) }.associateBy { it.name }

    /** The files of the agents' programs, by the names of the attachments. */
    val program: Map<String, ByteArray> = reader.attachments.associate { it.name to it.data }

    /** What of the file cannot be read, for a person: one sentence for each place, of many the first. The rest can be replayed. */
    val problems: List<String> get() = reader.problems

    private fun checkFormat() {
        val format = metadata["argo.recording"]?.get("format")
        if (format == null || metadata.keys.none { it.startsWith(agentMetadata("")) }) {
            throw RecordingException("$file holds no agent; the option argo_record=\"FILE.mcap\" of an agent in the .mas2j records it")
        }
        if (format != FORMAT) {
            throw RecordingException(
                "$file has format $format of what agents do, and this version of ARGO reads format $FORMAT; a newer version may read it",
            )
        }
    }

    /** The cycles of [agent], in their order. */
    fun cycles(agent: String): Sequence<Cycle> = messages("/$agent/cycle", Cycle.serializer()).map(Cycle::whole)

    /** What became of the commands of [agent], in the order in which that was known. */
    fun commandEnds(agent: String): Sequence<CommandEnd> = messages("/$agent/command", CommandEnd.serializer())

    private fun <T> messages(topic: String, serializer: KSerializer<T>): Sequence<T> =
        reader.messages(topics = setOf(topic)).map { JSON.decodeFromString(serializer, it.data.decodeToString()) }

    private fun agentOf(name: String, values: Map<String, String>): RecordedAgent {
        fun value(key: String) = values[key] ?: throw RecordingException("$file does not hold the $key of agent $name")
        return RecordedAgent(
            name, value("source"), value("agentClass"), value("archClass"), value("beliefBase"),
            values.filterKeys { it.startsWith(OPTION) }.mapKeys { (key, _) -> key.removePrefix(OPTION) },
            value("isConditional").toBoolean(),
        )
    }

    override fun close() = reader.close()

    private companion object {
        const val OPTION = "option."

        /** A later version may know more. */
        val JSON = Json { ignoreUnknownKeys = true }
    }
}

/** A recording cannot be replayed; [message] has what was found and what to do. */
class RecordingException(message: String) : IOException(message)
