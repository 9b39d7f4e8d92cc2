package javino

import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import javino.interleavings.concurrently
import javino.interleavings.inEachInterleaving
import java.util.concurrent.ConcurrentLinkedQueue
import java.util.concurrent.locks.Condition

/** Time that passes when a thread waits for it. */
private class PassingTime : LineClock {
    @Volatile
    private var now = 0L

    override fun nanos() = now

    override fun await(condition: Condition, nanos: Long) {
        now += nanos
    }
}

/** A line that takes each frame at once. */
private class TakingLine : Transport {
    override fun name() = "taking"

    override fun line() = LineSettings(115_200)

    override fun read(b: ByteArray, off: Int, len: Int, timeoutMillis: Int): Int = error("nothing is read")

    override fun write(b: ByteArray, off: Int, len: Int, timeoutMillis: Int) = Unit

    override fun close() = Unit
}

@Tags("Thorough")
class CommandInterleavingsSpec : FunSpec({
    val settings = LinkSettings.defaults().withProtocol(Protocol.V1)

    fun command(text: String, urgent: Boolean = false) = Command(Frame.of(text), SendOptions(urgent, 0), 0)

    test("a command is either withdrawn or written") {
        inEachInterleaving {
            val writer = FrameWriter(TakingLine(), Pacer(settings, 0), PassingTime())
            val command = command("stop")
            writer.submit(command)
            var isWithdrawn = false
            var written: Command? = null
            concurrently({ isWithdrawn = writer.withdraw(command) }, { written = writer.awaitCommand(1_000_000_000) { false } })
            check(isWithdrawn == (written == null)) { "withdrawn: $isWithdrawn, written: ${written != null}" }
        }
    }

    test("one command at a time is under way, and an urgent one is not overtaken by the others") {
        inEachInterleaving {
            val writer = FrameWriter(TakingLine(), Pacer(settings, 0), PassingTime())
            writer.submit(command("on"))
            val taken = ConcurrentLinkedQueue<String>()
            val write = {
                writer.awaitCommand(1_000_000_000) { false }?.let { taken += it.frame().text() }
                Unit
            }
            concurrently({ writer.submit(command("stop", urgent = true)) }, write, write)
            check(taken.size == 1) { "under way: $taken" }
            writer.writeNow(FrameWriter.Kind.ACTION, 1000) { Frame.of("x").toBytes() }
            writer.finish()
            val next = writer.awaitCommand(10_000_000_000) { false }?.frame()?.text()
            check(setOf(taken.single(), next) == setOf("on", "stop")) { "taken: $taken, then $next" }
        }
    }

    test("a command that is submitted while the line ends is refused, or withdrawn with those that waited") {
        inEachInterleaving {
            val writer = FrameWriter(TakingLine(), Pacer(settings, 0), PassingTime())
            val command = command("stop")
            var isRefused = false
            var withdrawn = emptyList<Command>()
            val submit = {
                try {
                    writer.submit(command)
                    Unit
                } catch (_: PortGoneException) {
                    isRefused = true
                }
            }
            val end = {
                writer.end("it was closed")
                withdrawn = writer.withdrawIf { true }
            }
            concurrently(submit, end)
            check(isRefused != (command in withdrawn)) { "refused: $isRefused, withdrawn: ${withdrawn.size}" }
        }
    }

    test("a command that its own thread has written while the line ends is left to who ends the line, or fails") {
        inEachInterleaving {
            val writer = FrameWriter(TakingLine(), Pacer(settings, 0), PassingTime())
            val command = command("stop")
            writer.submit(command)
            check(writer.beginAtOnce(command)) { "the line is free" }
            var hasFailed = false
            var leaving: Command? = null
            val write = {
                try {
                    writer.leaves(writer.writeNow(FrameWriter.Kind.ACTION, 1000) { command.frame().toBytes() })
                } catch (_: PortGoneException) {
                    hasFailed = true
                }
            }
            val end = {
                writer.end("it was closed")
                leaving = writer.takeLeaving()
            }
            concurrently(write, end)
            check(hasFailed != (leaving == command)) { "failed: $hasFailed, left: ${leaving != null}" }
        }
    }
})
