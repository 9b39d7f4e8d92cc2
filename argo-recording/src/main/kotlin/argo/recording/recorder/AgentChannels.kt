package argo.recording.recorder

import argo.recording.CommandEnd
import argo.recording.Cycle
import argo.recording.Input
import argo.recording.KeyFrame
import argo.recording.Mark
import argo.recording.ReflexEnd
import argo.recording.Refusal
import argo.recording.RunningRecording
import argo.recording.RunningRecordings
import argo.recording.agent.TermWriter
import argo.recording.compact
import argo.recording.jsonSchema
import argo.recording.storage.Encoded
import argo.recording.storage.RecordChannel
import argo.recording.storage.RecordSink
import argo.recording.texts
import kotlinx.serialization.KSerializer
import kotlinx.serialization.json.Json
import java.nio.file.Path
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.TimeUnit
import java.util.concurrent.atomic.AtomicBoolean

/**
 * Writes the part of [recording] about the agent called [agent]. Any thread may call the functions. The thread that stores the records
 * makes their texts.
 */
internal class AgentChannels(
    override val agent: String,
    private val recording: SharedRecording,
    private val nanos: () -> Long,
    private val warn: (String) -> Unit,
) : RunningRecording {
    private val sink: RecordSink = recording.sink
    private val cycles = channel("cycle", "argo.Cycle", Cycle.serializer())
    private val keyFrames = channel("keyframe", "argo.KeyFrame", KeyFrame.serializer())
    private val commands = channel("command", "argo.Command", CommandEnd.serializer())
    private val reflexes = channel("reflex", "argo.Reflex", ReflexEnd.serializer())
    private val marks = channel("mark", "argo.Mark", Mark.serializer())
    private val numbers = PerceptNumbers(agent, sink::channel) { warn("argo_record: $it") }
    private val isClosed = AtomicBoolean()

    /** The reasons of reported refusals. Of the refusals that the project's code causes, only the first is reported. */
    val told: MutableSet<String> = ConcurrentHashMap.newKeySet()
    private val isProjectTold = AtomicBoolean()
    private val offsetNs = TimeUnit.MILLISECONDS.toNanos(System.currentTimeMillis()) - nanos()

    init {
        RunningRecordings.add(this)
    }

    override val trouble: String? get() = sink.trouble

    override fun <T> read(use: (Path) -> T): T = recording.read(use)

    private fun channel(name: String, schema: String, serializer: KSerializer<*>) =
        sink.channel("/$agent/$name", schema, jsonSchema(serializer.descriptor))

    fun cycle(note: CycleNote) = store(cycles, note.ns, note.bytes, beside = { numbers.of(note.snapshots, offsetNs, note.ns + offsetNs) }) {
        val cycle = note.cycle()
        val refusal = refusalOfTerms(cycle.input) ?: cycle.refusal
        refusal?.let(::warnOf)
        json(Cycle.serializer(), cycle.copy(refusal = refusal).compact())
    }

    /** Returns the refusal of the first term of [input] that could not be written; null if all terms could be written. */
    private fun refusalOfTerms(input: Input): Refusal? = input.texts().find(TermWriter::isRefused)
        ?.let { Refusal("agent $agent got ${TermWriter.refusalOf(it)}, which a recording cannot hold") }

    private fun warnOf(refusal: Refusal) {
        val isNew = if (refusal.isOfProject) !isProjectTold.getAndSet(true) else told.add(refusal.why)
        if (isNew) warn("argo_record: ${refusal.why}; a replay${if (refusal.isOfProject) " without --check" else ""} ends there")
    }

    fun keyFrame(note: KeyFrameNote) = store(keyFrames, note.ns, note.size) { json(KeyFrame.serializer(), note.frame()) }

    fun ended(command: CommandEnd) = store(commands, command.ns, COMMAND_BYTES) { json(CommandEnd.serializer(), command) }

    fun ended(reflex: ReflexEnd) = store(reflexes, reflex.ns, COMMAND_BYTES) { json(ReflexEnd.serializer(), reflex) }

    fun attach(name: String, text: String) = sink.attach(name, "text/xml", text.encodeToByteArray())

    /**
     * Marks this point, at which the agent wants the recording saved because of [why]. If the recording is a ring, another thread saves it.
     * Returns false if the recording has ended, because nothing more can be stored.
     */
    fun save(why: String, ns: Long): Boolean {
        if (trouble != null) return false
        store(marks, ns, why.length) { json(Mark.serializer(), Mark(why)) }
        recording.save()
        return true
    }

    fun close() {
        if (isClosed.getAndSet(true)) return
        RunningRecordings.remove(this)
        recording.leave()
    }

    private fun store(
        channel: RecordChannel,
        ns: Long,
        bytes: Int,
        beside: () -> List<Encoded> = ::emptyList,
        encode: () -> ByteArray,
    ) {
        sink.offer(channel, ns + offsetNs, bytes, beside, encode)
    }

    private fun <T> json(serializer: KSerializer<T>, value: T) = JSON.encodeToString(serializer, value).encodeToByteArray()

    private val CycleNote.bytes get() = CYCLE_BYTES + percepts * PERCEPT_BYTES

    private companion object {
        val JSON = Json { encodeDefaults = false }

        const val CYCLE_BYTES = 500
        const val PERCEPT_BYTES = 100
        const val COMMAND_BYTES = 100
    }
}
