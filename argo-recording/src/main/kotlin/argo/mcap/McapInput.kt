package argo.mcap

import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.nio.channels.FileChannel
import java.nio.file.Path
import java.nio.file.StandardOpenOption
import java.util.zip.CRC32

/** Reads parts of a file. For one thread. */
internal class McapInput(val path: Path) : AutoCloseable {
    private val file = FileChannel.open(path, StandardOpenOption.READ)

    val size = file.size()

    fun read(at: Long, length: Long): ByteBuffer {
        if (length > MAX_RECORD_BYTES) throw McapException("a record of $length bytes, more than $MAX_RECORD_BYTES")
        val bytes = ByteBuffer.allocate(length.toInt()).order(ByteOrder.LITTLE_ENDIAN)
        while (bytes.hasRemaining()) {
            if (file.read(bytes, at + bytes.position()) < 0) throw McapException("$path has become shorter while it was read")
        }
        return bytes.flip()
    }

    fun checksum(at: Long, length: Long): Long {
        val checksum = CRC32()
        for (from in 0 until length step BLOCK_BYTES) checksum.update(read(at + from, minOf(BLOCK_BYTES, length - from)))
        return checksum.value
    }

    override fun close() = file.close()

    companion object {
        /** The longest readable record. Longer records are refused, so that a damaged length does not fill the memory. */
        const val MAX_RECORD_BYTES = 64L * 1024 * 1024

        private const val BLOCK_BYTES = 64L * 1024
    }
}
