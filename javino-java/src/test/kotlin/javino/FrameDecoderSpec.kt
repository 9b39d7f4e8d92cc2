package javino

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe

/** What the vectors do not tell of the decoder, see [VectorsSpec]. */
class FrameDecoderSpec : FunSpec({
    test("a frame that stops half-way is given up after the inter-byte timeout") {
        DecoderProbe().feed("fffe05hel").silence().feed("lo").texts().shouldBeEmpty()
        DecoderProbe().feed("fffe05hel").silence().feed("fffe05world").texts() shouldContainExactly listOf("world")
    }

    test("silence is noticed by the next byte too") {
        val frames = mutableListOf<String>()
        val decoder = FrameDecoder(100) { frames += it.text() }
        "fffe05hel".forEach { decoder.accept(it.code.toByte(), 0) }
        "lo".forEach { decoder.accept(it.code.toByte(), 101) }
        frames.shouldBeEmpty()
    }

    test("a gap as long as the timeout is no silence yet") {
        val frames = mutableListOf<String>()
        val decoder = FrameDecoder(100) { frames += it.text() }
        "fffe05hello".forEachIndexed { i, c -> decoder.accept(c.code.toByte(), 100L * i) }
        frames shouldContainExactly listOf("hello")
    }

    test("a reader that was held up does not cut a frame in two") {
        val frames = mutableListOf<String>()
        val decoder = FrameDecoder(100) { frames += it.text() }
        val bytes = "fffe05hello".toByteArray()
        decoder.acceptUnbroken(bytes, 0, 8, 0)
        decoder.acceptUnbroken(bytes, 8, 3, 5_000)
        frames shouldContainExactly listOf("hello")
    }

    test("who waits is told when silence would decide something") {
        val decoder = FrameDecoder(100) { }
        decoder.nanosUntilIdle(0) shouldBe Long.MAX_VALUE
        decoder.accept('f'.code.toByte(), 10)
        decoder.nanosUntilIdle(50) shouldBe 61
        decoder.nanosUntilIdle(500) shouldBe 0
        decoder.idle(111)
        decoder.nanosUntilIdle(111) shouldBe Long.MAX_VALUE
    }

    test("a reset forgets an unfinished frame") {
        val probe = DecoderProbe().feed("fffe05hel")
        probe.decoder.reset()
        probe.feed("lofffe05world").texts() shouldContainExactly listOf("world")
    }

    test("frames and discarded bytes are counted") {
        val decoder = DecoderProbe().feed("xxfffe05hellofffe0").silence().decoder
        decoder.frames() shouldBe 1
        decoder.discarded() shouldBe 2 + 11 + 5
        DecoderProbe().feed("xxfffe05hello").silence().decoder.discarded() shouldBe 2
    }

    test("the receiver's exception comes through and leaves the decoder usable") {
        val frames = mutableListOf<String>()
        val decoder = FrameDecoder(100) { if (it.text() == "bad") error("receiver") else frames += it.text() }
        shouldThrow<IllegalStateException> { decoder.accept("fffe03bad".toByteArray(), 0, 9, 0) }
        decoder.accept("fffe04good".toByteArray(), 0, 10, 1)
        frames shouldContainExactly listOf("good")
    }

    test("time may be any number, also beyond the largest") {
        val frames = mutableListOf<String>()
        val decoder = FrameDecoder(100) { frames += it.text() }
        decoder.accept("fffe05hel".toByteArray(), 0, 9, Long.MAX_VALUE - 10)
        decoder.accept("lo".toByteArray(), 0, 2, Long.MIN_VALUE + 10)
        frames shouldContainExactly listOf("hello")
    }

    test("the inter-byte timeout is 100 ms, or 20 byte times on a slow line") {
        FrameDecoder.interByteTimeoutNanos(LineSettings(9600)) shouldBe 100_000_000
        FrameDecoder.interByteTimeoutNanos(LineSettings(300)) shouldBe 20 * 33_333_333L
    }
})
