package javino.link

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.shouldBeGreaterThan
import io.kotest.matchers.doubles.shouldBeLessThan
import io.kotest.matchers.shouldBe
import javino.LineSettings
import javino.PortTimeoutException
import javino.Protocol

private const val REQUEST = "getPercepts"
private val RUNNING = LinkSettings.defaults().withBootMillis(0)

class LinkFreshnessSpec : FunSpec({
    test("a board that was stopped for seconds and answers all requests in one burst leaves the next percepts fresh") {
        val board = VirtualBoard()
        VirtualBench(RUNNING, board).use { bench ->
            bench.link.request(REQUEST, 1_000).text() shouldBe "1;"
            board.stopped = true
            repeat(5) { shouldThrow<PortTimeoutException> { bench.link.request(REQUEST, 1_000).text() } }
            board.stopped = false
            bench.link.request(REQUEST, 1_000).text() shouldBe "7;"
            bench.link.request(REQUEST, 1_000).text() shouldBe "8;"
        }
    }

    test("a message that came of its own accord between two requests is not an answer") {
        val board = VirtualBoard()
        VirtualBench(RUNNING, board).use { bench ->
            bench.link.request(REQUEST, 500).text() shouldBe "1;"
            board.say(bench.millis + 50, "old;")
            bench.awayFor(100)
            bench.link.request(REQUEST, 500).text() shouldBe "2;"
        }
    }

    test("an answer that comes between two requests is dropped") {
        val board = VirtualBoard(answersAfter = 600.0)
        VirtualBench(RUNNING, board).use { bench ->
            shouldThrow<PortTimeoutException> { bench.link.request(REQUEST, 500).text() }
            bench.awayFor(200)
            board.answersAfter = 0.0
            bench.link.request(REQUEST, 500).text() shouldBe "2;"
        }
    }

    test("an answer that comes after the next request is not taken for its answer") {
        val board = VirtualBoard()
        VirtualBench(RUNNING, board).use { bench ->
            bench.link.request(REQUEST, 500).text() shouldBe "1;"
            board.answersAfter = 510.0
            shouldThrow<PortTimeoutException> { bench.link.request(REQUEST, 500).text() }
            board.answersAfter = 20.0
            bench.link.request(REQUEST, 500).text() shouldBe "3;"
        }
    }

    test("after one missed answer, only the next exchange waits for silence") {
        val board = VirtualBoard()
        VirtualBench(RUNNING, board).use { bench ->
            board.silent = true
            shouldThrow<PortTimeoutException> { bench.link.request(REQUEST, 500).text() }
            board.silent = false
            bench.link.request(REQUEST, 500).text()
            val before = bench.millis
            bench.link.request(REQUEST, 500).text()
            bench.millis - before shouldBeLessThan 52.1 + 45.0 // the gap is longer while few answers are known
        }
    }

    test("a line that never falls silent ends an exchange too") {
        val board = VirtualBoard()
        VirtualBench(RUNNING, board).use { bench ->
            board.silent = true
            shouldThrow<PortTimeoutException> { bench.link.request(REQUEST, 500).text() }
            (0..400).forEach { board.say(bench.millis + it * 20, "tick($it);") }
            val before = bench.millis
            bench.link.request(REQUEST, 500).text()
            bench.millis - before shouldBeLessThan 1_100.0
        }
    }

    test("of several messages that are waiting, listening takes the newest") {
        val board = VirtualBoard().apply { (1..5).forEach { say(it * 10.0, "tick($it);") } }
        VirtualBench(RUNNING, board).use { bench ->
            bench.link.listen(1_000).text() shouldBe "tick(1);"
            bench.awayFor(200)
            bench.link.listen(1_000).text() shouldBe "tick(5);"
        }
    }

    test("a board that never answered a request but speaks by itself is not taken to be busy answering") {
        val board = VirtualBoard().apply { silent = true }
        VirtualBench(LinkSettings.defaults(), board).use { bench ->
            bench.link.sendAndAwait("a", 500) // asks whether the board has started, and gets no answer
            (1..20).forEach { board.say(bench.millis + it * 40, "tick($it);") }
            repeat(5) {
                bench.link.listen(500).text()
                val before = bench.millis
                bench.link.sendAndAwait("b", 500)
                bench.millis - before shouldBeLessThan 52.1 + 45.0
            }
        }
    }

    test("an action returns when its last byte has left by the line's rate") {
        val board = VirtualBoard()
        VirtualBench(RUNNING, board).use { bench ->
            bench.link.sendAndAwait("x".repeat(90), 500)
            bench.millis shouldBe (96 * LineSettings(9600).byteNanos() / 1e6)
        }
    }

    test("an action on a line that is not paced returns at once") {
        VirtualBench(RUNNING.withPaced(false), VirtualBoard()).use { bench ->
            bench.link.sendAndAwait("x".repeat(90), 500)
            bench.millis shouldBe 0.0
        }
    }

    test("a time limit of no time is refused") {
        VirtualBench(RUNNING, VirtualBoard()).use { bench ->
            shouldThrow<IllegalArgumentException> { bench.link.request(REQUEST, 0).text() }
            shouldThrow<IllegalArgumentException> { bench.link.sendAndAwait("stop", -1) }
            shouldThrow<IllegalArgumentException> { bench.link.listen(0).text() }
        }
    }

    test("a message carries the time of its last byte, also when the line was given time to fall silent behind it") {
        val board = VirtualBoard()
        VirtualBench(RUNNING, board).use { bench ->
            fun age(reply: Reply) = bench.millis - reply.receivedNanos() / 1e6
            age(bench.link.request(REQUEST, 500)) shouldBeLessThan 1.0
            board.silent = true
            shouldThrow<PortTimeoutException> { bench.link.request(REQUEST, 500) }
            board.silent = false
            val late = bench.link.request(REQUEST, 500)
            late.version() shouldBe Protocol.V1
            age(late) shouldBeGreaterThan 49.0
            board.say(bench.millis + 10, "bump;")
            bench.awayFor(100)
            age(bench.link.listen(500)) shouldBeLessThan 1.0
        }
    }
})
