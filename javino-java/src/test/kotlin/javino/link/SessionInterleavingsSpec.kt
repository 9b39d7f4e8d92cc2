package javino.link

import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import javino.CommandWithdrawnException
import javino.Frame
import javino.LineSettings
import javino.LineTime
import javino.PerceptsRequest
import javino.PortGoneException
import javino.Protocol
import javino.Transport
import javino.interleavings.concurrently
import javino.interleavings.inEachInterleaving
import javino.sim.BoardProgram
import javino.sim.BoardSession
import javino.wire.WireDecoder
import java.util.concurrent.ConcurrentLinkedQueue
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/** A board that carries out every command. */
private class Recorder : BoardProgram {
    val carriedOut = ConcurrentLinkedQueue<String>()

    override fun carryOut(command: String): BoardProgram.Outcome {
        carriedOut += command
        return BoardProgram.Outcome.DONE
    }

    override fun percepts(request: String) = "p;"
}

/** A line to a board that answers each frame during the write. A read waits for bytes or the end of the line, without a time limit. */
private class AnsweringLine(program: BoardProgram) : Transport {
    private val lock = ReentrantLock()
    private val changed = lock.newCondition()
    private val answers = ArrayDeque<ByteArray>()
    private val board = BoardSession(program, BoardSession.Capacity.FULL) { frame, nonce -> answers += frame.toBytes(nonce) }
    private val decoder = WireDecoder(false, Long.MAX_VALUE / 2, board::nonce, board::receive)
    private var isClosed = false

    @Volatile
    var isWritable = true

    override fun name() = "answering"

    override fun line() = LineSettings(1_000_000)

    override fun isWritableNow(unread: Long) = isWritable

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

/** A session of version 2 on an unpaced line. No time passes, so each wait ends with a signal or never. */
private class Session {
    private val settings = LinkSettings.defaults().withProtocol(Protocol.V2).withPaced(false).withBootMillis(0)
    private val time = LineTime()
    private val board = Recorder()
    private val transport = AnsweringLine(board)
    private val monitor = Monitor(time, transport.name())
    private val writer = FrameWriter(monitor, transport, Pacer(settings, 0), time)
    private val line = SharedLine(monitor, transport, time, writer, settings)
    private val commands = CommandLoop(monitor, transport, writer, line, time) { }

    val carriedOut get() = board.carriedOut.toList()

    init {
        request()
        commands.sendAndAwait(Frame.of("first"), SendOptions.defaults(), LIMIT_MS) // afterwards the session asks for the vocabulary
        board.carriedOut.clear()
    }

    fun submit(text: String): Command = commands.submit(Frame.of(text), SendOptions.defaults())

    /** A command that waits because the line takes nothing. */
    fun waiting(text: String): Command {
        transport.isWritable = false
        return submit(text).also { transport.isWritable = true }
    }

    fun send(text: String) = commands.sendAndAwait(Frame.of(text), SendOptions.defaults(), LIMIT_MS)

    fun await(command: Command) = check(line.await(command::isOver, LIMIT_NANOS, false)) { "no outcome" }

    fun withdraw(command: Command): Boolean = writer.withdraw(command).also {
        if (it) command.outcome().completeExceptionally(CommandWithdrawnException(transport.name(), "it was withdrawn"))
    }

    fun request() = RequestChannel(line, writer, time, settings).request(Frame.of(PerceptsRequest.ALL), LIMIT_MS)?.text()

    fun listen() = line.await({ false }, LIMIT_NANOS, true)

    fun end() {
        writer.end("it was closed")
        commands.failAll("it was closed")
        transport.close()
    }

    private companion object {
        const val LIMIT_MS = 60_000
        const val LIMIT_NANOS = 60_000_000_000L
    }
}

private fun untilGone(work: () -> Unit) = try {
    work()
} catch (_: PortGoneException) {
    // the line has ended
}

@Tags("Thorough")
class SessionInterleavingsSpec : FunSpec({
    test("two threads that send have each command carried out once and learn its outcome, whoever of them writes and reads") {
        inEachInterleaving(divisor = 3) {
            val session = Session()
            concurrently({ session.send("on") }, { session.send("off") })
            check(session.carriedOut.sorted() == listOf("off", "on")) { "carried out: ${session.carriedOut}" }
        }
    }

    test("a command and a request that share the line are both answered") {
        inEachInterleaving(divisor = 3) {
            val session = Session()
            var answer: String? = null
            concurrently({ session.send("on") }, { answer = session.request() })
            check(session.carriedOut == listOf("on")) { "carried out: ${session.carriedOut}" }
            check(answer == "p;") { "the answer is $answer" }
        }
    }

    test("a request that finds the line taken is written when it is free, though who took it has its outcome by then") {
        repeat(2_000) {
            val session = Session()
            var answer: String? = null
            concurrently({ session.send("on") }, { answer = session.request() })
            check(answer == "p;") { "the answer is $answer" }
        }
    }

    test("a command is either withdrawn or carried out") {
        inEachInterleaving(divisor = 3) {
            val session = Session()
            val command = session.waiting("on")
            var isWithdrawn = false
            concurrently({ session.await(command) }, { isWithdrawn = session.withdraw(command) })
            check(isWithdrawn == session.carriedOut.isEmpty()) { "withdrawn: $isWithdrawn, carried out: ${session.carriedOut}" }
            check(isWithdrawn == command.outcome().isCompletedExceptionally) { "withdrawn: $isWithdrawn, ${command.outcome()}" }
        }
    }

    test("when the line ends while a command is sent and the line is read, the command has an outcome and the reader returns") {
        inEachInterleaving(divisor = 3) {
            val session = Session()
            var command: Command? = null
            concurrently({ untilGone { session.listen() } }, { command = session.submit("on") }, { session.end() })
            check(command?.isOver == true) { "the command has no outcome" }
        }
    }
})
