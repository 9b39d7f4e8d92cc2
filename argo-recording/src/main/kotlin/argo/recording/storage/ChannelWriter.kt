package argo.recording.storage

import argo.mcap.McapWriter

/** Writes messages of [RecordChannel]s with [writer], and adds each channel with its first message. For one thread. */
internal class ChannelWriter(private val writer: McapWriter) {
    private val schemas = HashMap<Pair<String, String>, Int>()
    private val channels = HashMap<RecordChannel, Int>()

    fun message(message: Encoded) {
        val channel = message.channel
        val number = channels.getOrPut(channel) {
            val schema = channel.schemaName to channel.jsonSchema
            writer.channel(channel.topic, schemas.getOrPut(schema) { writer.schema(channel.schemaName, channel.jsonSchema) })
        }
        writer.message(number, message.timeNs, message.timeNs, message.data)
    }
}
