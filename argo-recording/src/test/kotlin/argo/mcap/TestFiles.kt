package argo.mcap

import java.nio.channels.FileChannel
import java.nio.file.Path
import java.nio.file.StandardOpenOption.TRUNCATE_EXISTING
import java.nio.file.StandardOpenOption.WRITE

/** Overwrites the existing file [path] with chunks of [chunkBytes] bytes. */
internal fun <T> writeMcap(path: Path, chunkBytes: Int = McapWriter.DEFAULT_CHUNK_BYTES, write: McapWriter.() -> T): T =
    McapWriter(FileChannel.open(path, WRITE, TRUNCATE_EXISTING), chunkBytes = chunkBytes).use(write)

/** Returns a message in short: topic, number, time and text. */
internal fun McapMessage.inShort() = "${channel.topic} $sequence $logTimeNs $text"

/** A length of the file of [writeSmall] up to which it is complete, and the messages up to this length. */
internal class Whole(val bytes: Long, val messages: List<String>)

/** Writes a small file with all kinds of records in [path], and returns where its complete parts end. */
internal fun writeSmall(path: Path): List<Whole> = writeMcap(path) {
    val messages = ArrayList<String>()
    val whole = arrayListOf(Whole(wholeBytes, emptyList()))
    fun end() = flush().also { whole += Whole(wholeBytes, messages.toList()) }

    metadata("versions", mapOf("argo" to "0.1.0")).also { end() }
    attachment("robot.asl", "text/plain", "!start.\n".encodeToByteArray(), 5).also { end() }
    val schema = schema("argo.Cycle", """{"type":"object"}""")
    val channels = listOf("/robot/cycle", "/robot/print").associateWith { channel(it, schema) }
    repeat(12) { cycle ->
        channels.forEach { (topic, channel) ->
            val text = """{"cycle":$cycle}"""
            message(channel, 1_000L + cycle, 1_000L + cycle, text.encodeToByteArray())
            messages += "$topic $cycle ${1_000L + cycle} $text"
        }
        if (cycle % 3 == 2) end()
    }
    whole
}
