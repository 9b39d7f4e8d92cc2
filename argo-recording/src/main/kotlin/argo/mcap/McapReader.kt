package argo.mcap

import java.io.Closeable
import java.nio.ByteBuffer
import java.nio.file.Path
import kotlin.io.path.inputStream

/**
 * Reads a file of MCAP version 0. Chunks may be uncompressed, or compressed by LZ4 or Zstandard. If a file is damaged or cut off, reads its
 * undamaged parts.
 *
 * Opening scans the whole file once, with one chunk in memory at a time. For one thread.
 *
 * @param path the file; it should not change while it is read
 * @throws McapException if the file is empty, is not an MCAP file, or has a newer version of the format
 * @throws java.io.IOException if the file cannot be read
 */
class McapReader(path: Path) : Closeable {
    private val input = McapInput(path)
    private val contents = try {
        McapScan(input).run()
    } catch (failure: Throwable) {
        input.close()
        throw failure
    }

    /** The channels, in the order of their first appearance. */
    val channels: List<McapChannel> get() = contents.channels.values.toList()

    /** The attached files, in the order of the file. An attachment reads its data on demand, while this reader is open. */
    val attachments: List<McapAttachment> get() = contents.attachments

    /** The entries that [McapWriter.metadata] wrote, in their order. */
    val metadata: List<McapMetadata> get() = contents.metadata

    /** The library that wrote the file. */
    val library: String get() = contents.library

    /** The number of messages that can be read. */
    val messageCount: Long get() = contents.messageCount

    /** The range from the earliest to the latest log time; null if there is no message. */
    val times: LongRange? get() = contents.times

    /** One sentence for each unreadable part of the file. After 100 sentences, one last sentence says that there are others. */
    val problems: List<String> get() = contents.problems

    /** True if the writer closed the file, and all of it can be read. */
    val isComplete: Boolean get() = problems.isEmpty()

    /**
     * Returns the messages in the order in which they were written.
     *
     * @param from the first log time in ns
     * @param until the end of the log times in ns; only earlier messages are returned
     * @param topics the channels' topics; null for all
     * @return a sequence that reads the file during the iteration, and throws [McapException] if the file has changed
     */
    fun messages(from: Long = 0, until: Long = Long.MAX_VALUE, topics: Set<String>? = null): Sequence<McapMessage> {
        val wanted = contents.channels.filterValues { topics == null || it.topic in topics }
        return contents.parts.asSequence()
            .filter { it.times.last >= from && it.times.first < until }
            .flatMap { part -> messagesOf(part.records(input), wanted) }
            .filter { it.logTimeNs in from until until }
    }

    private fun messagesOf(records: ByteBuffer, wanted: Map<Int, McapChannel>): List<McapMessage> = buildList {
        records.forEachRecord { op, content -> if (op == Op.MESSAGE) content.message(wanted)?.let(::add) }
    }

    override fun close() = input.close()

    companion object {
        /**
         * Returns true if the file [path] begins like an MCAP file of any version.
         * @throws McapException if the file is empty
         * @throws java.io.IOException if the file cannot be read
         */
        fun isMcap(path: Path): Boolean {
            val start = path.inputStream().use { it.readNBytes(VERSION_AT) }
            if (start.isEmpty()) throw McapException(emptyFile(path))
            return start.contentEquals(MAGIC.copyOf(VERSION_AT))
        }
    }
}

/** Returns the message in this record; null if its channel is not in [channels]. */
private fun ByteBuffer.message(channels: Map<Int, McapChannel>): McapMessage? {
    val channel = channels[u16()] ?: return null
    return McapMessage(channel, u32(), u64(), u64(), bytes(remaining().toLong()))
}
