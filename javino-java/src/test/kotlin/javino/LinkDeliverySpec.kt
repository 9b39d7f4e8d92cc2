package javino

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.doubles.shouldBeLessThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain

private const val REQUEST = "getPercepts"

private fun bench(board: LineEnd) = VirtualBench(LinkSettings.defaults().withBootMillis(0), board, Protocol.V2)

class LinkDeliverySpec : FunSpec({
    test("an action returns when the board has acted") {
        val board = VirtualBoard2().apply { takes = 80.0 }
        bench(board).use { bench ->
            bench.link.sendAndAwait("ledOn", 500)
            board.handled shouldContainExactly listOf("2:ledOn")
            bench.millis shouldBeLessThan 130.0
        }
    }

    test("an action of which frames are lost or doubled is carried out once") {
        for (lost in 0..3) {
            var count = 0
            val board = VirtualBoard2().apply { posting = { if (count++ < lost) emptyList() else listOf(it, it) } }
            bench(board).use { bench ->
                bench.link.sendAndAwait("ledOn", 500)
                bench.link.sendAndAwait("ledOn", 500)
                board.handled shouldContainExactly listOf("2:ledOn", "2:ledOn")
            }
        }
    }

    test("an action is repeated three times, and then its outcome is not known") {
        val board = VirtualBoard2().apply { posting = { emptyList() } }
        bench(board).use { bench ->
            shouldThrow<ActionUnconfirmedException> { bench.link.sendAndAwait("ledOn", 500) }.message shouldContain "ledOn"
            board.received.size shouldBe 4
            board.received.distinct().size shouldBe 1
            board.handled shouldContainExactly listOf("2:ledOn")
        }
    }

    test("a refusal is told at once, and the next action is not taken for it") {
        val board = VirtualBoard2()
        bench(board).use { bench ->
            shouldThrow<ActionRefusedException> { bench.link.sendAndAwait("bad(1)", 500) }.message shouldContain "bad(1)"
            bench.millis shouldBeLessThan 60.0
            bench.link.sendAndAwait("ledOn", 500)
            board.handled shouldContainExactly listOf("2:ledOn")
        }
    }

    test("the same action can be sent any number of times, with requests in between") {
        val board = VirtualBoard2()
        bench(board).use { bench ->
            repeat(40) { i ->
                bench.link.sendAndAwait("step", 500)
                repeat(i % 18) { bench.link.request(REQUEST, 500).text() }
            }
            board.handled.count { it == "2:step" } shouldBe 40
        }
    }

    test("a board that stays on while its port is opened again, under whatever name, does not take the next action for a repetition") {
        val board = VirtualBoard2()
        for (name in listOf("again", "serial:again", "again")) { // at the same time, by clocks that begin anew
            VirtualBench(LinkSettings.defaults().withBootMillis(0), board, Protocol.V2, name).use { it.link.sendAndAwait("ledOn", 500) }
        }
        board.handled shouldContainExactly List(3) { "2:ledOn" }
    }

    test("an action that takes long is waited for") {
        val board = VirtualBoard2().apply { takes = 1_500.0 }
        bench(board).use { bench ->
            bench.link.sendAndAwait("walk", 500)
            board.handled shouldContainExactly listOf("2:walk")
        }
    }

    test("a message of several fragments comes whole, up to the limit") {
        val board = VirtualBoard2().apply { answer = { "x".repeat(it * 200) } }
        VirtualBench(LinkSettings.defaults().withBootMillis(0).withMessageLimit(900), board, Protocol.V2).use { bench ->
            repeat(4) { bench.link.request(REQUEST, 5_000).text().length shouldBe (it + 1) * 200 }
            shouldThrow<PortTimeoutException> { bench.link.request(REQUEST, 5_000).text() }
        }
    }

    test("of a message that lacks a fragment nothing comes through, and the next does") {
        for (lost in 0..2) {
            var frames = -1
            val board = VirtualBoard2()
            board.answer = { n -> "$n".repeat(600) }
            board.posting = { frame -> frames++; if (frames == 3 + lost) emptyList() else listOf(frame) }
            bench(board).use { bench ->
                repeat(4) {
                    val text = runCatching { bench.link.request(REQUEST, 2_000).text() }.getOrElse { "" }
                    if (text.isNotEmpty()) {
                        text.length shouldBe 600
                        text.toSet().size shouldBe 1
                    }
                }
                bench.link.request(REQUEST, 2_000).text().length shouldBe 600
            }
        }
    }

    test("a damaged answer is asked for again, within the time") {
        var count = 0
        val board = VirtualBoard2(damage = { bytes ->
            bytes.also { if (it.size > 13 && it[0] == 'f'.code.toByte() && ++count == 3) it[9] = '?'.code.toByte() }
        })
        bench(board).use { bench ->
            repeat(5) { bench.link.request(REQUEST, 500).text() }
            bench.link.corruptFrames() shouldBe 1
        }
    }
})
