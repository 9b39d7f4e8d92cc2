package argo.mcap

import java.util.zip.CRC32

internal class ChunkIndex(
    val times: LongRange?,
    val at: Long,
    val length: Long,
    val messageIndexes: Map<Int, Long>,
    val messageIndexLength: Long,
    val compressedBytes: Long,
    val recordBytes: Long,
)

internal class AttachmentIndex(
    val at: Long,
    val length: Long,
    val timeNs: Long,
    val dataBytes: Long,
    val name: String,
    val mediaType: String,
)

internal class MetadataIndex(val at: Long, val length: Long, val name: String)

/** The summary at the end of a file, an index for readers, with schemas, channels, chunk indexes and counts. */
internal class Summary {
    val schemas = ArrayList<McapSchema>()
    val channels = ArrayList<McapChannel>()
    val chunks = ArrayList<ChunkIndex>()
    val attachments = ArrayList<AttachmentIndex>()
    val metadata = ArrayList<MetadataIndex>()
    private val counts = HashMap<Int, Long>()

    /** Counts a message of [channel]. Returns the number of earlier messages. */
    fun count(channel: Int): Long = counts.getOrDefault(channel, 0L).also { counts[channel] = it + 1 }

    /** Returns the summary, the places of its groups of records, and the footer. The summary begins at [start] in the file. */
    fun bytes(start: Long): RecordBytes {
        val bytes = RecordBytes()
        val groups = listOf<Pair<Int, RecordBytes.() -> Unit>>(
            Op.SCHEMA to { schemas.forEach { schema(it) } },
            Op.CHANNEL to { channels.forEach { channel(it) } },
            Op.STATISTICS to { statistics() },
            Op.CHUNK_INDEX to { chunks.forEach { chunkIndex(it) } },
            Op.ATTACHMENT_INDEX to { attachments.forEach { attachmentIndex(it) } },
            Op.METADATA_INDEX to { metadata.forEach { metadataIndex(it) } },
        )
        val places = groups.mapNotNull { (op, write) ->
            val from = bytes.size
            bytes.write()
            if (bytes.size == from) null else Triple(op, start + from, (bytes.size - from).toLong())
        }
        val offsets = start + bytes.size
        places.forEach { (op, at, length) -> bytes.record(Op.SUMMARY_OFFSET) { u8(op).u64(at).u64(length) } }
        bytes.u8(Op.FOOTER).u64(FOOTER_BYTES.toLong()).u64(start).u64(offsets)
        return bytes.u32(CRC32().apply { update(bytes.array(), 0, bytes.size) }.value)
    }

    private fun RecordBytes.statistics() = record(Op.STATISTICS) {
        val times = chunks.mapNotNull { it.times }
        u64(counts.values.sum()).u16(schemas.size).u32(channels.size.toLong()).u32(attachments.size.toLong())
        u32(metadata.size.toLong()).u32(chunks.size.toLong())
        u64(times.minOfOrNull { it.first } ?: 0).u64(times.maxOfOrNull { it.last } ?: 0)
        sized { counts.toSortedMap().forEach { (channel, count) -> u16(channel).u64(count) } }
    }

    private fun RecordBytes.chunkIndex(chunk: ChunkIndex) = record(Op.CHUNK_INDEX) {
        u64(chunk.times?.first ?: 0).u64(chunk.times?.last ?: 0).u64(chunk.at).u64(chunk.length)
        sized { chunk.messageIndexes.forEach { (channel, at) -> u16(channel).u64(at) } }
        u64(chunk.messageIndexLength).text(Lz4.NAME).u64(chunk.compressedBytes).u64(chunk.recordBytes)
    }

    private fun RecordBytes.attachmentIndex(index: AttachmentIndex) = record(Op.ATTACHMENT_INDEX) {
        u64(index.at).u64(index.length).u64(index.timeNs).u64(index.timeNs).u64(index.dataBytes).text(index.name).text(index.mediaType)
    }

    private fun RecordBytes.metadataIndex(index: MetadataIndex) = record(Op.METADATA_INDEX) {
        u64(index.at).u64(index.length).text(index.name)
    }
}
