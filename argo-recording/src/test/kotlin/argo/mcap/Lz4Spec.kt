package argo.mcap

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.ints.shouldBeLessThan
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.PropertyTesting
import io.kotest.property.arbitrary.byte
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll
import java.nio.ByteBuffer
import kotlin.random.Random

private fun compressed(data: ByteArray): ByteArray = Lz4().compress(data, data.size).run { array().copyOf(size) }

private fun decompressed(frame: ByteArray, length: Int) = Lz4.decompress(ByteBuffer.wrap(frame), length).array()

class Lz4Spec : FunSpec({
    test("bytes come back as they were: repeated words, noise, runs of one byte, nothing") {
        val words = Arb.list(Arb.element("""{"index":1""", "dist(front,", ")", "a", "the same long text of forty characters..."), 0..200)
        checkAll(500, words) { all ->
            val data = all.joinToString("").encodeToByteArray()
            decompressed(compressed(data), data.size) shouldBe data
        }
        checkAll(200, Arb.int(0..70_000), Arb.byte()) { size, byte ->
            val run = ByteArray(size) { byte }
            decompressed(compressed(run), size) shouldBe run
            val noise = Random(size).nextBytes(size)
            decompressed(compressed(noise), size) shouldBe noise
        }
    }

    test("a match that lies further back than the format can say is not used") {
        val far = Random(1).nextBytes(70_000).let { it + it }
        decompressed(compressed(far), far.size) shouldBe far
    }

    test("cycles that look alike take a fraction") {
        val cycles = (1..100).joinToString("") { """{"index":$it,"number":${it * 2},"course":{"event":"+dist(f,$it)[source(percept)]"}}""" }
        compressed(cycles.encodeToByteArray()).size shouldBeLessThan cycles.length / 3
    }

    test("a block that repeats bytes of the block before is read, as other programs write them") {
        val stored = byteArrayOf(15, 0, 0, -0x80) + "dist(front,38);".encodeToByteArray()
        val repeating = byteArrayOf(9, 0, 0, 0) + byteArrayOf(0x0B, 15, 0) + 0x50 + "end()".encodeToByteArray() // repeats 15 bytes
        val frame = byteArrayOf(0x04, 0x22, 0x4D, 0x18, 0x40, 0x40, -0x40) + stored + repeating + ByteArray(4)
        decompressed(frame, 35).decodeToString() shouldBe "dist(front,38);dist(front,38);end()"
    }

    test("damaged bytes fail with a failure of the format, or give as many bytes") {
        val data = "dist(front,38);dist(front,39);dist(front,40);temp(21.5)".repeat(9).encodeToByteArray()
        val frame = compressed(data)
        checkAll(2 * PropertyTesting.defaultIterationCount, Arb.int(frame.indices), Arb.byte()) { at, value ->
            try {
                decompressed(frame.copyOf().also { it[at] = value }, data.size).size shouldBe data.size
            } catch (_: McapException) {
                // the library's own exception
            }
        }
        shouldThrow<McapException> { decompressed(frame.copyOf(frame.size / 2), data.size) }
        shouldThrow<McapException> { decompressed(frame, data.size + 1) }
    }
})
