package argo.mcap

import java.nio.channels.WritableByteChannel
import java.util.zip.CRC32

/**
 * Writes a file of MCAP version 0 (https://mcap.dev/spec). Messages are in chunks compressed by LZ4, each with a checksum and an index. A
 * summary is at the end. A reader can read a cut-off file up to its last complete chunk.
 *
 * For one thread. Each function throws the [java.io.IOException] of the sink. After an exception, only the parts of the file that were
 * complete before are usable.
 *
 * @param sink receives the file from its first byte on; [close] closes it
 * @param library the name of the program that writes the file
 * @param chunkBytes a chunk of this length ends without a call of [flush]
 */
class McapWriter(
    private val sink: WritableByteChannel,
    library: String = "argo",
    private val chunkBytes: Int = DEFAULT_CHUNK_BYTES,
) : AutoCloseable {
    private val summary = Summary()
    private val chunk = ChunkBytes()
    private val compression = Lz4()
    private val record = RecordBytes()
    private val checksum = CRC32()
    private var isClosed = false

    private var written = 0L

    /**
     * The length of the file up to the last complete chunk, attachment or other record. If a function has failed, the bytes that it wrote
     * are after this length.
     */
    var wholeBytes = 0L
        private set

    /** The number of bytes of messages in the unfinished chunk. */
    val pendingBytes: Int get() = chunk.size

    init {
        require(chunkBytes > 0) { "a chunk of $chunkBytes bytes" }
        write(RecordBytes().bytes(MAGIC))
        write(record.clear().record(Op.HEADER) { text("").text(library) })
        wholeBytes = written
    }

    /** Adds a schema of JSON Schema, and returns its number. */
    fun schema(name: String, jsonSchema: String): Int {
        val schema = McapSchema(summary.schemas.size + 1, name, "jsonschema", jsonSchema)
        check(schema.id <= MAX_ID) { "an MCAP file has at most $MAX_ID schemas" }
        summary.schemas += schema
        chunk.records.schema(schema)
        return schema.id
    }

    /**
     * Adds a channel of messages in JSON, and returns its number.
     *
     * @param schema the number from the function [schema]
     */
    fun channel(topic: String, schema: Int, metadata: Map<String, String> = emptyMap()): Int {
        require(schema in 1..summary.schemas.size) { "no schema $schema has been written" }
        val channel = McapChannel(summary.channels.size, topic, summary.schemas[schema - 1], "json", metadata)
        check(channel.id <= MAX_ID) { "an MCAP file has at most ${MAX_ID + 1} channels" }
        summary.channels += channel
        chunk.records.channel(channel)
        return channel.id
    }

    /**
     * Adds a message.
     *
     * @param channel the number from the function [channel]
     * @param logTimeNs the time of recording, in ns, not below 0
     * @param publishTimeNs the time at which the message was made, in ns, not below 0
     */
    fun message(channel: Int, logTimeNs: Long, publishTimeNs: Long, data: ByteArray) {
        require(channel in summary.channels.indices) { "no channel $channel has been written" }
        require(logTimeNs >= 0 && publishTimeNs >= 0) { "a time before 0: $logTimeNs, $publishTimeNs" }
        chunk.message(channel, summary.count(channel), logTimeNs, publishTimeNs, data)
        if (chunk.size >= chunkBytes) flush()
    }

    /** Adds a file. Ends the chunk, and writes the file after it at once. */
    fun attachment(name: String, mediaType: String, data: ByteArray, timeNs: Long = 0) {
        flush()
        write(record.clear().attachment(name, mediaType, data, timeNs))
        summary.attachments += AttachmentIndex(wholeBytes, written - wholeBytes, timeNs, data.size.toLong(), name, mediaType)
        wholeBytes = written
    }

    /** Adds names and values under [name]. Ends the chunk, and writes the names and values after it at once. */
    fun metadata(name: String, values: Map<String, String>) {
        flush()
        write(record.clear().record(Op.METADATA) { text(name).map(values) })
        summary.metadata += MetadataIndex(wholeBytes, written - wholeBytes, name)
        wholeBytes = written
    }

    /** Ends the chunk. The sink has then received all added records. */
    fun flush() {
        if (chunk.size == 0) return
        val compressed = compression.compress(chunk.records.array(), chunk.size)
        write(chunk.head(record, compressed))
        write(compressed)
        val indexAt = written
        val places = chunk.channels.associateWith { channel ->
            written.also { write(record.clear().messageIndex(channel, chunk.entries(channel))) }
        }
        val (packedBytes, recordBytes) = compressed.size.toLong() to chunk.size.toLong()
        summary.chunks += ChunkIndex(chunk.times, wholeBytes, indexAt - wholeBytes, places, written - indexAt, packedBytes, recordBytes)
        chunk.clear()
        wholeBytes = written
    }

    /** Writes the remaining records and the summary. Closes the sink even if writing fails. May be called twice. */
    override fun close() {
        if (isClosed) return
        isClosed = true
        sink.use {
            flush()
            write(record.clear().record(Op.DATA_END) { u32(checksum.value) })
            write(summary.bytes(written))
            write(RecordBytes().bytes(MAGIC))
            wholeBytes = written
        }
    }

    private fun write(bytes: RecordBytes) {
        checksum.update(bytes.array(), 0, bytes.size)
        val all = bytes.toRead()
        while (all.hasRemaining()) sink.write(all)
        written += bytes.size
    }

    companion object {
        /** The default length at which a chunk ends. */
        const val DEFAULT_CHUNK_BYTES = 256 * 1024

        private const val MAX_ID = 0xFFFF
    }
}
