package argo.recording.replay

import argo.mcap.McapReader
import argo.platform.pathOf
import argo.recording.Beginning
import argo.recording.CONFIG
import argo.recording.CommandEnd
import argo.recording.Cycle
import argo.recording.FORMAT
import argo.recording.FORMATS
import argo.recording.KeyFrame
import argo.recording.RecordedAgent
import argo.recording.ReflexEnd
import argo.recording.Refusal
import argo.recording.agentMetadata
import argo.recording.includeMetadata
import argo.recording.isProgram
import argo.recording.whole
import kotlinx.serialization.KSerializer
import kotlinx.serialization.json.Json
import java.io.IOException
import java.nio.file.Path
import java.time.Duration
import kotlin.io.path.isRegularFile
import kotlin.io.path.readBytes

/**
 * A recording of agents. For one thread.
 *
 * @throws IOException if the file cannot be read
 * @throws RecordingException if the file is no recording of agents, or has a newer version
 */
class Recording(private val file: Path) : AutoCloseable {
    private val reader = McapReader(file)
    private val starts = HashMap<String, List<KeyFrame>>()
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

    /**
     * A file that an agent has included, or has tried to include.
     *
     * @property within the file of the program that includes this file
     * @property name the name of this file in the directive `include`
     * @property address Jason's address of the included file
     * @property text the content of the included file; null if the file was missing
     */
    internal class Include(val within: String, val name: String, val address: String, val text: ByteArray?)

    /**
     * Returns the files that [agent] has included, in the order in which it included them.
     *
     * @throws RecordingException if the recording lacks the content of a file
     */
    internal fun includes(agent: String): List<Include> = generateSequence(1) { it + 1 }
        .map { metadata[includeMetadata(agent, it)] }.takeWhile { it != null }.filterNotNull().map { values ->
            val text = values["file"]?.let { name ->
                program[name]?.takeIf { isProgram(name) } ?: throw RecordingException("$file does not hold the file $name of agent $agent")
            }
            Include(values["within"].orEmpty(), values["name"].orEmpty(), values["address"].orEmpty(), text)
        }.toList()

    /**
     * Returns the program files and included files that differ from the recording. Compares with the files on this computer's disks.
     *
     * @throws RecordingException if the recording lacks the content of a file
     */
    fun changedFiles(): List<Path> {
        val programs = agents.values.mapNotNull { agent -> agent.address?.let { it to program[agent.source] } }
        val includes = agents.keys.flatMap(::includes).map { it.address to it.text }
        return (programs + includes).mapNotNull { (address, text) ->
            pathOf(address)?.takeIf { it.isRegularFile() && !it.readBytes().contentEquals(text) }
        }.distinct()
    }

    /**
     * One sentence for each unreadable part of the file. After 100 sentences, one last sentence says that there are others. The readable
     * parts can be replayed.
     */
    val problems: List<String> get() = reader.problems

    private fun checkFormat() {
        val format = metadata["argo.recording"]?.get("format")
        if (format == null || metadata.keys.none { it.startsWith(agentMetadata("")) }) {
            throw RecordingException("$file holds no agent; the option argo_record=\"FILE.mcap\" of an agent in the .mas2j records it")
        }
        if (format !in FORMATS) {
            throw RecordingException(
                "$file has format $format of agents' recordings, and this version of ARGO reads format $FORMAT; a newer one may read it",
            )
        }
    }

    /** Returns the cycles of [agent], in their order. If [last] is given, returns only the cycles in the last part of this length. */
    fun cycles(agent: String, last: Duration? = null): Sequence<Cycle> =
        messages("/$agent/cycle", Cycle.serializer(), last).map { cycle -> readable("/$agent/cycle") { cycle.whole() } }

    /** Returns the key frames of [agent], at which a replay may begin, and the reasons for missing key frames, in their order. */
    fun keyFrames(agent: String): Sequence<KeyFrame> = messages("/$agent/keyframe", KeyFrame.serializer(), last = null)

    /**
     * Returns the first key frame of [agent] if the agent's beginning is missing. A replay then begins at this key frame. Returns null if a
     * replay begins with the agent's first cycle, or if there is no key frame.
     */
    fun start(agent: String): KeyFrame? = starts.getOrPut(agent) {
        val first = cycles(agent).firstOrNull()?.index ?: return null
        listOfNotNull(if (first <= 1) null else keyFrames(agent).firstOrNull { it.missing == null && it.index >= first - 1 })
    }.firstOrNull()

    /** Returns the cycles of [agent] after its [start], in their order. Only these cycles can be replayed. */
    fun replayable(agent: String): Sequence<Cycle> {
        val index = start(agent)?.index ?: return cycles(agent)
        return cycles(agent).filter { it.index > index }
    }

    /** The beginning of the first recorded cycle of any agent, in ns of the agents' clock; null if there is none. Times count from here. */
    val firstNs: Long? by lazy { agents.keys.mapNotNull { cycles(it).firstOrNull()?.ns }.minOrNull() }

