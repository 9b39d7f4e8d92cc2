package argo.mcap

import java.nio.ByteBuffer

private fun ByteBuffer.need(bytes: Long) {
    if (bytes < 0 || bytes > remaining()) throw McapException("a record is shorter than its fields")
}

internal fun ByteBuffer.u16(): Int {
    need(Short.SIZE_BYTES.toLong())
    return short.toInt() and 0xFFFF
}

internal fun ByteBuffer.u32(): Long {
    need(Int.SIZE_BYTES.toLong())
    return int.toLong() and 0xFFFF_FFFFL
}

/** Reads a number for a length, a place or a time. Refuses values from 2^63 on, which no file or clock reaches. */
internal fun ByteBuffer.u64(): Long {
    need(Long.SIZE_BYTES.toLong())
    return long.also { if (it < 0) throw McapException("a record has a number that is too large") }
}

internal fun ByteBuffer.bytes(length: Long): ByteArray {
    need(length)
    return ByteArray(length.toInt()).also { get(it) }
}

internal fun ByteBuffer.part(length: Long): ByteBuffer {
    need(length)
    return slice(position(), length.toInt()).order(order()).also { position(position() + length.toInt()) }
}

internal fun ByteBuffer.text(): String = bytes(u32()).decodeToString()

internal fun ByteBuffer.map(): Map<String, String> {
    val entries = part(u32())
    return buildMap { while (entries.hasRemaining()) put(entries.text(), entries.text()) }
}

internal inline fun ByteBuffer.forEachRecord(take: (op: Int, content: ByteBuffer) -> Unit) {
    while (hasRemaining()) {
        val op = get().toInt() and 0xFF
        take(op, part(u64()))
    }
}
