package javino

import io.kotest.core.spec.style.FunSpec
import javino.interleavings.concurrently
import javino.interleavings.inEachInterleaving
import javino.sim.BoardProgram
import javino.sim.BoardSession
import javino.wire.WireDecoder
import java.util.concurrent.ConcurrentLinkedQueue
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/** A board that carries everything out. */
private class Recorder : BoardProgram {
    val carriedOut = ConcurrentLinkedQueue<String>()

    override fun carryOut(command: String): BoardProgram.Outcome {
        carriedOut += command
        return BoardProgram.Outcome.DONE
    }

    override fun percepts(request: String) = "p;"
}

/** A line to a board that has answered each frame when it is written. Who reads waits for bytes or the end, and for no time. */
private class AnsweringLine(program: BoardProgram) : Transport {
    private val lock = ReentrantLock()
    private val changed = lock.newCondition()
    private val answers = ArrayDeque<ByteArray>()
    private val board = BoardSession(program, BoardSession.Capacity.FULL) { answers += it.toBytes() }
    private val decoder = WireDecoder(false, Long.MAX_VALUE / 2, board::receive)
    private var isClosed = false

    override fun name() = "answering"

    override fun line() = LineSettings(1_000_000)

    override fun isWritableNow() = true

    override fun write(b: ByteArray, off: Int, len: Int, timeoutMillis: Int) = lock.withLock {
        requireOpen()
        decoder.accept(b, off, len, 0)
        changed.signalAll()
    }

    override fun read(b: ByteArray, off: Int, len: Int, timeoutMillis: Int): Int = lock.withLock {
        while (answers.isEmpty() && timeoutMillis > 0 && !isClosed) changed.await()
        requireOpen()
        val bytes = answers.removeFirstOrNull() ?: return 0
        bytes.copyInto(b, off)
        bytes.size
    }

    private fun requireOpen() {
        if (isClosed) throw PortGoneException(name(), "it was closed")
    }

    override fun close() = lock.withLock {
        isClosed = true
        changed.signalAll()
    }
}

/** A session of version 2 that has begun, on a line without pauses; no time passes, so each wait ends with a signal or never. */
private class Session {
    private val settings = LinkSettings.defaults().withProtocol(Protocol.V2).withPaced(false).withBootMillis(0)
    private val time = LineTime()
    private val program = Recorder()
    private val transport = AnsweringLine(program)
    private val monitor = Monitor(time, transport.name())
    private val writer = FrameWriter(monitor, transport, Pacer(settings, 0), time)
    private val line = SessionLine(monitor, transport, time, writer, settings)

    val carriedOut get() = program.carriedOut.toList()

    init {
        request()
        program.carriedOut.clear()
    }

    fun command(text: String) = Command(Frame.of(text), SendOptions.defaults(), 0)

    /** Submits [command], and writes and reads until its outcome is known. */
    fun send(command: Command) {
        submit(command)
        line.await({ command.isOver || command.isWithdrawn }, LIMIT_NANOS, false)
    }

    /** As a caller who does not wait. */
    fun submit(command: Command) {
        writer.submit(command)
        line.writeAtOnce()
        writer.wake()
    }

    fun withdraw(command: Command) = writer.withdraw(command)

    fun request() = line.request("", LIMIT_NANOS)?.text()

    fun listen() = line.await({ false }, LIMIT_NANOS, true)

    /** What a link does that is closed. */
    fun end() {
        val gone = PortGoneException(transport.name(), "it was closed")
        writer.end("it was closed")
        writer.withdrawAll().forEach { it.outcome().completeExceptionally(gone) }
        line.abandon(gone)
        transport.close()
    }

    private companion object {
        const val LIMIT_NANOS = 60_000_000_000L
    }
}

private fun untilGone(work: () -> Unit) = try {
    work()
} catch (_: PortGoneException) {
    // the line has ended
}

class SessionInterleavingsSpec : FunSpec({
    test("two threads that send have each command carried out once, and learn its outcome, whoever of them reads") {
        inEachInterleaving {
            val session = Session()
            val on = session.command("on")
            val off = session.command("off")
            concurrently({ session.send(on) }, { session.send(off) })
            check(on.outcome().isDone && off.outcome().isDone) { "on: ${on.outcome()}, off: ${off.outcome()}" }
            check(session.carriedOut.sorted() == listOf("off", "on")) { "carried out: ${session.carriedOut}" }
        }
    }

    test("a command and a request that share the line are both answered") {
        inEachInterleaving {
            val session = Session()
            val on = session.command("on")
            var answer: String? = null
            concurrently({ session.send(on) }, { answer = session.request() })
            check(on.outcome().isDone && session.carriedOut == listOf("on")) { "carried out: ${session.carriedOut}, ${on.outcome()}" }
            check(answer == "p;") { "the answer is $answer" }
        }
    }

    test("a command is either withdrawn or carried out") {
        inEachInterleaving {
            val session = Session()
            val on = session.command("on")
            var isWithdrawn = false
            concurrently({ session.send(on) }, { isWithdrawn = session.withdraw(on) })
            check(isWithdrawn == session.carriedOut.isEmpty()) { "withdrawn: $isWithdrawn, carried out: ${session.carriedOut}" }
            check(isWithdrawn != on.outcome().isDone) { "withdrawn: $isWithdrawn, ${on.outcome()}" }
        }
    }

    test("a command that is sent while the line ends is refused or has an outcome, and who waits returns") {
        inEachInterleaving {
            val session = Session()
            val on = session.command("on")
            var isRefused = false
            concurrently(
                {
                    try {
                        session.submit(on)
                    } catch (_: PortGoneException) {
                        isRefused = true
                    }
                },
                { session.end() },
            )
            check(isRefused || on.outcome().isDone) { "no outcome" }
        }
    }

    test("who reads, and who waits for who reads, return when the line ends") {
        inEachInterleaving {
            val session = Session()
            concurrently({ untilGone { session.listen() } }, { untilGone { session.request() } }, { session.end() })
        }
    }
})
