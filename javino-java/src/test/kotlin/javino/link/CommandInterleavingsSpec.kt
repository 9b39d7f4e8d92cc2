package javino.link

import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import javino.Frame
import javino.LineSettings
import javino.LineTime
import javino.PortGoneException
import javino.Protocol
import javino.Transport
import javino.interleavings.concurrently
import javino.interleavings.inEachInterleaving
import java.util.concurrent.ConcurrentLinkedQueue
import java.util.concurrent.atomic.AtomicInteger

private class TakingLine : Transport {
    private val writes = AtomicInteger()
    val taken = ConcurrentLinkedQueue<String>()

    @Volatile
    var isWritable = false

    override fun name() = "taking"

    override fun line() = LineSettings(115_200)

    override fun isWritableNow(unread: Long) = isWritable

    override fun read(b: ByteArray, off: Int, len: Int, timeoutMillis: Int) = 0

    override fun write(b: ByteArray, off: Int, len: Int, timeoutMillis: Int) {
        check(writes.incrementAndGet() == 1) { "two frames are written at once" }
        taken += b.decodeToString(off + HEADER, off + len)
        writes.decrementAndGet()
    }

    override fun close() = Unit

    private companion object {
        const val HEADER = 6
    }
}

/** The commands of an unpaced line of version 1. No time passes, so each wait ends with a signal or never. */
private class CommandLine {
    private val settings = LinkSettings.defaults().withProtocol(Protocol.V1).withPaced(false).withBootMillis(0)
    private val time = LineTime()
    val transport = TakingLine()
    private val monitor = Monitor(time, transport.name())
    val writer = FrameWriter(monitor, transport, Pacer(settings, 0), time)
    val line = SharedLine(monitor, transport, time, writer, settings)
    val commands = CommandLoop(monitor, transport, writer, line, time) { }

    val taken get() = transport.taken.toList()

    fun submit(text: String, urgent: Boolean = false): Command = commands.submit(Frame.of(text), SendOptions(urgent, 0))

    fun await(isDone: () -> Boolean) = line.await(isDone, LIMIT_NANOS, false)

    private companion object {
        const val LIMIT_NANOS = 10_000_000_000
    }
}

@Tags("Thorough")
class CommandInterleavingsSpec : FunSpec({
    test("a command is either withdrawn or written") {
        inEachInterleaving {
            val session = CommandLine()
            val command = session.submit("stop")
            var isWithdrawn = false
            concurrently(
                { isWithdrawn = session.writer.withdraw(command) },
                { session.await { command.isOver || command.isWithdrawn } },
            )
            check(isWithdrawn == session.taken.isEmpty()) { "withdrawn: $isWithdrawn, written: ${session.taken}" }
        }
    }

    test("one command at a time is under way, and an urgent one is not overtaken by the others") {
        inEachInterleaving {
            val session = CommandLine()
            val ordinary = listOf("on", "off", "walk").map { session.submit(it) }
            var urgent: Command? = null
            var before = 0
            val write = {
                session.await { ordinary.all(Command::isOver) }
                Unit
            }
            concurrently({ urgent = session.submit("stop", urgent = true).also { before = session.taken.size } }, write, write)
            session.await { checkNotNull(urgent).isOver }
            check(session.taken.sorted() == listOf("off", "on", "stop", "walk")) { "written: ${session.taken}" }
            check(session.taken.filter { it != "stop" } == listOf("on", "off", "walk")) { "written: ${session.taken}" }
            check(session.taken.indexOf("stop") <= before + 1) { "behind $before: ${session.taken}" }
        }
    }

    test("two threads that send have each command written once and learn its outcome") {
        inEachInterleaving {
            val session = CommandLine()
            val send = { text: String -> session.commands.sendAndAwait(Frame.of(text), SendOptions.defaults(), 60_000) }
            concurrently({ send("on") }, { send("off") })
            check(session.taken.sorted() == listOf("off", "on")) { "written: ${session.taken}" }
        }
    }

    test("a command that is submitted while the line ends is refused, or withdrawn with those that waited") {
        inEachInterleaving {
            val writer = CommandLine().writer
            val command = Command(Frame.of("stop"), SendOptions.defaults(), 0)
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

    test("a command that its own thread writes while the line ends fails") {
        inEachInterleaving {
            val session = CommandLine()
            session.transport.isWritable = true
            var command: Command? = null
            val end = {
                session.writer.end("it was closed")
                session.commands.failAll("it was closed")
            }
            concurrently({ command = session.submit("stop") }, end)
            check(command?.outcome()?.isCompletedExceptionally == true) { "$command has no outcome; written: ${session.taken}" }
        }
    }
})
