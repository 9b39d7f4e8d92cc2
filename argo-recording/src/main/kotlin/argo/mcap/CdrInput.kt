package argo.mcap

import java.nio.BufferUnderflowException
import java.nio.ByteBuffer
import java.nio.ByteOrder

/**
 * Reads the values of a message in plain CDR, from the beginning to the end. Plain CDR is version 1 of XCDR (OMG DDS-XTypes 1.3, 7.4.1).
 * Functions throw [BufferUnderflowException] if the message ends too early. For one thread.
 */
internal class CdrInput(data: ByteArray) {
    private val bytes: ByteBuffer

    init {
        if (data.size < HEADER_BYTES) throw McapException("a message in CDR has at least $HEADER_BYTES bytes, and not ${data.size}")
        val form = data.take(2).joinToString("") { "%02x".format(it) }
        if (form != BIG && form != LITTLE) throw McapException("it is in the form $form of CDR, and only $BIG and $LITTLE can be read here")
        bytes = ByteBuffer.wrap(data, HEADER_BYTES, data.size - HEADER_BYTES).slice() // alignment counts from the end of the header
        bytes.order(if (form == LITTLE) ByteOrder.LITTLE_ENDIAN else ByteOrder.BIG_ENDIAN)
    }

    /** Moves to the next value of [size] bytes, which begins at a multiple of [size]. Returns the buffer. */
    fun at(size: Int): ByteBuffer {
        val place = (bytes.position() + size - 1) / size * size
        if (place > bytes.limit()) throw BufferUnderflowException()
        return bytes.position(place)
    }

    fun u8(): Int = bytes.get().toInt() and 0xFF

    fun skipByte() {
        if (bytes.hasRemaining()) bytes.get()
    }

    fun length(): Int = requireRoom(at(Int.SIZE_BYTES).getInt())

    /** Returns [length] if so many items of at least one byte can follow. */
    fun requireRoom(length: Int): Int = if (length in 0..bytes.remaining()) length else throw BufferUnderflowException()

    fun bytes(length: Int): ByteArray = ByteArray(length).also(bytes::get)

    /** Reads a text, which ends with a zero byte. The length counts this byte. */
    fun text(): String = bytes(length()).decodeToString().removeSuffix("\u0000")

    private companion object {
        const val HEADER_BYTES = 4
        const val BIG = "0000"
        const val LITTLE = "0001"
    }
}
