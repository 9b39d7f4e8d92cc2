package javino

import io.kotest.assertions.withClue
import io.kotest.core.NamedTag
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainInOrder
import io.kotest.matchers.comparables.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.PropertyTesting
import io.kotest.property.arbitrary.byte
import io.kotest.property.arbitrary.byteArray
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.map
import io.kotest.property.assume
import io.kotest.property.checkAll
import java.util.Random
import kotlin.time.Duration.Companion.minutes

private val HEADER = Regex("(?=fffe([0-9A-Fa-f]{2}))")

/** Payloads without `f`, so no preamble can begin in them. */
private val ordinary = Arb.list(Arb.element("abcdeghij(),;0123456789 \u00e9".toList()), 0..40).map { Frame.of(it.joinToString("")) }

private val nastyText =
    Arb.list(Arb.element("f", "ff", "fffe", "fffe0", "fffe02", "e", "0", "A", "F", "x"), 0..30).map { it.joinToString("") }
private val nasty = nastyText.map { Frame.of(it) }

private fun bytesOf(frames: List<Frame>): ByteArray = frames.fold(ByteArray(0)) { all, frame -> all + frame.toBytes() }

/**
 * Returns whether the damaged bytes can also be read as a frame that ends exactly at the end of an intact frame. A decoder cannot tell
 * the two readings apart.
 */
private fun isAmbiguous(damaged: ByteArray, intact: List<Frame>): Boolean {
    val stream = String(damaged + bytesOf(intact), Charsets.ISO_8859_1)
    val ends = intact.runningFold(damaged.size) { end, frame -> end + frame.length() }.drop(1)
    return HEADER.findAll(stream).any { header ->
        header.range.first < damaged.size && header.range.first + 6 + header.groupValues[1].toInt(16) in ends
    }
}

private fun deliveredBehind(damaged: ByteArray, intact: List<Frame>): List<Frame> =
    DecoderProbe().feed(damaged + bytesOf(intact)).silence().delivered

private fun deliveredAfterGap(damaged: ByteArray, intact: List<Frame>): List<Frame> =
    DecoderProbe().feed(damaged).silence().feed(bytesOf(intact)).silence().delivered

