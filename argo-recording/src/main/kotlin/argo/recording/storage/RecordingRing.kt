package argo.recording.storage

import argo.mcap.McapWriter
import java.nio.channels.FileChannel
import java.nio.file.Path
import java.nio.file.StandardOpenOption.CREATE
import java.nio.file.StandardOpenOption.TRUNCATE_EXISTING
import java.nio.file.StandardOpenOption.WRITE
import java.time.Duration
import java.util.concurrent.TimeUnit
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.thread
import kotlin.concurrent.withLock

/**
 * Keeps the last part of a recording in memory. [save] writes this part to a file. The ring keeps all attachments and metadata. A message
 * of more than [maxBytes] is replaced by a message of the topic [GAP_TOPIC].
 *
 * If nothing more can be kept, for example without memory, [warn] is called once and all later records are refused.
 *
 * @param last the time for which messages are kept, by their own times
 * @param maxBytes the largest number of bytes of kept messages. If there are more, the oldest messages are dropped early
 * @param warn takes one sentence for the user; the thread of the ring calls it
 */
class RecordingRing(
    private val last: Duration,
    private val maxBytes: Long = MAX_BYTES,
    private val warn: (String) -> Unit = {},
) : RecordSink(RecordingFile.MAX_WAITING_BYTES) {
    private val lock = ReentrantLock()
    private val messages = ArrayDeque<Encoded>()
    private val others = ArrayList<Waiting>()
    private var bytes = 0L
    private var newestNs = 0L

    private val keeping = thread(name = "argo-recording-ring", isDaemon = true, block = ::keepAll)

    private fun keepAll() {
        try {
            while (waiting.take(PATIENCE_NS) { it.forEach(::keep) }) continue
        } catch (failure: Throwable) { // report every failure
            giveUp("the last minutes are no longer recorded, since they cannot be kept: $failure. The agent runs on unrecorded", warn)
        }
    }

    private fun keep(next: Waiting) = when (next) {
        is Waiting.Message -> next.encoded().forEach(::keep)
        is Waiting.Flush -> Unit
        else -> lock.withLock { others += next }
    }

    private fun keep(offered: Encoded) = lock.withLock {
        val message = if (offered.data.size > maxBytes) Gap.of(offered.timeNs).encoded() else offered
        messages += message
        bytes += message.data.size
        newestNs = maxOf(newestNs, message.timeNs)
        while (messages.isNotEmpty() && (bytes > maxBytes || newestNs - messages.first().timeNs > last.toNanos())) {
            bytes -= messages.removeFirst().data.size
        }
    }

    /**
     * Overwrites the file [path] with the kept records, and continues to keep them. Waits for the disk, so the agent's thread must not call
     * this function.
     *
     * @throws java.io.IOException if the file cannot be written
     */
    fun save(path: Path) {
        flush()
        val (others, messages) = lock.withLock { others.toList() to messages.toList() }
        McapWriter(FileChannel.open(path, CREATE, TRUNCATE_EXISTING, WRITE)).use { writer ->
            val channelWriter = ChannelWriter(writer)
            others.forEach {
                when (it) {
                    is Waiting.Attachment -> writer.attachment(it.name, it.mediaType, it.data)
                    is Waiting.Metadata -> writer.metadata(it.name, it.values)
                    else -> error("only these are kept")
                }
            }
            messages.forEach(channelWriter::message)
        }
    }

    override fun close() {
        closeAndAwait(keeping)
        lock.withLock {
            messages.clear()
            others.clear()
            bytes = 0
        }
    }

    companion object {
        /** The default for the largest number of bytes of kept messages. */
        const val MAX_BYTES = 64L * 1024 * 1024

        private val PATIENCE_NS = TimeUnit.MILLISECONDS.toNanos(500)
    }
}
