package argo.mcap

import java.util.zip.CRC32

internal class IndexEntry(val logTimeNs: Long, val offset: Long)

internal class ChunkBytes {
    private val index = LinkedHashMap<Int, MutableList<IndexEntry>>()

    val records = RecordBytes(INITIAL_BYTES)

    val size: Int get() = records.size

    val channels: Set<Int> get() = index.keys

    /** The range of the log times of the chunk's messages; null if it has no messages. */
    var times: LongRange? = null
        private set

    fun entries(channel: Int): List<IndexEntry> = index.getValue(channel).sortedBy { it.logTimeNs }

    fun message(channel: Int, sequence: Long, logTimeNs: Long, publishTimeNs: Long, data: ByteArray) {
        index.getOrPut(channel) { ArrayList() } += IndexEntry(logTimeNs, size.toLong())
        times = times.covering(logTimeNs)
        records.record(Op.MESSAGE) { u16(channel).u32(sequence).u64(logTimeNs).u64(publishTimeNs).bytes(data) }
    }

    /** Writes the part of a chunk before its [compressed] records into [target]. Returns [target]. */
    fun head(target: RecordBytes, compressed: RecordBytes): RecordBytes {
        val head = RecordBytes().u64(times?.first ?: 0).u64(times?.last ?: 0).u64(size.toLong())
            .u32(CRC32().apply { update(records.array(), 0, size) }.value).text(Lz4.NAME).u64(compressed.size.toLong())
        return target.clear().u8(Op.CHUNK).u64(head.size + compressed.size.toLong()).bytes(head.array(), 0, head.size)
    }

    fun clear() {
        index.clear()
        times = null
        records.clear()
    }

    private companion object {
        const val INITIAL_BYTES = 64 * 1024
    }
}

internal fun LongRange?.covering(timeNs: Long): LongRange =
    if (this == null) timeNs..timeNs else minOf(first, timeNs)..maxOf(last, timeNs)
