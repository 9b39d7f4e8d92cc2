package argo.recording.storage

import argo.mcap.McapWriter
import java.io.IOException
import java.nio.channels.FileChannel
import java.nio.channels.SeekableByteChannel
import java.nio.file.FileAlreadyExistsException
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardOpenOption.CREATE_NEW
import java.nio.file.StandardOpenOption.WRITE
import java.util.concurrent.TimeUnit
import kotlin.concurrent.thread
import kotlin.io.path.extension
import kotlin.io.path.nameWithoutExtension

/**
 * A recording that its own thread writes to a file. If disk and processors are fast enough, a record is in the file at most one second
 * after its offer, even if the program is killed.
 *
 * If nothing more can be written, for example because the disk is full, [warn] is called once. The file then ends after its last complete
 * chunk, and all later records are refused.
 *
 * @param warn takes one sentence for the user; the writing thread calls it
 */
class RecordingFile internal constructor(
    val path: Path,
    private val channel: SeekableByteChannel,
    private val warn: (String) -> Unit,
    maxWaitingBytes: Long = MAX_WAITING_BYTES,
    private val flushNs: Long = FLUSH_NS,
) : RecordSink(maxWaitingBytes) {
    private val writing = thread(name = "argo-recording-${path.fileName}", isDaemon = true, block = ::write)

    override fun close() = closeAndAwait(writing)

    private fun write() {
        var writer: McapWriter? = null
        try {
            writer = McapWriter(channel)
            writeAll(writer)
            writer.close()
        } catch (failure: Throwable) { // report every failure
            endWith(failure, writer?.wholeBytes ?: 0)
        }
    }

    private fun writeAll(writer: McapWriter) {
        val messages = ChannelWriter(writer)
        var flushAt = System.nanoTime() + flushNs
        while (waiting.take(flushAt - System.nanoTime()) { batch -> batch.forEach { write(it, writer, messages) } }) {
            if (System.nanoTime() - flushAt < 0) continue
            store(writer)
            flushAt = System.nanoTime() + flushNs
        }
    }

    private fun write(next: Waiting, writer: McapWriter, messages: ChannelWriter) {
        when (next) {
            is Waiting.Message -> next.encoded().forEach(messages::message)
            is Waiting.Attachment -> writer.attachment(next.name, next.mediaType, next.data)
            is Waiting.Metadata -> writer.metadata(next.name, next.values)
            is Waiting.Flush -> store(writer)
        }
    }

    private fun store(writer: McapWriter) {
        if (writer.pendingBytes == 0) return
        writer.flush()
        (channel as? FileChannel)?.force(false)
    }

    private fun endWith(failure: Throwable, wholeBytes: Long) {
        runCatching { channel.use { it.truncate(wholeBytes) } } // readers skip the bytes that cannot be cut off
        val why = if (failure is IOException) failure.message ?: "$failure" else "$failure"
        val remedy = if (failure is IOException) ". Is the disk full? Free some space, or record to another disk" else ""
        val sentence = "the recording $path ends here, since it cannot be written: $why. The agent runs on without a recording, and " +
            "the file can be read up to here$remedy"
        giveUp(sentence, warn)
    }

    companion object {
        /** The largest number of bytes of messages that wait for the disk. */
        const val MAX_WAITING_BYTES = 16L * 1024 * 1024

        private val FLUSH_NS = TimeUnit.MILLISECONDS.toNanos(500)

        /**
         * Begins a recording in [path]. If [path] exists, takes the first of `…-2.mcap`, `…-3.mcap` and so on that does not exist.
         *
         * @param warn takes one sentence for the user if nothing more can be written; the writing thread calls it
         * @throws IOException if the file cannot be made
         */
        fun create(path: Path, warn: (String) -> Unit): RecordingFile {
            path.toAbsolutePath().parent?.let(Files::createDirectories)
            for (name in names(path)) {
                try {
                    return RecordingFile(name, FileChannel.open(name, CREATE_NEW, WRITE), warn)
                } catch (_: FileAlreadyExistsException) {
                    // this name is taken
                }
            }
            error("names do not end")
        }

        private fun names(path: Path): Sequence<Path> {
            val ending = if (path.extension.isEmpty()) "" else ".${path.extension}"
            return sequenceOf(path) + generateSequence(2) { it + 1 }.map { path.resolveSibling("${path.nameWithoutExtension}-$it$ending") }
        }
    }
}
