package argo.mcap

import java.util.zip.CRC32

internal fun RecordBytes.schema(schema: McapSchema) =
    record(Op.SCHEMA) { u16(schema.id).text(schema.name).text(schema.encoding).text(schema.text) }

internal fun RecordBytes.channel(channel: McapChannel) = record(Op.CHANNEL) {
    u16(channel.id).u16(channel.schema?.id ?: 0).text(channel.topic).text(channel.messageEncoding).map(channel.metadata)
}

internal fun RecordBytes.attachment(name: String, mediaType: String, data: ByteArray, timeNs: Long) = record(Op.ATTACHMENT) {
    val from = size
    u64(timeNs).u64(timeNs).text(name).text(mediaType).u64(data.size.toLong()).bytes(data)
    u32(CRC32().apply { update(array(), from, size - from) }.value)
}

internal fun RecordBytes.messageIndex(channel: Int, entries: List<IndexEntry>) = record(Op.MESSAGE_INDEX) {
    u16(channel).sized { entries.forEach { u64(it.logTimeNs).u64(it.offset) } }
}
