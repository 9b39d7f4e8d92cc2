package javino.sim

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import javino.JumpingClock
import javino.LineSettings
import javino.PortGoneException
import javino.PortTimeoutException
import javino.Transport
import javino.Transports

private fun Transport.available(): Int = read(ByteArray(8192), 0, 8192, 0)

class MemoryLineSpec : FunSpec({
    val settings = LineSettings(10_000) // a byte a millisecond
    val millisecond = 1_000_000L

    test("a paced line carries each byte in its time, in both directions at once") {
        val clock = JumpingClock()
        val line = MemoryLine.paced("line", settings, clock)
        line.computer().write(ByteArray(10), 0, 10, 0)
        line.board().write(ByteArray(3), 0, 3, 0)
        line.board().available() shouldBe 0
        clock.advance(3 * millisecond)
        line.board().available() shouldBe 3
        line.computer().available() shouldBe 3
        clock.advance(7 * millisecond - 1)
        line.board().available() shouldBe 6
        clock.advance(1)
        line.board().available() shouldBe 1
    }

    test("a second write follows the first, and one after a pause begins at once") {
        val clock = JumpingClock()
        val line = MemoryLine.paced("line", settings, clock)
        line.computer().write(ByteArray(2), 0, 2, 0)
        line.computer().write(ByteArray(2), 0, 2, 0)
        clock.advance(3 * millisecond)
        line.board().available() shouldBe 3
        clock.advance(10 * millisecond)
        line.board().available() shouldBe 1
        line.computer().write(ByteArray(1), 0, 1, 0)
        clock.advance(millisecond)
        line.board().available() shouldBe 1
    }

    test("a read waits for the next byte and no longer") {
        val clock = JumpingClock()
        val line = MemoryLine.paced("line", settings, clock)
        line.computer().write(ByteArray(5), 0, 5, 0)
        line.board().read(ByteArray(5), 0, 5, 1_000) shouldBe 1
        clock.nanos() shouldBe millisecond
    }

    test("a line that is not paced carries bytes at once, whatever its rate is said to be") {
        val line = MemoryLine.unlimited("line", settings, JumpingClock())
        line.computer().write(ByteArray(100), 0, 100, 0)
        line.board().available() shouldBe 100
        line.board().line() shouldBe settings
    }

    test("the line holds 4096 bytes, as a driver does") {
        val line = MemoryLine.unlimited("line", settings, JumpingClock())
        shouldThrow<PortTimeoutException> { line.computer().write(ByteArray(5000), 0, 5000, 10) }.message shouldContain "4096 of 5000"
        line.board().available() shouldBe 4096
    }

    test("what was on its way when an end was closed arrives in its time, and then the line is gone") {
        val line = MemoryLine.paced("line", settings, JumpingClock())
        line.board().write(ByteArray(2), 0, 2, 0)
        line.computer().write(ByteArray(3), 0, 3, 0)
        line.computer().close()
        shouldThrow<PortGoneException> { line.computer().read(ByteArray(8), 0, 8, 1_000) }
        shouldThrow<PortGoneException> { line.board().write(ByteArray(1), 0, 1, 1_000) }
        repeat(3) { line.board().read(ByteArray(8), 0, 8, 1_000) shouldBe 1 }
        shouldThrow<PortGoneException> { line.board().read(ByteArray(8), 0, 8, 1_000) }.message shouldContain "closed"
    }

    test("what was on its way when the plug was pulled is lost") {
        val line = MemoryLine.unlimited("line", settings, JumpingClock())
        line.computer().write(ByteArray(3), 0, 3, 0)
        line.unplug()
        shouldThrow<PortGoneException> { line.board().read(ByteArray(8), 0, 8, 1_000) }.message shouldContain "unplugged"
    }

    test("a board whose program ended is told of as the reason") {
        SimulatedBoards.plugIn("ending") { }
        try {
            val computer = Transports.open("sim:ending", settings)
            shouldThrow<PortGoneException> { computer.read(ByteArray(1), 0, 1, 20_000) }.message shouldContain "program ended"
        } finally {
            SimulatedBoards.unplug("ending")
        }
    }
})
