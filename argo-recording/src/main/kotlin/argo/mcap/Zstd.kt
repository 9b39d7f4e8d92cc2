package argo.mcap

import io.airlift.compress.zstd.ZstdDecompressor

/** Unpacks Zstandard, which compresses the chunks of bags, and sometimes each message. */
internal object Zstd {
    /** The name of this compression in MCAP files. */
    const val NAME = "zstd"

    private val MAGIC_NUMBER = byteArrayOf(0x28, 0xB5.toByte(), 0x2F, 0xFD.toByte())

    /** Returns true if [data] begins like a compressed frame. No message in CDR begins like this. */
    fun isIn(data: ByteArray): Boolean = data.size >= MAGIC_NUMBER.size && data.copyOf(MAGIC_NUMBER.size).contentEquals(MAGIC_NUMBER)

    /**
     * Returns the unpacked bytes of [frame], which states their number.
     *
     * @throws McapException if [frame] is damaged, or is too long
     */
    fun decompress(frame: ByteArray): ByteArray {
        val length = unlessDamaged { ZstdDecompressor.getDecompressedSize(frame, 0, frame.size) }
        if (length !in 0..McapInput.MAX_RECORD_BYTES) throw McapException("its compressed bytes tell no usable length: $length")
        return decompress(frame, length.toInt())
    }

    /**
     * Returns the [length] unpacked bytes of [frame].
     *
     * @throws McapException if [frame] is damaged, or has another number of bytes
     */
    fun decompress(frame: ByteArray, length: Int): ByteArray {
        val target = ByteArray(length)
        val written = unlessDamaged { ZstdDecompressor().decompress(frame, 0, frame.size, target, 0, target.size) }
        if (written != length) throw McapException("it has $written bytes instead of $length")
        return target
    }

    private fun <T> unlessDamaged(work: () -> T): T = try {
        work()
    } catch (damaged: RuntimeException) { // thrown for damaged data
        throw McapException("its compressed bytes are damaged: ${damaged.message}")
    }
}
