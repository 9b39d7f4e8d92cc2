package argo.mcap

import java.nio.ByteBuffer
import java.nio.ByteOrder

/**
 * The compression `lz4` of MCAP: LZ4 frames (https://github.com/lz4/lz4/blob/dev/doc/lz4_Frame_format.md). Writes independent blocks
 * without checksums, since a chunk has its own checksum. For one thread.
 *
 * Programs that use MCAP's libraries in C++ or Python write blocks that refer to earlier blocks. The Java library lz4-java refuses frames
 * with dependent blocks. Aircompressor, which unpacks Zstandard here, reads no frames of LZ4.
 */
internal class Lz4 {
    private val places = IntArray(1 shl HASH_BITS)

    fun compress(data: ByteArray, length: Int): RecordBytes {
        val frame = RecordBytes(length / 2).bytes(HEAD)
        var at = 0
        while (at < length) {
            val end = minOf(at + MAX_BLOCK_BYTES, length)
            val block = block(data, at, end)
            if (block.size < end - at) frame.u32(block.size.toLong()).bytes(block.array(), 0, block.size)
            else frame.u32((end - at).toLong() or UNCOMPRESSED).bytes(data, at, end - at)
            at = end
        }
        return frame.u32(0)
    }

    private fun block(data: ByteArray, from: Int, end: Int): RecordBytes {
        val block = RecordBytes((end - from) / 2)
        places.fill(-1)
        var literals = from
        var at = from
        while (at < end - LAST_MATCH) {
            val next = int(data, at)
            val hash = (next * HASH_FACTOR) ushr (Int.SIZE_BITS - HASH_BITS)
            val before = places[hash]
            places[hash] = at
            if (before < 0 || at - before > MAX_OFFSET || int(data, before) != next) {
                at++
                continue
            }
            var length = MIN_MATCH
            while (at + length < end - LAST_LITERALS && data[before + length] == data[at + length]) length++
            block.sequence(data, literals, at, at - before, length - MIN_MATCH)
            at += length
            literals = at
        }
        return block.sequence(data, literals, end, 0, 0)
    }

    /** Writes the bytes of [data] from [from] up to [until], and a match at [offset]. If [offset] is 0, writes no match. */
    private fun RecordBytes.sequence(data: ByteArray, from: Int, until: Int, offset: Int, more: Int): RecordBytes {
        val literals = until - from
        u8((minOf(literals, NIBBLE) shl NIBBLE_BITS) or minOf(more, NIBBLE))
        rest(literals)
        bytes(data, from, literals)
        if (offset > 0) u16(offset).rest(more)
        return this
    }

    private fun RecordBytes.rest(length: Int) {
        if (length < NIBBLE) return
        var rest = length - NIBBLE
        while (rest >= FULL_BYTE) {
            u8(FULL_BYTE)
            rest -= FULL_BYTE
        }
        u8(rest)
    }

    private fun int(data: ByteArray, at: Int) =
        (data[at].toInt() and 0xFF) or (data[at + 1].toInt() and 0xFF shl 8) or (data[at + 2].toInt() and 0xFF shl 16) or
            (data[at + 3].toInt() shl 24)

    companion object {
        const val NAME = "lz4"

        /** The head of a frame: magic number, flags for independent blocks of at most 4 MB, checksum of the flags. */
        private val HEAD = byteArrayOf(0x04, 0x22, 0x4D, 0x18, 0x60, 0x70, 0x73)
        private const val MAGIC_NUMBER = 0x184D2204
        private const val MAX_BLOCK_BYTES = 4 shl 20
        private const val UNCOMPRESSED = 0x80000000L
        private const val HASH_BITS = 14
        private const val HASH_FACTOR = -1640531535
        private const val MAX_OFFSET = 0xFFFF
        private const val MIN_MATCH = 4
        private const val LAST_MATCH = 12 // a match must begin at least so many bytes before the end
        private const val LAST_LITERALS = 5
        private const val NIBBLE = 15
        private const val NIBBLE_BITS = 4
        private const val FULL_BYTE = 255

        /**
         * Returns the [length] unpacked bytes of [frame]. Reads any frame without a dictionary, and ignores its checksums.
         *
         * @throws McapException if [frame] does not contain [length] bytes
         */
        fun decompress(frame: ByteBuffer, length: Int): ByteBuffer = try {
            Frame(frame.order(ByteOrder.LITTLE_ENDIAN), ByteArray(length)).read()
        } catch (_: java.nio.BufferUnderflowException) {
            throw McapException("its compressed bytes are cut off")
        } catch (_: IndexOutOfBoundsException) {
            throw McapException("its compressed bytes are damaged")
        }
    }

    private class Frame(private val bytes: ByteBuffer, private val target: ByteArray) {
        private var size = 0

        fun read(): ByteBuffer {
            if (bytes.getInt() != MAGIC_NUMBER) throw McapException("its compressed bytes are no frame of LZ4")
            val flags = bytes.get().toInt()
            bytes.get()
            if (flags and HAS_CONTENT_SIZE != 0) bytes.getLong()
            if (flags and HAS_DICTIONARY != 0) throw McapException("it needs a dictionary of LZ4")
            bytes.get()
            while (true) {
                val head = bytes.getInt()
                if (head == 0) break
                val length = head and Int.MAX_VALUE
                if (head < 0) literals(length) else block(bytes.position() + length)
                if (flags and HAS_BLOCK_CHECKSUMS != 0) bytes.getInt()
            }
            if (size != target.size) throw McapException("it has $size bytes instead of ${target.size}")
            return ByteBuffer.wrap(target).order(ByteOrder.LITTLE_ENDIAN)
        }

        private fun block(end: Int) {
            while (true) {
                val token = bytes.get().toInt() and 0xFF
                literals(length(token shr NIBBLE_BITS))
                if (bytes.position() >= end) return
                val offset = bytes.getShort().toInt() and 0xFFFF
                val from = size - offset
                if (offset == 0) throw McapException("its compressed bytes are damaged")
                repeat(length(token and NIBBLE) + MIN_MATCH) { target[size++] = target[from + it] }
            }
        }

        private fun literals(length: Int) {
            if (length > target.size - size) throw IndexOutOfBoundsException()
            bytes.get(target, size, length)
            size += length
        }

        private fun length(nibble: Int): Int {
            var length = nibble
            if (nibble < NIBBLE) return length
            while (true) {
                val more = bytes.get().toInt() and 0xFF
                length += more
                if (more < FULL_BYTE) return length
            }
        }

        private companion object {
            const val HAS_CONTENT_SIZE = 0x08
            const val HAS_DICTIONARY = 0x01
            const val HAS_BLOCK_CHECKSUMS = 0x10
        }
    }
}
