package argo.mcap

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempfile
import io.kotest.inspectors.forAll
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldNotBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.property.Arb
import io.kotest.property.arbitrary.byte
import io.kotest.property.arbitrary.filter
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll
import java.nio.file.Path
import kotlin.experimental.xor
import kotlin.io.path.readBytes
import kotlin.io.path.writeBytes
import kotlin.random.Random

/** Reads [file] with all attachments and metadata. Returns its messages in short, and its problems. */
private fun read(file: Path) = McapReader(file).use { read ->
    read.attachments.forEach { it.data }
    read.messages().map { it.inShort() }.toList() to read.problems
}

class DamagedFileSpec : FunSpec({
    val whole = tempfile(suffix = ".mcap").toPath()
    val parts = writeSmall(whole)
    val bytes = whole.readBytes()
    val file = tempfile(suffix = ".mcap").toPath()

    test("a file that is cut off anywhere is read up to its last whole chunk, and says so") {
        for (length in bytes.indices) {
            file.writeBytes(bytes.copyOf(length))
            withClue("the first $length bytes") {
                if (length < MAGIC.size) {
                    shouldThrow<McapException> { read(file) }
                } else {
                    val (messages, problems) = read(file)
                    val last = parts.lastOrNull { it.bytes <= length }?.messages.orEmpty()
                    // a file may end with a complete chunk without its index
                    (messages == last || messages in parts.map { it.messages } && messages.size > last.size) shouldBe true
                    problems.shouldNotBeEmpty()
                }
            }
        }
        read(whole) shouldBe (parts.last().messages to emptyList())
    }

    test("no changed byte adds or changes a message, and each is reported") {
        val original = parts.last().messages
        val random = Random(1)
        for (at in bytes.indices) {
            val change = (1 shl random.nextInt(8)).toByte()
            file.writeBytes(bytes.copyOf().also { it[at] = it[at] xor change })
            withClue("byte $at changed by $change") {
                if (at < MAGIC.size) {
                    shouldThrow<McapException> { read(file) }
                } else {
                    val (messages, problems) = read(file)
                    messages shouldBe original.filter(messages.toSet()::contains)
                    problems.shouldNotBeEmpty()
                }
            }
        }
    }

    test("bytes of any kind behind the beginning are read without another failure than its own") {
        checkAll(500, Arb.list(Arb.byte(), 0..200), Arb.int(bytes.indices).filter { it >= MAGIC.size }) { noise, at ->
            file.writeBytes(bytes.copyOf(at) + noise.toByteArray())
            try {
                read(file).first.forAll { (it in parts.last().messages) shouldBe true }
            } catch (_: McapException) {
                // the reader's own exception
            }
        }
    }

    test("a length that promises more than there is takes no memory") {
        val chunk = RecordBytes().u8(Op.CHUNK).u64(Long.MAX_VALUE - 20).u64(0).u64(0).u64(Long.MAX_VALUE)
        file.writeBytes(bytes.copyOf(parts[0].bytes.toInt()) + chunk.array().copyOf(chunk.size))
        read(file).first.shouldBeEmpty()
    }

    test("a chunk whose compression is unknown is left out, by name") {
        val chunk = RecordBytes().record(Op.CHUNK) { u64(0).u64(0).u64(4).u32(0).text("br").u64(4).u32(0) }
        file.writeBytes(bytes.copyOf(parts[0].bytes.toInt()) + chunk.array().copyOf(chunk.size))
        read(file).second.first() shouldContain "compressed by br"
    }

    test("no changed byte of a bag compressed by Zstandard does harm, or changes a message") {
        fun messages(bag: Path) = McapReader(bag).use { read -> read.messages().map { it.data.toList() }.toList() }
        val bag = Path.of("src/test/resources/bags/zstd.mcap")
        val (original, bagBytes) = messages(bag).toSet() to bag.readBytes()
        val random = Random(1)
        for (at in MAGIC.size until bagBytes.size) {
            file.writeBytes(bagBytes.copyOf().also { it[at] = it[at] xor (1 shl random.nextInt(8)).toByte() })
            withClue("byte $at changed") { messages(file).forAll { (it in original) shouldBe true } }
        }
    }

    test("an index that one bit has made a message adds none") {
        val index = (parts.last().bytes.toInt() downTo 0).first { bytes[it].toInt() == Op.MESSAGE_INDEX && bytes[it + 1].toInt() == 54 }
        file.writeBytes(bytes.copyOf().also { it[index] = Op.MESSAGE.toByte() })
        val (messages, problems) = read(file)
        messages shouldBe parts.last().messages
        problems.first() shouldContain "the record at byte $index was left out: it is a message outside of chunks"
    }

    test("of more than a hundred problems it is told that there are others") {
        val records = RecordBytes()
        repeat(150) { records.record(Op.MESSAGE) { u16(3).u32(0).u64(10).u64(0).bytes("{}".encodeToByteArray()) } }
        file.writeBytes(bytes.copyOf(MAGIC.size) + records.array().copyOf(records.size))
        val problems = read(file).second
        problems.size shouldBe 101
        problems.last() shouldBe "there are others, which are not listed"
    }

    test("bytes behind the end of a recording are told, since a second recording there is not read") {
        file.writeBytes(bytes + bytes)
        val (messages, problems) = read(file)
        messages shouldBe parts.last().messages
        problems.single() shouldContain "the recording ends ${bytes.size} bytes before the end of the file; they were not read"
    }

    test("messages outside of chunks are read, as other writers leave them") {
        val records = RecordBytes().schema(McapSchema(1, "S", "jsonschema", "{}"))
            .channel(McapChannel(3, "/robot/x", McapSchema(1, "S", "jsonschema", "{}"), "json"))
        repeat(3) { records.record(Op.MESSAGE) { u16(3).u32(it.toLong()).u64(it + 10L).u64(0).bytes("{}".encodeToByteArray()) } }
        file.writeBytes(bytes.copyOf(parts[0].bytes.toInt()) + records.array().copyOf(records.size))
        read(file).first shouldBe listOf("/robot/x 0 10 {}", "/robot/x 1 11 {}", "/robot/x 2 12 {}")
    }

    test("a bag in another format is refused with what makes an MCAP file of it") {
        for ((start, words) in listOf(
            "SQLite format 3" to "it is a database of SQLite; \"ros2 bag convert\" makes an MCAP file",
            "#ROSBAG V2.0\n" to "it is a bag of ROS 1; rosbags-convert",
            "\u0028\u00B5\u002F\u00FD 123456" to "all of it is compressed by Zstandard; \"zstd -d\" unpacks it",
        )) {
            file.writeBytes(start.toByteArray(Charsets.ISO_8859_1))
            shouldThrow<McapException> { read(file) }.message shouldContain "is no MCAP file: $words"
        }
    }

    test("another file is refused, and a newer version of the format is called that") {
        file.writeBytes("getPercepts".encodeToByteArray())
        shouldThrow<McapException> { read(file) }.message shouldContain "is no MCAP file"
        file.writeBytes(ByteArray(0))
        shouldThrow<McapException> { read(file) }.message shouldContain "$file is empty: the recording ended"
        shouldThrow<McapException> { McapReader.isMcap(file) }.message shouldContain "$file is empty"
        file.writeBytes(bytes.copyOf().also { it[5] = '1'.code.toByte() })
        shouldThrow<McapException> { read(file) }.message shouldContain "version '1'"
    }
})
