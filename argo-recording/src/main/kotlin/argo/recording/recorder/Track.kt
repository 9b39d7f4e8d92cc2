package argo.recording.recorder

import argo.recording.CommandEnd
import argo.recording.Cycle
import argo.recording.PerceivedSnapshot
import argo.recording.storage.RecordChannel
import argo.recording.storage.RecordSink
import kotlinx.serialization.KSerializer
import kotlinx.serialization.json.Json
import java.util.concurrent.TimeUnit
import java.util.concurrent.atomic.AtomicBoolean

/** What [recording] holds of one agent, called [agent]. Any thread may call. */
internal class Track(private val agent: String, private val recording: SharedRecording, private val nanos: () -> Long) {
    private val sink: RecordSink = recording.sink
    private val cycles = channel("cycle", "argo.Cycle")
    private val snapshots = channel("snapshot", "argo.Snapshot")
    private val commands = channel("command", "argo.Command")
    private val marks = channel("mark", "argo.Mark")
    private val isClosed = AtomicBoolean()
    private val offsetNs = TimeUnit.MILLISECONDS.toNanos(System.currentTimeMillis()) - nanos()

    private fun channel(name: String, schema: String) = sink.channel("/$agent/$name", schema, SCHEMA)

    fun cycle(cycle: Cycle) = store(cycles, cycle.ns, Cycle.serializer(), cycle)

    fun snapshot(snapshot: PerceivedSnapshot) = store(snapshots, nanos(), PerceivedSnapshot.serializer(), snapshot)

    fun ended(command: CommandEnd) = store(commands, command.ns, CommandEnd.serializer(), command)

    /** The agent wants the recording because of [why]: a ring is saved, by another thread. */
    fun save(why: String, ns: Long) {
        sink.offer(marks, ns + offsetNs, Json.encodeToString(mapOf("why" to why)).encodeToByteArray())
        recording.save()
    }

    /** The agent ends. May be called twice. */
    fun close() {
        if (!isClosed.getAndSet(true)) recording.leave()
    }

    private fun <T> store(channel: RecordChannel, ns: Long, serializer: KSerializer<T>, value: T) {
        sink.offer(channel, ns + offsetNs, JSON.encodeToString(serializer, value).encodeToByteArray())
    }

    private companion object {
        val JSON = Json { encodeDefaults = false }
        const val SCHEMA = """{"type":"object"}"""
    }
}
