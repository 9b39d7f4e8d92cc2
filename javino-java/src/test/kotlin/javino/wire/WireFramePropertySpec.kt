package javino.wire

import io.kotest.assertions.withClue
import io.kotest.common.ExperimentalKotest
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.ints.shouldBeLessThan
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.PropTestConfig
import io.kotest.property.arbitrary.bind
import io.kotest.property.arbitrary.boolean
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll
import java.util.Random

private const val START = 0xA5.toByte()

private fun frames(fromBoard: Boolean, lengths: IntRange = 0..WireFrame.MAX_PAYLOAD): Arb<WireFrame> = Arb.bind(
    Arb.element(FrameKind.entries.filter { it.isFromBoard == fromBoard }),
    Arb.boolean(),
    Arb.boolean(),
    Arb.int(0..0xFF),
    texts(lengths),
) { kind, isRefused, isBusy, number, payload -> WireFrame(kind, fromBoard && isRefused, fromBoard && isBusy, number, payload) }

private fun bytesOf(frames: List<WireFrame>) = frames.fold(ByteArray(0)) { all, frame -> all + frame.toBytes(NONCE) }

@OptIn(ExperimentalKotest::class) // for the seed: one damaged frame in 65,536 has a right checksum
class WireFramePropertySpec : FunSpec({
    for (fromBoard in listOf(false, true)) {
        val from = if (fromBoard) "a board" else "a computer"

        test("every frame of $from comes back, in chunks of any size") {
            checkAll(Arb.list(frames(fromBoard), 1..4), Arb.int(1..40)) { sent, chunk ->
                Receiver(fromBoard).receive(bytesOf(sent), chunk).frames shouldBe sent
            }
        }

        test("a frame of $from holds no start but its own, and is as long as it says but for escapes") {
            checkAll(frames(fromBoard)) { frame ->
                val bytes = frame.toBytes(NONCE)
                bytes.count { it == START } shouldBe 1
                bytes[0] shouldBe START
                bytes.size - bytes.count { it == 0xA4.toByte() } shouldBe frame.length()
            }
        }

        test("any noise in front of a frame of $from costs no frame") {
            checkAll(texts(0..60), frames(fromBoard)) { noise, frame ->
                Receiver(fromBoard).receive(bytesOf(noise) + frame.toBytes(NONCE)).frames.last() shouldBe frame
            }
        }

        test("a frame of $from that is cut costs none of those behind it") {
            checkAll(300, frames(fromBoard, 0..20), frames(fromBoard)) { cut, next ->
                for (length in 0 until cut.toBytes(NONCE).size) {
                    Receiver(fromBoard).receive(cut.toBytes(NONCE).copyOf(length) + next.toBytes(NONCE)).frames shouldBe listOf(next)
                }
            }
        }

        test("a frame of $from with a changed bit gives no frame and costs none of those behind it") {
            checkAll(PropTestConfig(seed = 5, iterations = 100), frames(fromBoard, 0..12), frames(fromBoard)) { frame, next ->
                val sound = frame.toBytes(NONCE)
                for (bit in 0 until 8 * sound.size) {
                    val damaged = sound.clone().also { it[bit / 8] = (it[bit / 8].toInt() xor (1 shl bit % 8)).toByte() }
                    withClue("$frame, bit $bit") {
                        Receiver(fromBoard).receive(damaged).silence(101).receive(next.toBytes(NONCE)).frames shouldBe listOf(next)
                    }
                }
            }
        }
    }

    test("damage makes another frame no more often than the checksum allows") {
        val random = Random(3)
        var wrong = 0
        repeat(100_000) {
            val sent = WireFrame.of(FrameKind.COMMANDS, random.nextInt(256), "\u0008speed(" + random.nextInt(10) + ")")
            val bytes = sent.toBytes(NONCE)
            repeat(1 + random.nextInt(6)) { bytes[random.nextInt(bytes.size)] = random.nextInt(256).toByte() }
            wrong += Receiver(false).receive(bytes).frames.count { it != sent }
        }
        wrong shouldBeLessThan 12 // of 65,536 checksums, at most 1.5 are expected
    }

    test("random bytes do no harm, and all frames that were begun are accounted for") {
        val bytes = ByteArray(2_000_000).also(Random(4)::nextBytes)
        val receiver = Receiver(true).receive(bytes, 997).silence(101)
        receiver.decoder.damaged() + receiver.frames.size shouldBe bytes.count { it == START }.toLong()
    }

    test("a silence ends a frame, a shorter one does not") {
        checkAll(100, frames(true, 0..20), Arb.int(1..1_000), Arb.element(100L, 101L)) { frame, at, millis ->
            val bytes = frame.toBytes(NONCE)
            val cut = 1 + at % (bytes.size - 1)
            val receiver = Receiver(true).receive(bytes.copyOf(cut)).silence(millis).receive(bytes.copyOfRange(cut, bytes.size))
            receiver.frames shouldBe if (millis > 100) listOf() else listOf(frame)
            receiver.decoder.damaged() shouldBe if (millis > 100) 1 else 0
        }
    }

    test("a board ends a frame whose payload is longer than it takes, at once") {
        val received = mutableListOf<WireFrame>()
        val decoder = WireDecoder(false, 100, 20, { NONCE }, received::add)
        checkAll(200, frames(false, 0..40)) { frame ->
            received.clear()
            frame.toBytes(NONCE).forEachIndexed { i, octet ->
                decoder.accept(octet, 0)
                if (i >= 2 && frame.payload().length > 20) decoder.isInFrame shouldBe false
            }
            received shouldBe listOf(frame).filter { it.payload().length <= 20 }
        }
    }

    test("bytes outside of frames are left to version 1") {
        val decoder = WireDecoder(false, 100, { NONCE }) {}
        val frame = WireFrame.of(FrameKind.HELLO, 7, "").toBytes(NONCE)
        (byteArrayOf(1) + frame + byteArrayOf(2)).map { decoder.accept(it, 0) } shouldBe listOf(false) + frame.map { true } + false
    }

    test("what a frame cannot hold is refused") {
        listOf<() -> Any>(
            { WireFrame.of(FrameKind.COMMANDS, 0, "x".repeat(256)) },
            { WireFrame.of(FrameKind.COMMANDS, 256, "") },
            { WireFrame(FrameKind.COMMANDS, true, false, 0, "") },
        ).map { runCatching(it).exceptionOrNull()?.javaClass } shouldBe List(3) { IllegalArgumentException::class.java }
    }
})
