package argo.mcap

import java.nio.ByteBuffer
import java.nio.ByteOrder

/** Bytes that grow, and are written in the number formats of MCAP: little-endian, texts and maps behind their length. */
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

    /** What [write] writes, behind its length in four bytes. */
    fun sized(write: RecordBytes.() -> Unit) = apply {
        val at = size
        u32(0).write()
        buffer.putInt(at, size - at - 4)
    }

    fun map(values: Map<String, String>) = sized { values.forEach { (name, value) -> text(name).text(value) } }

    /** A record of kind [op] whose content [write] writes. */
    fun record(op: Int, write: RecordBytes.() -> Unit) = apply {
        val at = u8(op).size
        u64(0).write()
        buffer.putLong(at, (size - at - 8).toLong())
    }

    fun clear() = apply { buffer.clear() }

    /** The array that holds the bytes, of which the first [size] are in use. */
    fun array(): ByteArray = buffer.array()

    /** The bytes as a buffer to be read. It changes with the next call. */
    fun toRead(): ByteBuffer = buffer.duplicate().flip()

    private fun room(bytes: Int): ByteBuffer {
        if (buffer.remaining() < bytes) {
            val larger = ByteBuffer.allocate(maxOf(buffer.capacity() * 2, size + bytes)).order(ByteOrder.LITTLE_ENDIAN)
            buffer = larger.put(buffer.flip())
        }
        return buffer
    }
}
