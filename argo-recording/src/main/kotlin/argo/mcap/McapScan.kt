package argo.mcap

import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.nio.file.Path
import java.util.zip.CRC32

/** A part of the file with complete records of messages. [times] is the range of the messages' log times. */
internal class MessagePart(private val at: Long, private val length: Long, private val packed: Packed, val times: LongRange) {
    fun records(input: McapInput): ByteBuffer = packed.unpacked(input.read(at, length))
}

/** How a chunk's records are packed: the MCAP name of their [compression], and the number of unpacked [bytes]. */
internal class Packed(private val compression: String, private val bytes: Long) {
    fun unpacked(records: ByteBuffer): ByteBuffer = when (compression) {
        "" -> records
        Lz4.NAME -> Lz4.decompress(records, length())
        Zstd.NAME -> ByteBuffer.wrap(Zstd.decompress(records.bytes(records.remaining().toLong()), length())).order(ByteOrder.LITTLE_ENDIAN)
        else -> throw McapException("it is a chunk compressed by $compression, which cannot be read here")
    }

    private fun length(): Int {
        if (bytes > McapInput.MAX_RECORD_BYTES) throw McapException("it is a chunk of $bytes bytes, which is too long")
        return bytes.toInt()
    }
}

internal class McapContents {
    val schemas = HashMap<Int, McapSchema>()
    val channels = LinkedHashMap<Int, McapChannel>()
    val attachments = ArrayList<McapAttachment>()
    val metadata = ArrayList<McapMetadata>()
    val parts = ArrayList<MessagePart>()
    val problems = ArrayList<String>()
    var library = ""
    var messageCount = 0L
    val times: LongRange? get() = parts.map { it.times }.reduceOrNull { all, next -> all.covering(next.first).covering(next.last) }

    fun problem(text: String) {
        if (problems.size < MAX_PROBLEMS) problems += text
        else if (problems.size == MAX_PROBLEMS) problems += "there are others, which are not listed"
    }

    private companion object {
        const val MAX_PROBLEMS = 100
    }
}

internal fun emptyFile(path: Path) = "$path is empty: the recording ended, or the disk was full, before anything was written"

/** Scans a file from its beginning, as far as its records are complete. */
internal class McapScan(private val input: McapInput) {
    private val contents = McapContents()
    private var isDataOver = false
    private var hasChunks = false

    fun run(): McapContents {
        checkMagic()
        var at = MAGIC.size.toLong()
        while (true) {
            val length = lengthOf(at)
            if (length == null) {
                contents.problem("the file was cut off behind byte $at, or is damaged there; everything before was read")
                return contents
            }
            val op = input.read(at, 1).get().toInt() and 0xFF
            try {
                take(op, at, at + RECORD_HEAD_BYTES, length)
            } catch (damaged: McapException) {
                contents.problem("the record at byte $at was left out: ${damaged.message}")
            }
            at += RECORD_HEAD_BYTES + length
            if (op == Op.FOOTER) {
                checkEnd(at)
                return contents
            }
        }
    }

    private fun checkMagic() {
        if (input.size == 0L) throw McapException(emptyFile(input.path))
        val start = ByteArray(minOf(MAGIC.size.toLong(), input.size).toInt()).also { input.read(0, it.size.toLong()).get(it) }
        val differing = MAGIC.indices.filter { it >= start.size || start[it] != MAGIC[it] }
        if (differing == listOf(VERSION_AT)) {
            val version = Char(start[VERSION_AT].toInt() and 0xFF)
            throw McapException("${input.path} is of version '$version' of the MCAP format; only version 0 can be read here")
        }
        if (differing.isNotEmpty()) throw McapException("${input.path} is no MCAP file: ${otherFormat(start)}")
    }

    private fun otherFormat(start: ByteArray) = when {
        start.decodeToString() == "SQLite f" -> "it is a database of SQLite; \"ros2 bag convert\" makes an MCAP file of a bag in SQLite"
        start.decodeToString() == "#ROSBAG " ->
            "it is a bag of ROS 1; rosbags-convert, of the Python package rosbags, makes one of ROS 2 of it, with --dst-storage mcap"
        start.decodeToString() == "javino-r" -> // LineRecording's first line
            "it is a recording of a board; \"monitor replay:${input.path}\" shows it, and \"replay ${input.path}\" serves it as a board"
        Zstd.isIn(start) -> "all of it is compressed by Zstandard; \"zstd -d\" unpacks it"
        else -> "it does not begin as one"
    }

    private fun checkEnd(at: Long) {
        val behind = input.size - at - MAGIC.size
        if (behind < 0 || !ByteArray(MAGIC.size).also { input.read(at, it.size.toLong()).get(it) }.contentEquals(MAGIC)) {
            contents.problem("the end of the file is damaged; everything before was read")
        } else if (behind > 0) {
            contents.problem("the recording ends $behind bytes before the end of the file; they were not read, be they another recording")
        }
    }

    /** Returns the length of the content of the record at [at]; null if the record is not complete. */
    private fun lengthOf(at: Long): Long? {
        val rest = input.size - at - RECORD_HEAD_BYTES
        if (rest < 0) return null
        return input.read(at + 1, RECORD_HEAD_BYTES - 1L).getLong().takeIf { it in 0..rest }
    }

