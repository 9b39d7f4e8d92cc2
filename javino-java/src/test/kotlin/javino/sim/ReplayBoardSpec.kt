package javino.sim

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempfile
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldStartWith
import javino.LineClock
import javino.NoSuchPortException
import javino.PortFaultException
import javino.PortTimeoutException
import javino.Protocol
import javino.link.Link
import javino.link.LinkSettings
import javino.sim.LineRecording.Direction.CRITICAL
import javino.sim.LineRecording.Direction.IN
import javino.sim.LineRecording.Direction.OUT
import javino.sim.LineRecording.Direction.REFLEX
import java.util.concurrent.LinkedBlockingQueue
import java.util.concurrent.TimeUnit
import java.util.concurrent.atomic.AtomicLong
import java.util.concurrent.locks.Condition

class ReplayBoardSpec : FunSpec({
    val asked =
        LineRecording(
            listOf(entry(40, OUT, "getPercepts"), entry(50, IN, "dist(9);"), entry(150, IN, "dist(8);"), entry(250, IN, "dist(7);")),
        )

    test("a request is answered with what had been said by then, counted from the first request, and with the last at the end") {
        val clock = HandClock()
        plugged(ReplayBoard.of(asked, clock)) { link ->
            fun percepts(atMillis: Long) = link.also { clock.millis.set(1_000 + atMillis) }.request("getPercepts", LIMIT_MS).text()
            listOf(0L, 99, 100, 199, 200, 100_000).map(::percepts) shouldContainExactly
                listOf("dist(9);", "dist(9);", "dist(8);", "dist(8);", "dist(7);", "dist(7);")
        }
    }

    test("what the board reported and did of its own accord is no answer") {
        val recording = LineRecording(
            listOf(
                entry(40, OUT, "getPercepts"), entry(50, IN, "dist(9);light(3);"),
                entry(60, CRITICAL, "dist(2);"),
                entry(60, REFLEX, "stop"),
            ),
        )
        val clock = HandClock()
        plugged(ReplayBoard.of(recording, clock)) { link ->
            clock.millis.set(100_000)
            List(2) { link.request("getPercepts", LIMIT_MS).text() } shouldContainExactly List(2) { "dist(9);light(3);" }
        }
    }

    test("it begins anew when it is to") {
        val clock = HandClock()
        plugged(ReplayBoard.of(asked, clock).repeated()) { link ->
            fun percepts(atMillis: Long) = link.also { clock.millis.set(1_000 + atMillis) }.request("getPercepts", LIMIT_MS).text()
            listOf(0L, 200, 299, 300, 400, 100_000_300).map(::percepts) shouldContainExactly
                listOf("dist(9);", "dist(7);", "dist(7);", "dist(9);", "dist(8);", "dist(8);")
        }
    }

    test("in turn, the time does not matter") {
        val unrepeated = LinkSettings.defaults().withProtocol(Protocol.V1) // version 2 repeats a request if its answer is late
        plugged(ReplayBoard.of(asked).inTurn(), unrepeated) { link ->
            List(4) { link.request("getPercepts", LIMIT_MS).text() } shouldContainExactly
                listOf("dist(9);", "dist(8);", "dist(7);", "dist(7);")
        }
        plugged(ReplayBoard.of(asked).inTurn().repeated(), unrepeated) { link ->
            List(4) { link.request("getPercepts", LIMIT_MS).text() } shouldContainExactly
                listOf("dist(9);", "dist(8);", "dist(7);", "dist(9);")
        }
    }

    test("what a board said unasked it says unasked") {
        val spoken = LineRecording(listOf(entry(0, IN, "dist(9);"), entry(0, IN, "dist(8);")))
        plugged(ReplayBoard.of(spoken).repeated()) { link -> link.listen(LIMIT_MS).text() shouldStartWith "dist(" }
    }

    test("whoever asks a board that spoke unasked is told to listen") {
        plugged(ReplayBoard.of(LineRecording(listOf(entry(0, IN, "dist(9);"))))) { link ->
            shouldThrow<PortTimeoutException> { link.request("getPercepts", 300) }.message shouldContain
                "the recorded board sent its percepts unasked and answers no requests: listen to it, an agent with mode(listen)"
        }
    }

    test("it speaks version 2, takes commands in it, and sends more than one frame holds") {
        val commands = LinkedBlockingQueue<String>()
        val long = (1..60).joinToString("") { "dist($it);" }
        val board = ReplayBoard.of(LineRecording(listOf(entry(0, OUT, "getPercepts"), entry(1, IN, long)))).tellingCommandsTo(commands::put)
        plugged(board, LinkSettings.defaults().withProtocol(Protocol.V2).withBaud(115_200)) { link ->
            link.request("getPercepts", LIMIT_MS).text() shouldBe long
            link.sendAndAwait("speed(3)", LIMIT_MS)
            commands.poll(LIMIT_MS.toLong(), TimeUnit.MILLISECONDS) shouldBe "speed(3)"
        }
    }

    test("in version 1 a long answer comes in several messages, each of whole percepts") {
        val long = (1..60).joinToString("") { "dist($it);" }
        plugged(ReplayBoard.of(LineRecording(listOf(entry(0, IN, long)))).inTurn(), LinkSettings.defaults().withBaud(115_200)) { link ->
            val first = link.request("getPercepts", LIMIT_MS).text()
            first shouldStartWith "dist("
            first.last() shouldBe ';'
        }
    }

    test("a file is a port") {
        val file = tempfile(suffix = ".rec")
        file.writeText("javino-recording 1\n0\tout\tgetPercepts\n5\tin\tdist(1);\n")
        Link.open("replay:$file", LinkSettings.defaults(), "the test").use {
            it.request("getPercepts", LIMIT_MS).text() shouldBe "dist(1);"
        }
        file.writeText("javino-recording 1\n0\tout\tgetPercepts\n")
        shouldThrow<PortFaultException> { Link.open("replay:$file", LinkSettings.defaults(), "the test") }.message shouldContain
            "the recording holds nothing that a board said"
        file.writeText("dist(1)")
        shouldThrow<PortFaultException> { Link.open("replay:$file", LinkSettings.defaults(), "the test") }.message shouldContain
            "$file:1: the first line"
        shouldThrow<NoSuchPortException> { Link.open("replay:missing.rec", LinkSettings.defaults(), "the test") }.message shouldContain
            "there is no recording missing.rec in "
    }
})

private const val LIMIT_MS = 20_000

private fun entry(millis: Long, direction: LineRecording.Direction, message: String) = LineRecording.Entry(millis, direction, message)

private fun plugged(board: ReplayBoard, settings: LinkSettings = LinkSettings.defaults(), use: (Link) -> Unit) {
    SimulatedBoards.plugIn("replayed", board)
    try {
        Link.open("sim:replayed", settings, "the test").use(use)
    } finally {
        SimulatedBoards.unplug("replayed")
    }
}

/** A clock that the test sets. Pauses of the board use the machine's clock. */
private class HandClock : LineClock {
    val millis = AtomicLong()

    override fun nanos() = millis.get() * 1_000_000

    override fun await(condition: Condition, nanos: Long) {
        condition.awaitNanos(nanos)
    }
}
