package javino.link

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import javino.PortTimeoutException
import javino.Protocol
import javino.Transport
import javino.sim.VirtualBoard2
import javino.virtual.LineEnd

private const val REQUEST = "getPercepts"

/** [board] behind a line that echoes all sent bytes, such as a two-wire RS-485 adapter. */
private class EchoingLine(private val board: LineEnd) : LineEnd {
    override fun look(end: Transport, now: Double) = board.look(
        object : Transport by end {
            override fun read(b: ByteArray, off: Int, len: Int, timeoutMillis: Int): Int =
                end.read(b, off, len, timeoutMillis).also { if (it > 0) end.write(b, off, it, 0) }
        },
        now,
    )
}

private val nothing = LineEnd { end, _ -> end.read(ByteArray(1024), 0, 1024, 0) }

private fun echoing(board: LineEnd) = VirtualBench(LinkSettings.defaults(), EchoingLine(board), Protocol.AUTO)

class EchoSpec : FunSpec({
    test("a version 1 board behind a line that echoes is understood") {
        val board = VirtualBoard()
        echoing(board).use { bench ->
            bench.link.request(REQUEST, 500).text() shouldBe "1;"
            bench.link.protocol() shouldBe Protocol.V1
            bench.link.sendAndAwait("ledOn", 500)
            bench.link.request(REQUEST, 500).text() shouldBe "2;"
            board.texts.filter { it != REQUEST } shouldBe listOf("ledOn")
        }
    }

    test("a version 2 board behind a line that echoes is understood") {
        val board = VirtualBoard2()
        echoing(board).use { bench ->
            for (n in 1..40) {
                bench.link.request(REQUEST, 500).text() shouldBe "$n;"
                bench.link.sendAndAwait("speed($n)", 500)
            }
            bench.link.protocol() shouldBe Protocol.V2
            board.handled.count { it.startsWith("2:speed") } shouldBe 40
        }
    }

    test("a line that only echoes gives no answer") {
        echoing(nothing).use { bench -> repeat(5) { shouldThrow<PortTimeoutException> { bench.link.request(REQUEST, 500).text() } } }
    }

    test("a command that comes back is no message of the board") {
        echoing(VirtualBoard()).use { bench ->
            bench.link.request(REQUEST, 500).text()
            bench.link.sendAndAwait("ledOn", 500)
            shouldThrow<PortTimeoutException> { bench.link.listen(500).text() }
        }
    }

    test("a board that says what it was told is heard") {
        val board = VirtualBoard()
        VirtualBench(LinkSettings.defaults(), board, Protocol.AUTO).use { bench ->
            bench.link.request(REQUEST, 500).text()
            bench.link.sendAndAwait("ledOn", 500)
            board.say(bench.millis, "ledOn")
            bench.link.listen(500).text() shouldBe "ledOn"
        }
    }
})
