package argo.fleet.cluster

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldHaveSize
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.byte
import io.kotest.property.arbitrary.byteArray
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.long
import io.kotest.property.checkAll
import java.util.concurrent.CompletableFuture

/** A session between two computers: its frames, its window and its bounds. */
class OutgoingIncomingSpec : FunSpec({
    fun Outgoing.send(size: Int) = CompletableFuture<Void>().also { add(ByteArray(size), it) }

    test("each frame reads as it was written") {
        checkAll(Arb.long(), Arb.long(), Arb.byteArray(Arb.int(0..64), Arb.byte())) { number, oldest, content ->
            val piece = Frame.of(Frame.Piece(number, oldest, true, content).bytes()) as Frame.Piece
            listOf(piece.number, piece.oldest, piece.isLast, piece.content.toList()) shouldBe listOf(number, oldest, true, content.toList())
            val news = Frame.Acknowledgement(number, oldest, true, mapOf(number to "für wen?", oldest to ""))
            val read = Frame.of(news.bytes()) as Frame.Acknowledgement
            listOf(read.taken, read.arrived, read.isRepeatWanted, read.refusals) shouldBe listOf(number, oldest, true, news.refusals)
        }
    }

    test("a refusal reads as it was written, and any other words have an error too") {
        fun read(line: String) = Refused.of(line).run { listOf(error, message) }
        read(Refused("no_agent", "there is no agent\nb").line) shouldBe listOf("no_agent", "there is no agent\nb")
        read("Who are you?") shouldBe listOf("refused", "Who are you?")
        Refused.of(IllegalStateException("broken")).run { listOf(error, message) } shouldBe listOf("refused", "broken")
    }

    test("bytes that are no frame are refused, whatever they are") {
        checkAll(Arb.byteArray(Arb.int(0..40), Arb.byte())) { bytes ->
            runCatching { Frame.of(bytes) }.exceptionOrNull()?.let { (it is IllegalArgumentException) shouldBe true }
        }
        shouldThrow<IllegalArgumentException> { Frame.of(byteArrayOf(99)) }.message shouldBe "a frame of the unknown kind 99"
        shouldThrow<IllegalArgumentException> { Frame.of(byteArrayOf(1, 0)) }.message shouldBe "a frame that ends after 2 bytes, too early"
    }

    test("a window of pieces is under way, and the rest follows as they are taken") {
        val outgoing = Outgoing("scout", 1)
        repeat(1000) { outgoing.send(0) }
        outgoing.due(0) shouldHaveSize 512
        outgoing.due(0).shouldBeEmpty()
        outgoing.acknowledged(Frame.Acknowledgement(11, 513, false, mapOf()), 0) shouldHaveSize 10
        outgoing.due(0) shouldHaveSize 10
    }

    test("a message that is too long, or that too much waits before, is refused with words") {
        val outgoing = Outgoing("scout", 1)
        shouldThrow<Overloaded> { outgoing.send(Outgoing.MAX_MESSAGE + 1) }.message shouldBe
            "a message of 8388609 bytes to scout is too long; the longest has 8388608"
        repeat(2) { outgoing.send(Outgoing.MAX_MESSAGE) }
        shouldThrow<Overloaded> { outgoing.send(1) }.message shouldBe
            "1024 pieces of messages, 16777216 bytes, wait for scout, which takes them too slowly"
    }

    test("messages that were given up are left out by the receiver, also where half of one has arrived") {
        val outgoing = Outgoing("scout", 1)
        val incoming = Incoming()
        outgoing.send(40_000)
        incoming.take(outgoing.due(0).first()).message shouldBe null
        outgoing.giveUp("gone").map { it.failure?.message } shouldBe listOf("gone")
        val later = outgoing.send(3)
        val message = incoming.take(outgoing.due(0).single()).message!!
        message.content.size shouldBe 3
        incoming.taken(message.number, null)
        outgoing.acknowledged(incoming.acknowledgement(), 0).single().done shouldBe later
    }

    test("refusals that a sender never confirms to have are forgotten with the window in which it can wait for them") {
        val incoming = Incoming()
        for (number in 1L..10_000) {
            incoming.take(Frame.Piece(number, 1, true, ByteArray(1)))
            incoming.taken(number, "refused it is no message")
        }
        incoming.acknowledgement().refusals.keys.toList() shouldBe (9488L..10_000).toList()
    }

    test("messages of a sender that waits for no acknowledgement are dropped while too many wait for the listener") {
        fun kept(size: Int): Int {
            val incoming = Incoming()
            val kept = (1L..10_000).count { incoming.take(Frame.Piece(it, 1, true, ByteArray(size))).message != null }
            incoming.taken(1, null)
            incoming.take(Frame.Piece(kept + 1L, 1, true, ByteArray(size))).message?.number shouldBe kept + 1L
            return kept
        }
        kept(size = 1) shouldBe 1024
        kept(size = 1 shl 20) shouldBe 17
    }

    test("a message longer than any may be is not put together") {
        val incoming = Incoming()
        shouldThrow<IllegalArgumentException> {
            for (number in 1L..9) incoming.take(Frame.Piece(number, 1, false, ByteArray(1 shl 20)))
        }.message shouldBe "a message of more than 8388608 bytes"
    }
})
