package javino.sim

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import javino.ActionRefusedException
import javino.Frame
import javino.LineClock
import javino.LineSettings
import javino.NoSuchPortException
import javino.PortGoneException
import javino.PortTimeoutException
import javino.Protocol
import javino.Transports
import javino.failure
import javino.link.Link
import javino.link.LinkSettings
import java.util.concurrent.atomic.AtomicInteger

private const val LONG_MILLIS = 20_000
private val names = AtomicInteger()
private val SETTINGS = LinkSettings.defaults().withBaud(1_000_000)

private fun withBoard(work: (FakeBoard, Link) -> Unit) {
    FakeBoard.plugIn("fake${names.incrementAndGet()}").use { board ->
        Link.open(board.port(), SETTINGS, "the test").use { work(board, it) }
    }
}

class FakeBoardSpec : FunSpec({
    test("a board that is not plugged in runs at the far end of any line, and a link may be put on its near end") {
        val board = FakeBoard.unplugged("bench", LineClock.system())
        board.whenAsked("getPercepts").answer("dist(f,10);")
        val line = MemoryLine.unlimited("bench", LineSettings.defaults())
        val program = Thread { runCatching { board.program().run(line.board()) } }.apply { isDaemon = true }.also { it.start() }
        Link.over(line.computer(), LinkSettings.defaults(), LineClock.system()).use {
            it.request("getPercepts", 20_000).text() shouldBe "dist(f,10);"
        }
        program.join(20_000)
        program.isAlive shouldBe false
        Link.ownerOf("bench").isPresent shouldBe false
    }

    test("answers come in turn, the last again and again") {
        withBoard { board, link ->
            board.whenAsked("getPercepts").answer("a;", "b;")
            List(3) { link.request("getPercepts", LONG_MILLIS).text() } shouldContainExactly listOf("a;", "b;", "b;")
        }
    }

    test("an answer may be computed from the message, and rules may be for a kind of message") {
        withBoard { board, link ->
            board.whenAsked { it.startsWith("get") }.answer { "asked($it);" }
            link.request("getLight", LONG_MILLIS).text() shouldBe "asked(getLight);"
            link.request("getPercepts", LONG_MILLIS).text() shouldBe ""
        }
    }

    test("a board of version 2 answers at any length, acknowledges and refuses") {
        FakeBoard.plugIn("fake${names.incrementAndGet()}").version2().use { board ->
            board.whenAsked("getPercepts").answer("x".repeat(1_000))
            board.whenAsked("fly").refuse()
            board.expect("ledOn").expect("ledOn")
            Link.open(board.port(), SETTINGS.withProtocol(Protocol.AUTO), "the test").use { link ->
                link.request("getPercepts", LONG_MILLIS).text() shouldBe "x".repeat(1_000)
                link.protocol() shouldBe Protocol.V2
                repeat(2) { link.sendAndAwait("ledOn", LONG_MILLIS) }
                shouldThrow<ActionRefusedException> { link.sendAndAwait("fly", LONG_MILLIS) }
            }
        }
    }

    test("a message that nobody expected fails the test with a list of all that came") {
        val failure = shouldThrow<AssertionError> {
            withBoard { board, link ->
                link.sendAndAwait("ledOn", LONG_MILLIS)
                link.sendAndAwait("stop", LONG_MILLIS)
                board.awaitMessage("stop", LONG_MILLIS)
            }
        }
        failure.message shouldContain "received what nobody expected: \"ledOn\";"
        failure.message shouldContain Regex("\"getPercepts\" at \\d+ ms, \"ledOn\" at \\d+ ms, \"stop\" at \\d+ ms")
    }

    test("a message that was expected may come, and has to") {
        withBoard { board, link ->
            board.expect("ledOn")
            shouldThrow<AssertionError> { board.verify() }.message shouldContain "did not receive: \"ledOn\""
            link.sendAndAwait("ledOn", LONG_MILLIS)
            link.request("getPercepts", LONG_MILLIS).text()
            board.verify()
        }
    }

    test("a message counts as expected when it came before it was said to") {
        withBoard { board, link ->
            link.sendAndAwait("ledOn", LONG_MILLIS)
            link.request("getPercepts", LONG_MILLIS).text()
            board.expect("ledOn").verify()
        }
    }

    test("a lenient board lets anything come") {
        withBoard { board, link ->
            board.lenient().expect("never")
            link.sendAndAwait("ledOn", LONG_MILLIS)
            link.request("getPercepts", LONG_MILLIS).text()
        }
    }

    test("waiting for a message that does not come fails with what came") {
        withBoard { board, link ->
            link.request("getPercepts", LONG_MILLIS).text()
            val failure = shouldThrow<AssertionError> { board.awaitMessage("stop", 10) }
            failure.message shouldContain "\"stop\""
            failure.message shouldContain Regex("what came in all: \"getPercepts\" at \\d+ ms$")
        }
    }

    test("each message has the time at which the board took it up, by the clock of its line") {
        withBoard { board, link ->
            val begin = System.nanoTime()
            link.request("getPercepts", LONG_MILLIS).text()
            val between = System.nanoTime()
            link.sendAndAwait("ledOn", LONG_MILLIS)
            board.awaitMessage("ledOn", LONG_MILLIS)
            val (asked, commanded) = board.receivedMessages()
            asked.text() shouldBe "getPercepts"
            commanded.text() shouldBe "ledOn"
            (asked.nanos() - begin in 0..between - begin) shouldBe true
            (commanded.nanos() - between in 0..System.nanoTime() - between) shouldBe true
        }
    }

    test("messages that rules cover are not handed out, but are recorded") {
        withBoard { board, link ->
            board.whenAsked("ledOn").staySilent()
            link.sendAndAwait("ledOn", LONG_MILLIS)
            link.sendAndAwait("stop", LONG_MILLIS)
            board.awaitMessage(LONG_MILLIS) shouldBe "stop"
            board.received() shouldContainExactly listOf("getPercepts", "ledOn", "stop")
        }
    }

    test("a board that holds one message loses the first of two that come in one burst, and says so") {
        val failure = shouldThrow<AssertionError> {
            FakeBoard.plugIn("fake${names.incrementAndGet()}").use { board ->
                board.queueSize(1)
                Transports.open(board.port(), LineSettings(1_000_000)).use { computer ->
                    board.awaitOpen(LONG_MILLIS)
                    board.stall()
                    for (message in listOf("fffe05ledOn", "fffe04stop")) {
                        computer.write(message.toByteArray(), 0, message.length, LONG_MILLIS)
                    }
                    computer.read(ByteArray(1), 0, 1, 20)
                    board.resume()
                    board.awaitMessage("stop", LONG_MILLIS)
                    board.overwritten() shouldContainExactly listOf("ledOn")
                }
            }
        }
        failure.message shouldContain "lost: \"ledOn\""
    }

    test("what comes while a board boots is lost") {
        FakeBoard.plugIn("fake${names.incrementAndGet()}").use { board ->
            board.bootTakes(100)
            Link.open(board.port(), SETTINGS, "the test").use { link ->
                link.sendAndAwait("ledOn", LONG_MILLIS)
                board.awaitMessage("ledOn", LONG_MILLIS)
            }
        }
    }

    test("a delayed answer comes after its time, a silent board's never") {
        withBoard { board, link ->
            board.whenAsked("getPercepts").after(600).answer("late;")
            shouldThrow<PortTimeoutException> { link.also { it.request("getPercepts", LONG_MILLIS) }.request("getPercepts", 10) }
            board.whenAsked("getPercepts").staySilent()
            shouldThrow<PortTimeoutException> { link.request("getPercepts", 10).text() }
        }
    }

    test("an unplugged board is gone, and is back when it is plugged in again") {
        val board = FakeBoard.plugIn("fake${names.incrementAndGet()}")
        val link = Link.open(board.port(), SETTINGS, "the test")
        link.request("getPercepts", LONG_MILLIS).text()
        board.unplug()
        shouldThrow<PortGoneException> { link.request("getPercepts", LONG_MILLIS).text() }
        shouldThrow<NoSuchPortException> { Link.open(board.port(), SETTINGS, "the test") }
        board.replug()
        Link.open(board.port(), SETTINGS, "the test").use { it.request("getPercepts", LONG_MILLIS).text() shouldBe "" }
        board.close()
    }

    test("sending to nobody is refused") {
        FakeBoard.plugIn("fake${names.incrementAndGet()}").use { board ->
            shouldThrow<IllegalStateException> { board.send("bump;") }.message.shouldNotBeNull()
            shouldThrow<AssertionError> { board.awaitOpen(1) }.message shouldContain board.port()
        }
    }
})
