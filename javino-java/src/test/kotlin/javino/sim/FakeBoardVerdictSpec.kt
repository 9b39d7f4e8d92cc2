package javino.sim

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.string.shouldContain
import javino.LineClock
import javino.LineSettings
import javino.PortGoneException
import javino.Transport
import javino.Transports
import javino.async
import javino.link.Link
import javino.link.LinkSettings
import javino.serial.Terminals
import java.util.concurrent.TimeUnit
import kotlin.time.Duration.Companion.seconds

private const val TIMES = 300
private const val LIMIT_MILLIS = 20_000
private val FAST = LineSettings(1_000_000)

private fun Transport.writeMessage(bytes: String) = write(bytes.toByteArray(), 0, bytes.length, LIMIT_MILLIS)

private fun sendOnce(board: FakeBoard) = Transports.open(board.port(), FAST).use { it.writeMessage("fffe05ledOn") }

class FakeBoardVerdictSpec : FunSpec({
    test("a board that was sent what it expects passes, every time").config(timeout = 120.seconds) {
        repeat(TIMES) { FakeBoard.plugIn("right").use { sendOnce(it.expect("ledOn")) } }
    }

    test("a board that was sent what it does not expect fails, every time").config(timeout = 120.seconds) {
        repeat(TIMES) {
            shouldThrow<AssertionError> { FakeBoard.plugIn("wrong").use(::sendOnce) }.message shouldContain "nobody expected: \"ledOn\""
        }
    }

    test("the port may still be open, and the board be asked again and again meanwhile").config(timeout = 120.seconds) {
        FakeBoard.plugIn("open").use { board ->
            val link = Link.open(board.port(), LinkSettings.defaults().withBaud(FAST.baud()), "the test")
            val asking = async { while (true) link.request("getPercepts", LIMIT_MILLIS).text() }
            repeat(TIMES / 10) {
                board.expect("ledOn")
                link.sendAndAwait("ledOn", LIMIT_MILLIS)
                board.verify()
            }
            link.close()
            asking.handle { _, _ -> }.get(LIMIT_MILLIS.toLong(), TimeUnit.MILLISECONDS)
        }
    }

    test("what was sent before the port was closed is received, though answers find nobody there") {
        repeat(TIMES) {
            FakeBoard.plugIn("closed").use { board ->
                board.whenAsked("ledOn").answer("lit;")
                Transports.open(board.expect("stop").port(), FAST).use { it.writeMessage("fffe0BgetPerceptsfffe05ledOnfffe04stop") }
            }
        }
    }

    test("a message that is still on a slow line is waited for") {
        FakeBoard.plugIn("slow").use { board ->
            Transports.open(board.expect("ledOn").port(), LineSettings(300)).use { it.writeMessage("fffe05ledOn") }
        }
    }

    test("a board that holds messages while its sketch does something else has received them in the end") {
        FakeBoard.plugIn("busy").use { board ->
            board.loopTakes(20).expect("a").expect("b").expect("c")
            Transports.open(board.port(), FAST).use { it.writeMessage("fffe01afffe01bfffe01c") }
        }
    }

    test("a board that is stalled is not waited for") {
        shouldThrow<AssertionError> {
            FakeBoard.plugIn("stalled").use { board ->
                board.stall()
                sendOnce(board.expect("ledOn"))
            }
        }.message shouldContain "did not receive: \"ledOn\""
    }

    test("an answer that takes its time does not hold up the verdict on what was received") {
        FakeBoard.plugIn("delaying").use { board ->
            board.whenAsked("ledOn").after(Int.MAX_VALUE).answer("never;")
            sendOnce(board)
        }
    }

    test("on another line the board has to be silent first").config(enabledOrReasonIf = { Terminals.available }) {
        Terminals.open().use { terminals ->
            val board = FakeBoard.unplugged("far", LineClock.system()).expect("ledOn")
            Transports.open(terminals.board, FAST).use { end ->
                val program = async { runCatching { board.program().run(end) } }
                board.awaitOpen(LIMIT_MILLIS)
                Transports.open(terminals.computer, FAST).use {
                    it.writeMessage("fffe05ledOn")
                    board.verify()
                }
                end.close()
                program.get(LIMIT_MILLIS.toLong(), TimeUnit.MILLISECONDS).exceptionOrNull() as PortGoneException
            }
        }
    }
})