    /**
     * Refuses [cycle] of [agent] if no replay can repeat it. Also refuses a gap: [cycle] must directly follow the cycle with the index
     * [last]. If [last] is 0, [cycle] must be the first. If [isCarryingOut] is true, the replay carries out the project's code, so it can
     * repeat more cycles.
     *
     * @throws RecordingException if [cycle] is refused
     */
    internal fun requireNext(agent: String, cycle: Cycle, last: Long, isCarryingOut: Boolean = false) {
        cycle.refusal?.let { if (!isCarryingOut || !it.isOfProject) throw RecordingException("${RefusedCycle(agent, cycle, it)}") }
        if (cycle.index == last + 1) return
        throw RecordingException(if (last == 0L) beginningMissing(agent, cycle) else gap(agent, cycle, last))
    }

    private fun beginningMissing(agent: String, cycle: Cycle): String {
        val reasons = keyFrames(agent).mapNotNull { it.missing }.groupingBy { it }.eachCount().maxByOrNull { it.value }?.key
        return "the recording of agent $agent begins with its cycle ${cycle.index}, the agent's beliefs then are not known, and there " +
            "is no key frame to begin with" + when (reasons) {
                null -> "; keep more minutes, argo_record=\"last(10)\", or record from the beginning on, argo_record=\"FILE.mcap\""
                else -> ": each time that one was due, something that cannot be described was under way, mostly: $reasons. Keep more " +
                    "minutes, argo_record=\"last(10)\", let the agent come to rest now and then, or record from the beginning on, " +
                    "argo_record=\"FILE.mcap\""
            }
    }

    /**
     * Returns the outcomes of the commands of [agent], in the order in which they became known. If [last] is given, returns only the
     * outcomes in the recording's last part of this length.
     */
    fun commandEnds(agent: String, last: Duration? = null): Sequence<CommandEnd> =
        messages("/$agent/command", CommandEnd.serializer(), last)

    /** Returns the outcomes of the reflexes of [agent], in the order in which they became known. */
    fun reflexEnds(agent: String): Sequence<ReflexEnd> = messages("/$agent/reflex", ReflexEnd.serializer(), last = null)

    private fun <T> messages(topic: String, serializer: KSerializer<T>, last: Duration?): Sequence<T> {
        val from = last?.let { (reader.times?.last ?: 0) - it.toNanos() } ?: 0
        return reader.messages(from, topics = setOf(topic)).map { readable(topic) { JSON.decodeFromString(serializer, it.text) } }
    }

    private fun <T> readable(topic: String, read: () -> T): T = try {
        read()
    } catch (broken: IllegalArgumentException) {
        throw unreadable(topic, broken)
    } catch (broken: IndexOutOfBoundsException) {
        throw unreadable(topic, broken)
    }

    private fun unreadable(topic: String, why: Exception) = RecordingException("$file: a message of $topic cannot be read: ${why.message}")

    private fun agentOf(name: String, values: Map<String, String>): RecordedAgent {
        fun value(key: String) = values[key] ?: throw RecordingException("$file does not hold the $key of agent $name")
        return RecordedAgent(
            name, value("source"), value("agentClass"), value("archClass"), value("beliefBase"),
            values.after(OPTION),
            value("isConditional").toBoolean(), values["address"]?.takeIf { it.isNotEmpty() },
            values["beginning"]?.let { readable(agentMetadata(name)) { JSON.decodeFromString(Beginning.serializer(), it) } },
            values["firstLabel"]?.toIntOrNull(), values.after("config.").filterKeys { it in CONFIG },
        )
    }

    private fun Map<String, String>.after(prefix: String) =
        filterKeys { it.startsWith(prefix) }.mapKeys { (key, _) -> key.removePrefix(prefix) }

    override fun close() = reader.close()

    private companion object {
        const val OPTION = "option."

        /** Ignores unknown fields, since a later version of ARGO may write more. */
        val JSON = Json { ignoreUnknownKeys = true }
    }
}

/**
 * A cycle that no replay can repeat. The replay of [agent] ends before this cycle.
 *
 * @property cycle Jason's number of the cycle
 * @property ns the beginning of the cycle, in ns of the agent's clock
 * @property why the reason, in words
 */
data class RefusedCycle(val agent: String, val cycle: Int, val ns: Long, val why: String) {
    internal constructor(agent: String, cycle: Cycle, refusal: Refusal) : this(
        agent, cycle.number, cycle.ns,
        refusal.why + if (refusal.isOfProject) "; only replay --check, which carries the project's code out again, goes on" else "",
    )

    override fun toString() = "agent $agent can be replayed only until its cycle $cycle: $why"
}

/** Reports that a recording cannot be replayed. [message] contains the reason and the remedy. */
class RecordingException(message: String) : IOException(message)

/**
 * Returns the exception for [failed], which has ended a replay. If a text is unreadable or a term is nested too deeply, returns a
 * [RecordingException], else [failed] itself.
 */
internal fun refusalOf(failed: Throwable): Throwable = when (failed) {
    is IllegalArgumentException -> RecordingException("a text of the recording cannot be read: ${failed.message}")
    is StackOverflowError -> RecordingException("a term or a rule of the recording is nested too deeply")
    else -> failed
}
