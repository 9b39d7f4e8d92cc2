package argo.mcap

import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.util.zip.CRC32

/** A growing buffer that writes values in MCAP's formats. Numbers are little-endian. Texts and maps begin with their length. */
internal class RecordBytes(capacity: Int = 256) {
    private var buffer = ByteBuffer.allocate(capacity).order(ByteOrder.LITTLE_ENDIAN)

    val size: Int get() = buffer.position()

    fun u8(value: Int) = apply { room(1).put(value.toByte()) }

    fun u16(value: Int) = apply { room(2).putShort(value.toShort()) }

    fun u32(value: Long) = apply { room(4).putInt(value.toInt()) }

    fun u64(value: Long) = apply { room(8).putLong(value) }

    fun bytes(data: ByteArray, from: Int = 0, length: Int = data.size) = apply { room(length).put(data, from, length) }

    fun text(value: String) = apply {
        val bytes = value.encodeToByteArray()
        u32(bytes.size.toLong()).bytes(bytes)
    }

    /** Writes the bytes that [write] makes, preceded by their length in four bytes. */
    fun sized(write: RecordBytes.() -> Unit) = apply {
        val at = size
        u32(0).write()
        buffer.putInt(at, size - at - 4)
    }

    fun map(values: Map<String, String>) = sized { values.forEach { (name, value) -> text(name).text(value) } }

    fun record(op: Int, write: RecordBytes.() -> Unit) = apply {
        val at = u8(op).size
        u64(0).write()
        buffer.putLong(at, (size - at - 8).toLong())
    }

    fun clear() = apply { buffer.clear() }

    /** Returns the array with the bytes. Only the first [size] bytes of the array are in use. */
    fun array(): ByteArray = buffer.array()

    /** Returns the bytes as a buffer to read. The next call of this object changes the buffer. */
    fun toRead(): ByteBuffer = buffer.duplicate().flip()

    private fun room(bytes: Int): ByteBuffer {
        if (buffer.remaining() < bytes) {
            val larger = ByteBuffer.allocate(maxOf(buffer.capacity() * 2, size + bytes)).order(ByteOrder.LITTLE_ENDIAN)
            buffer = larger.put(buffer.flip())
        }
        return buffer
    }
}

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