class FrameDecoderPropertySpec : FunSpec({
    test("a frame of any length comes through in chunks of any size") {
        for (length in 0..255) {
            val frame = Frame.of(ByteArray(length) { (it * 7).toByte() })
            for (chunk in 1..frame.length()) {
                withClue({ "$length bytes in chunks of $chunk" }) {
                    DecoderProbe().feed(frame.toBytes(), chunk).delivered shouldBe listOf(frame)
                }
            }
        }
    }

    test("an intact stream gives exactly its frames, whatever they carry and however it is cut") {
        checkAll(2 * PropertyTesting.defaultIterationCount, Arb.list(nasty, 0..8), Arb.int(1..300)) { frames, chunk ->
            DecoderProbe().feed(bytesOf(frames), chunk).silence().delivered shouldBe frames
        }
    }

    test("frames with silences between them are exactly delivered, whatever they carry") {
        checkAll(Arb.list(nasty, 1..5)) { frames ->
            val probe = DecoderProbe()
            frames.forEach { probe.feed(it.toBytes()).silence() }
            probe.delivered shouldBe frames
        }
    }

    test("any bytes may come before a frame") {
        checkAll(2 * PropertyTesting.defaultIterationCount, Arb.byteArray(Arb.int(0..300), Arb.byte()), ordinary) { garbage, frame ->
            assume(!isAmbiguous(garbage, listOf(frame)))
            deliveredBehind(garbage, listOf(frame)).last() shouldBe frame
        }
    }

    test("pieces of frames may come before a frame") {
        checkAll(4 * PropertyTesting.defaultIterationCount, nastyText, ordinary) { garbage, frame ->
            val bytes = garbage.toByteArray(Charsets.ISO_8859_1)
            assume(!isAmbiguous(bytes, listOf(frame)))
            deliveredBehind(bytes, listOf(frame)).last() shouldBe frame
        }
    }

    test("frames are delivered in their order, whatever lies between them") {
        checkAll(Arb.list(ordinary, 2..5), Arb.byteArray(Arb.int(0..20), Arb.byte())) { frames, garbage ->
            val stream = frames.fold(ByteArray(0)) { all, frame -> all + garbage + frame.toBytes() }
            assume(!String(garbage, Charsets.ISO_8859_1).contains("f"))
            DecoderProbe().feed(stream).silence().delivered shouldBe frames
        }
    }

    test("any byte of a frame may be anything without cost to the next frame, at once or after a gap").config(tags = thorough) {
        checkAll(30, ordinary, ordinary) { damagedFrame, intact ->
            assume(damagedFrame != intact)
            for (position in 0 until damagedFrame.length()) {
                for (value in 0..255) {
                    val damaged = damagedFrame.toBytes().also { it[position] = value.toByte() }
                    // Kotest's matchers would cost more than the decoder, several hundred thousand times
                    val isBehind = isAmbiguous(damaged, listOf(intact)) || intact in deliveredBehind(damaged, listOf(intact))
                    val isAfterGap = intact in deliveredAfterGap(damaged, listOf(intact))
                    check(isBehind && isAfterGap) {
                        "byte $position of $damagedFrame is $value, and $intact is lost: at once ${!isBehind}, after a gap ${!isAfterGap}"
                    }
                }
            }
        }
    }

    test("any byte of a frame may be lost without cost to the next frame, at once or after a gap").config(tags = thorough) {
        checkAll(500, ordinary, ordinary) { damagedFrame, intact ->
            assume(damagedFrame != intact)
            for (position in 0 until damagedFrame.length()) {
                val bytes = damagedFrame.toBytes()
                val damaged = bytes.copyOfRange(0, position) + bytes.copyOfRange(position + 1, bytes.size)
                withClue({ "byte $position of $damagedFrame is lost, then $intact" }) {
                    if (!isAmbiguous(damaged, listOf(intact))) {
                        deliveredBehind(damaged, listOf(intact)) shouldContain intact
                    }
                    deliveredAfterGap(damaged, listOf(intact)) shouldContain intact
                }
            }
        }
    }

    test("a frame may be cut anywhere without cost to the frames behind it, at once or after a gap").config(tags = thorough) {
        checkAll(500, ordinary, Arb.list(ordinary, 1..4)) { cutFrame, intact ->
            for (length in 0 until cutFrame.length()) {
                val cut = cutFrame.toBytes().copyOf(length)
                withClue({ "$cutFrame cut to $length bytes, then $intact" }) {
                    if (!isAmbiguous(cut, intact)) {
                        deliveredBehind(cut, intact) shouldContainInOrder intact
                    }
                    deliveredAfterGap(cut, intact) shouldContainInOrder intact
                }
            }
        }
    }

    test("ten million random bytes do no harm").config(timeout = 2.minutes, blockingTest = true) {
        val random = Random(1)
        val bytes = ByteArray(10_000_000).also(random::nextBytes)
        val probe = DecoderProbe().feed(bytes, 1000).silence()
        probe.decoder.discarded() shouldBe 10_000_000 - probe.delivered.sumOf { it.length() }
    }

    test("ten million bytes made of pieces of headers do no harm").config(tags = thorough, timeout = 2.minutes, blockingTest = true) {
        val random = Random(2)
        val pieces = listOf("fffe", "f", "e", "FF", "00", "0", "fffe02", "x").map { it.toByteArray() }
        var frames = 0L
        val decoder = FrameDecoder(100) { frames++ }
        var fed = 0
        while (fed < 10_000_000) {
            val piece = pieces[random.nextInt(pieces.size)]
            decoder.accept(piece, 0, piece.size, 0)
            fed += piece.size
        }
        frames shouldBeGreaterThan 0L
        decoder.frames() shouldBe frames
    }

    test("headers inside headers cost bounded work a byte").config(timeout = 2.minutes, blockingTest = true) {
        val bytes = "fffe".repeat(250_000).toByteArray()
        val probe = DecoderProbe().feed(bytes)
        probe.delivered.size shouldBeGreaterThan 0
    }
})

private val thorough = setOf(NamedTag("Thorough"))
