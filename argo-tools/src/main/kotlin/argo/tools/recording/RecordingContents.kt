package argo.tools.recording

import argo.mcap.McapChannel
import argo.mcap.McapReader
import argo.tools.command.counted
import argo.tools.command.jsonArrayOf
import argo.tools.command.jsonOf
import argo.tools.command.secondsIn
import argo.tools.command.table
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive

/**
 * A channel and the number of its messages. [first] and [last] are the times of its first and last message, in s from the recording's
 * start.
 */
private class ChannelContents(val channel: McapChannel, val messages: Long, val first: Double?, val last: Double?)

internal class RecordingContents(private val recording: McapReader) {
    private val times = recording.times
    private val seconds = times?.let { secondsIn(it.last - it.first) } ?: 0.0
    private val channels = channels()

    private fun channels(): List<ChannelContents> {
        val counts = HashMap<Int, Long>()
        val ranges = HashMap<Int, LongRange>()
        recording.messages().forEach { message ->
            counts.merge(message.channel.id, 1, Long::plus)
            val time = message.logTimeNs
            ranges.merge(message.channel.id, time..time) { all, _ -> minOf(all.first, time)..maxOf(all.last, time) }
        }
        fun since(time: Long?) = time?.let { secondsIn(it - (times?.first ?: it)) }
        return recording.channels.map { channel ->
            val range = ranges[channel.id]
            ChannelContents(channel, counts[channel.id] ?: 0, since(range?.first), since(range?.last))
        }
    }

    fun lines(name: String): List<String> = buildList {
        val state = if (recording.isComplete) "complete" else "not complete"
        val library = recording.library.ifEmpty { "an unknown program" }
        add("$name: ${counted(recording.messageCount, "message")} in ${clock(seconds)}, written by $library, $state")
        addAll(
            table(
                listOf("TOPIC", "SCHEMA", "MESSAGES", "FIRST", "LAST"),
                channels.map {
                    listOf(it.channel.topic, it.channel.schema?.name ?: "-", "${it.messages}", clock(it.first), clock(it.last))
                },
            ),
        )
        addAll(table(listOf("FILE", "TYPE", "BYTES"), recording.attachments.map { listOf(it.name, it.mediaType, "${it.data.size}") }))
        recording.metadata.forEach { of -> add("${of.name}: ${of.values.entries.joinToString { (name, value) -> "$name=$value" }}") }
    }

    fun json(): JsonObject = jsonOf(
        "messages" to recording.messageCount, "seconds" to seconds, "library" to recording.library, "complete" to recording.isComplete,
        "problems" to recording.problems,
        "channels" to jsonArrayOf(
            channels.map {
                jsonOf(
                    "topic" to it.channel.topic, "schema" to it.channel.schema?.name, "messages" to it.messages,
                    "first" to it.first, "last" to it.last,
                )
            },
        ),
        "files" to jsonArrayOf(recording.attachments.map { jsonOf("name" to it.name, "type" to it.mediaType, "bytes" to it.data.size) }),
        "metadata" to JsonObject(
            recording.metadata.associate { of -> of.name to JsonObject(of.values.mapValues { JsonPrimitive(it.value) }) },
        ),
    )

    private fun clock(seconds: Double?) = seconds?.let { "%.3f s".format(it) } ?: "-"
}