    /** Reads the record of kind [op] that begins at [start], with its content from [at] on. */
    private fun take(op: Int, start: Long, at: Long, length: Long) {
        if (op == Op.FOOTER) {
            if (!isDataOver) contents.problem("the record that ends the messages is missing; the file is damaged before byte $start")
            checkSummary(input.read(at, length), at)
        }
        if (isDataOver) return
        when (op) {
            Op.HEADER -> contents.library = input.read(at, length).run { text(); text() }
            Op.SCHEMA -> schema(input.read(at, length))
            Op.CHANNEL -> channel(input.read(at, length))
            Op.MESSAGE -> {
                // one wrong bit can turn the record of an index into a message
                if (hasChunks) throw McapException("it is a message outside of chunks, or damage made it one")
                val record = input.read(start, RECORD_HEAD_BYTES + length)
                messages(record) { MessagePart(start, RECORD_HEAD_BYTES + length, Packed("", 0), it) }
            }
            Op.CHUNK -> chunk(at, length)
            Op.ATTACHMENT -> attachment(at, length)
            Op.METADATA -> input.read(at, length).run { contents.metadata += McapMetadata(text(), map()) }
            Op.DATA_END -> {
                isDataOver = true
                checkSum(0, start, input.read(at, length).u32())
            }
        }
    }

    private fun checkSummary(footer: ByteBuffer, at: Long) {
        val start = footer.u64()
        footer.u64()
        if (start >= at) throw McapException("the place of the summary is damaged")
        if (start > 0) checkSum(start, at + footer.position(), footer.u32())
    }

    private fun checkSum(from: Long, until: Long, checksum: Long) {
        if (checksum != 0L && checksum != input.checksum(from, until - from)) {
            throw McapException("something between byte $from and here is damaged: the checksum is wrong")
        }
    }

    private fun chunk(at: Long, length: Long) {
        hasChunks = true
        val chunk = input.read(at, length)
        chunk.u64()
        chunk.u64()
        val recordBytes = chunk.u64()
        val checksum = chunk.u32()
        val packed = Packed(chunk.text(), recordBytes)
        val compressed = chunk.part(chunk.u64())
        val place = at + chunk.position() - compressed.remaining()
        val bytes = compressed.remaining().toLong()
        val records = packed.unpacked(compressed)
        if (records.remaining().toLong() != recordBytes) throw McapException("its length is damaged")
        if (checksum != 0L && checksum != checksumOf(records)) throw McapException("it is damaged: its checksum is wrong")
        messages(records) { MessagePart(place, bytes, packed, it) }
    }

    /**
     * Reads the schemas and channels in [records]. If [records] has messages, calls [partOf] with their range of times, and adds the part
     * that it returns.
     */
    private fun messages(records: ByteBuffer, partOf: (LongRange) -> MessagePart) {
        var times: LongRange? = null
        var count = 0L
        records.forEachRecord { op, content ->
            when (op) {
                Op.SCHEMA -> schema(content)
                Op.CHANNEL -> channel(content)
                Op.MESSAGE -> {
                    times = times.covering(timeOfMessage(content))
                    count++
                }
            }
        }
        times?.let { contents.parts += partOf(it) }
        contents.messageCount += count
    }

    private fun timeOfMessage(content: ByteBuffer): Long {
        val channel = content.u16()
        if (channel !in contents.channels) throw McapException("it has messages of the channel $channel, which the file does not describe")
        content.u32()
        val time = content.u64()
        content.u64()
        return time
    }

    private fun schema(content: ByteBuffer) {
        val schema = McapSchema(content.u16(), content.text(), content.text(), content.text())
        contents.schemas.putIfAbsent(schema.id, schema)
    }

    private fun channel(content: ByteBuffer) {
        val id = content.u16()
        val schema = contents.schemas[content.u16()]
        contents.channels.putIfAbsent(id, McapChannel(id, content.text(), schema, content.text(), content.map()))
    }

    private fun attachment(at: Long, length: Long) {
        val fixed = length - Int.SIZE_BYTES
        if (fixed < 0) throw McapException("it is shorter than an attachment")
        val head = input.read(at, minOf(fixed, MAX_ATTACHMENT_HEAD_BYTES))
        val time = head.u64()
        head.u64()
        val name = head.text()
        val mediaType = head.text()
        val dataBytes = head.u64()
        if (head.position() + dataBytes != fixed) throw McapException("the length of the attachment $name is damaged")
        val checksum = input.read(at + fixed, Int.SIZE_BYTES.toLong()).u32()
        if (checksum != 0L && checksum != input.checksum(at, fixed)) {
            throw McapException("the attachment $name is damaged: its checksum is wrong")
        }
        val dataAt = at + head.position()
        contents.attachments += McapAttachment(name, mediaType, time) { input.read(dataAt, dataBytes).bytes(dataBytes) }
    }

    private fun checksumOf(bytes: ByteBuffer) = CRC32().apply { update(bytes.duplicate()) }.value

    private companion object {
        /** An upper limit for the length of the fields before an attachment's data, such as its name. */
        const val MAX_ATTACHMENT_HEAD_BYTES = 64L * 1024
    }
}
