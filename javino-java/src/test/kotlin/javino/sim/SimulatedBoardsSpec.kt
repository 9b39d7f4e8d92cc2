package javino.sim

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldNotContain
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import javino.LineSettings
import javino.NoSuchPortException
import javino.PortBusyException
import javino.PortGoneException
import javino.Transports
import java.util.concurrent.CountDownLatch
import java.util.concurrent.TimeUnit
import java.util.concurrent.atomic.AtomicInteger

private fun <T> plugged(name: String, board: SimulatedBoard, work: () -> T): T {
    SimulatedBoards.plugIn(name, board)
    try {
        return work()
    } finally {
        SimulatedBoards.unplug(name)
    }
}

private val idle = SimulatedBoard { line -> while (true) line.read(ByteArray(1), 0, 1, 60_000) }

class SimulatedBoardsSpec : FunSpec({
    val line = LineSettings(57_600)

    test("an unknown board is refused with those there are") {
        plugged("mower", idle) {
            val refusal = shouldThrow<NoSuchPortException> { Transports.open("sim:robot", line) }
            refusal.message shouldContain "sim:robot"
            refusal.message shouldContain "sim:mower"
        }
    }

    test("a board has the rate that its port was opened with") {
        val rates = mutableListOf<Int>()
        val ran = CountDownLatch(1)
        plugged("rate", { rates += it.line().baud(); ran.countDown() }) {
            Transports.open("sim:rate", line).use { ran.await(20, TimeUnit.SECONDS) }
            rates shouldBe listOf(57_600)
        }
    }

    test("closing the port ends the board's run, and opening it begins another, one at a time") {
        val running = AtomicInteger()
        val most = AtomicInteger()
        val board = SimulatedBoard { end ->
            most.accumulateAndGet(running.incrementAndGet(), ::maxOf)
            try {
                idle.run(end)
            } finally {
                running.decrementAndGet()
            }
        }
        plugged("again", board) {
            repeat(20) { Transports.open("sim:again", line).close() }
        }
        most.get() shouldBe 1
    }

    test("a board that is open is busy") {
        plugged("busy", idle) {
            Transports.open("sim:busy", line).use {
                shouldThrow<PortBusyException> { Transports.open("sim:busy", line) }
            }
        }
    }

    test("a board that is unplugged is gone, and can be plugged in again") {
        SimulatedBoards.plugIn("mower", idle)
        val computer = Transports.open("sim:mower", line)
        SimulatedBoards.names() shouldContain "mower"
        SimulatedBoards.unplug("mower") shouldBe true
        shouldThrow<PortGoneException> { computer.read(ByteArray(1), 0, 1, 60_000) }.message shouldContain "unplugged"
        SimulatedBoards.names() shouldNotContain "mower"
        SimulatedBoards.unplug("mower") shouldBe false
        plugged("mower", idle) { Transports.open("sim:mower", line).close() }
    }

    test("a name can be taken once, and must be one") {
        plugged("mower", idle) {
            shouldThrow<IllegalStateException> { SimulatedBoards.plugIn("mower", idle) }.message shouldContain "sim:mower"
        }
        shouldThrow<IllegalArgumentException> { SimulatedBoards.plugIn(" ", idle) }
    }

    test("a board whose program fails is gone, with the failure as the reason") {
        plugged("broken", { error("no such wheel") }) {
            val computer = Transports.open("sim:broken", line)
            shouldThrow<PortGoneException> { computer.read(ByteArray(1), 0, 1, 60_000) }.message shouldContain "no such wheel"
        }
    }

    test("a board that is unplugged while it is opened does not run") {
        val socket = PluggedBoard("sim:late") { error("runs") }
        socket.unplug() // another thread has found the socket and opens it after this
        shouldThrow<NoSuchPortException> { socket.open(LineSettings.defaults()) }.port() shouldBe "sim:late"
        socket.isRunning shouldBe false
    }
})
