package javino.link

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldEndWith
import javino.LineSettings
import javino.PortTimeoutException
import javino.Protocol
import javino.failure
import javino.sim.FakeBoard

/** Time limit of unanswered requests, longer than pauses of a busy machine. */
private const val SILENT_MS = 500
private const val LIMIT_MS = 20_000

class StrayBytesSpec : FunSpec({
    val settings = LinkSettings.defaults().withProtocol(Protocol.V1).withBootMillis(0)

    fun failure(answer: String, ask: (Link) -> Unit = { it.request("getPercepts", SILENT_MS) }): String =
        FakeBoard.plugIn("stray").lenient().use { board ->
            board.whenAsked("getPercepts").answerRaw(answer)
            Link.open(board.port(), settings, "the test").use { link -> shouldThrow<PortTimeoutException> { ask(link) }.message.orEmpty() }
        }

    test("text in place of a message is shown, with Serial.print as its likely cause") {
        failure("dist(f,30);\r\n") shouldEndWith "within $SILENT_MS ms; 13 bytes came since the last message and are no message: " +
            "\"dist(f,30);\\r\\n\", which is text without a frame: does the sketch use Serial.print in place of the Javino library?"
    }

    test("bytes that are no text are shown as numbers, with the rate as their likely cause") {
        failure("\u00f8\u0000\u00e6\u0080x") shouldContain
            "\"\\xF8\\x00\\xE6\\x80x\", which is no text: does the board run at another rate than 9600 baud?"
    }

    test("bytes of a network that are no text are no matter of a rate") {
        StrayBytes(5, "\u00f8\u0000\u00e6\u0080x", LineSettings.NETWORK.baud()).inWords() shouldEndWith
            "which is no text: does a Javino board listen there, or another program?"
    }

    test("a message that does not end is told from text, however much of it came") {
        for (begun in listOf("f", "fff", "fffe", "fffe20dist(f,30);")) {
            failure(begun) shouldContain
                "\"$begun\", a message that is not whole or came with a pause in it: are bytes lost, or is the time for an answer too short?"
        }
    }

    test("a board of version 2 that takes a request for a command, and sends no message behind it, is asked whether its sketch answers") {
        FakeBoard.plugIn("stray").lenient().version2().use { board ->
            board.whenAsked("ping")
            Link.open(board.port(), settings.withProtocol(Protocol.V2), "the test").use { link ->
                shouldThrow<PortTimeoutException> { link.request("ping", SILENT_MS) }.message shouldBe
                    "port ${board.port()} gave no answer to \"ping\" within $SILENT_MS ms; the board has taken it as a command: " +
                    "does the sketch send a message behind it?"
            }
        }
    }

    test("a board that sends nothing at all is asked about its sketch, with the calls that are forgotten most") {
        failure("") shouldEndWith "does the board run a Javino sketch at 9600 baud, with javino.start(9600) in setup() and javino.run() " +
            "in loop()? A loop() that waits, as with delay(3000), answers too late"
    }

    test("who listens is told as well") {
        failure("ready\r\n") { link ->
            runCatching { link.request("getPercepts", SILENT_MS) }
            link.listen(SILENT_MS)
        } shouldContain "sent no message within $SILENT_MS ms; 7 bytes came"
    }

    test("a message ends the count, and the first bytes stand for many") {
        FakeBoard.plugIn("stray").lenient().use { board ->
            board.whenAsked("getPercepts").answer("a;")
            Link.open(board.port(), settings, "the test").use { link ->
                link.request("getPercepts", LIMIT_MS)
                link.strayBytes().count() shouldBe 0
                board.noise(*"x".repeat(60).toByteArray())
                while (link.strayBytes().count() < 60) link.watch(20)
                link.strayBytes() shouldBe StrayBytes(60, "x".repeat(StrayBytes.MAX_FIRST), 9600)
                link.strayBytes().inWords() shouldContain "60 bytes came since the last message and are no message: \"xxx"
                link.request("getPercepts", LIMIT_MS)
                link.strayBytes().count() shouldBe 0
            }
        }
    }
})
