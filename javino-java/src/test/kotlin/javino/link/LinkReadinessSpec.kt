package javino.link

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.doubles.shouldBeBetween
import io.kotest.matchers.doubles.shouldBeGreaterThan
import io.kotest.matchers.doubles.shouldBeLessThan
import io.kotest.matchers.shouldBe
import javino.PortTimeoutException

private const val REQUEST = "getPercepts"

/** Milliseconds for a request and a short answer at 9600 baud, with a reserve. */
private const val EXCHANGE = 17.7 + 9.0

class LinkReadinessSpec : FunSpec({
    test("a board that runs is asked once and answers at once") {
        val board = VirtualBoard()
        VirtualBench(board = board).use { bench ->
            bench.link.request(REQUEST, 500).text() shouldBe "1;"
            bench.millis shouldBeLessThan EXCHANGE
            board.texts shouldContainExactly listOf(REQUEST)
        }
    }

    test("a board that starts is asked again until it answers") {
        val board = VirtualBoard(startsAt = 1_800.0)
        VirtualBench(board = board).use { bench ->
            bench.link.request(REQUEST, 500).text() shouldBe "1;"
            bench.millis.shouldBeBetween(1_800.0, 1_800.0 + 268.0 + EXCHANGE + 50.0, 1.0)
            bench.link.request(REQUEST, 500).text() shouldBe "2;"
        }
    }

    test("an action waits until the board that starts has answered") {
        val board = VirtualBoard(startsAt = 1_800.0)
        VirtualBench(board = board).use { bench ->
            bench.link.sendAndAwait("ledOn", 500)
            bench.awayFor(5)
            board.texts shouldContainExactly listOf(REQUEST, "ledOn")
        }
    }

    test("an action to a board that never answers goes when it must have started") {
        val board = VirtualBoard().apply { silent = true }
        VirtualBench(board = board).use { bench ->
            bench.link.sendAndAwait("ledOn", 500)
            bench.awayFor(5)
            board.received.last().first shouldBe "ledOn"
            board.received.last().second.shouldBeBetween(3_000.0, 3_300.0, 0.0)
            val before = bench.millis
            bench.link.sendAndAwait("ledOff", 500)
            bench.millis - before shouldBeLessThan 52.1 + 45.0 // the gap is longer while no answers are known
        }
    }

    test("a request to a board that never answers ends when it must have started") {
        VirtualBench(board = VirtualBoard().apply { silent = true }).use { bench ->
            shouldThrow<PortTimeoutException> { bench.link.request(REQUEST, 500).text() }
            bench.millis.shouldBeBetween(3_000.0, 3_300.0, 0.0)
            val before = bench.millis
            shouldThrow<PortTimeoutException> { bench.link.request(REQUEST, 500).text() }
            (bench.millis - before).shouldBeBetween(500.0, 545.0, 0.0)
        }
    }

    test("a time limit beyond the board's start is kept") {
        VirtualBench(board = VirtualBoard(startsAt = 4_000.0)).use { bench ->
            bench.link.request(REQUEST, 6_000).text() shouldBe "1;"
        }
    }

    test("a board that is known to run is not asked before an action") {
        val board = VirtualBoard()
        VirtualBench(LinkSettings.defaults().withBootMillis(0), board).use { bench ->
            bench.link.sendAndAwait("ledOn", 500)
            bench.awayFor(5)
            board.texts shouldContainExactly listOf("ledOn")
        }
    }

    test("once it has answered, a board is not asked before an action") {
        val board = VirtualBoard()
        VirtualBench(board = board).use { bench ->
            bench.link.request(REQUEST, 500).text()
            bench.link.sendAndAwait("ledOn", 500)
            bench.awayFor(5)
            board.texts shouldContainExactly listOf(REQUEST, "ledOn")
        }
    }

    test("a message that the board sends of its own accord says that it runs") {
        val board = VirtualBoard().apply { say(100.0, "bump;") }
        VirtualBench(board = board).use { bench ->
            bench.link.listen(1_000).text() shouldBe "bump;"
            bench.link.sendAndAwait("ledOn", 500)
            bench.awayFor(5)
            board.texts shouldContainExactly listOf("ledOn")
        }
    }

    test("a long answer is not asked for again while it is coming") {
        val board = VirtualBoard(padding = 255)
        VirtualBench(board = board).use { bench ->
            bench.link.request(REQUEST, 500).text().trim() shouldBe "1;"
            bench.millis shouldBeGreaterThan 250.0
            board.texts shouldContainExactly listOf(REQUEST)
        }
    }

    test("a board that takes longer to answer than it is given between two requests is not left one answer behind") {
        val board = VirtualBoard(answersAfter = 300.0)
        VirtualBench(board = board).use { bench ->
            bench.link.request(REQUEST, 1_000).text()
            val asked = board.received.size
            bench.link.request(REQUEST, 1_000).text() shouldBe "${asked + 1};"
        }
    }
})
