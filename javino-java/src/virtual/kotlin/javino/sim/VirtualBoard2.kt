package javino.sim

import javino.BoardReceiver
import javino.Frame
import javino.PerceptKind
import javino.Protocol
import javino.Transport
import javino.virtual.EventBoard
import javino.wire.BoardAction
import javino.wire.FrameKind
import javino.wire.WireFrame

/**
 * A simulated board in virtual time. The board answers each request in the request's version. The board refuses commands that begin with
 * `bad`, and takes longer for commands that begin with `walk`.
 *
 * @param startsAt the time in ms before which arriving bytes are lost
 * @param damage damages bytes on the line, in either direction
 * @param readsVersion1 whether the board also answers version 1
 */
internal class VirtualBoard2(
    private val startsAt: Double = 0.0,
    readsVersion1: Boolean = true,
    private val actions: List<BoardAction> = emptyList(),
    private val kinds: List<PerceptKind> = emptyList(),
    private val damage: (ByteArray) -> ByteArray = { it },
) : EventBoard {
    /** The handled requests and commands in order, each with its version: `2:getPercepts`. */
    val handled = mutableListOf<String>()

    val received = mutableListOf<WireFrame>()

    /** Called with each handled request or command. By default adds it to [handled]. */
    var onHandled: (String) -> Unit = { handled += it }

    /** Called with each arriving frame. By default adds the frame to [received]. */
    var onReceived: (WireFrame) -> Unit = { received += it }

    /** Changes each frame of the board before it goes out. Can drop or double the frame. */
    var posting: (WireFrame) -> List<WireFrame> = { listOf(it) }
    var answer: (Int) -> String = { "$it;" }

    /** Milliseconds that the board takes for a message. */
    var takes = 0.0
    var walkTakes = 0.0
    var silent = false

    /** If true, the board leaves frames unread. */
    var stopped = false
    private var answers = 0
    private val outgoing = ArrayDeque<Pair<Double, ByteArray>>()
    private var now = 0.0
    private var lastByteAt = Double.NEGATIVE_INFINITY
    private var finishAt = Double.POSITIVE_INFINITY
    private var session = newSession()
    private val receiver = BoardReceiver(
        if (readsVersion1) Protocol.AUTO else Protocol.V2, TIMEOUT_NANOS, WireFrame.MAX_PAYLOAD, { session.nonce() }, ::found,
    )

    private fun newSession() = BoardSession(Program(), CAPACITY) { frame, nonce -> posting(frame).forEach { post(it.toBytes(nonce)) } }

    fun restart() {
        session = newSession()
    }

    override val dueMillis: Double
        get() = if (stopped) Double.POSITIVE_INFINITY
        else minOf(outgoing.firstOrNull()?.first ?: Double.POSITIVE_INFINITY, idleMillis(), finishAt)

    private fun idleMillis(): Double {
        val nanos = receiver.nanosUntilIdle(nanos())
        return if (nanos == Long.MAX_VALUE) Double.POSITIVE_INFINITY else now + nanos / 1e6
    }

    private fun nanos() = (now * 1e6).toLong()

    override fun look(end: Transport, now: Double) {
        if (stopped) return
        this.now = now
        val bytes = ByteArray(1024)
        val length = end.read(bytes, 0, bytes.size, 0)
        if (now < startsAt) return
        if (length > 0) accept(damage(bytes.copyOf(length))) else receiver.idle(nanos())
        if (finishAt <= now) {
            finishAt = Double.POSITIVE_INFINITY
            session.report(session.openAction(), true)
        }
        while (outgoing.isNotEmpty() && outgoing.first().first <= now) {
            val frame = damage(outgoing.removeFirst().second)
            end.write(frame, 0, frame.size, 0)
        }
    }

    private fun accept(bytes: ByteArray) {
        for (byte in bytes) {
            receiver.accept(byte, nanos(), ((now - lastByteAt) * 1e6).toLong())
            lastByteAt = now
        }
    }

    private fun found(message: BoardReceiver.Found) {
        val frame: WireFrame? = message.version2()
        if (frame != null) onReceived(frame)
        if (silent) return
        if (frame != null) session.receive(frame) else handleVersion1(message.version1().text())
    }

    fun say(text: String, version: Int = 2) {
        if (version == 1) post(Frame.of(text).toBytes()) else session.sendPercepts(text)
    }

    fun sees(percepts: String) = session.look(percepts)

    private fun handleVersion1(text: String) {
        session.end()
        onHandled("1:$text")
        if (text.startsWith("getPercepts")) post(Frame.of(answer(++answers)).toBytes())
    }

    private inner class Program : BoardProgram {
        override fun vocabulary() = actions

        override fun perceptKinds() = kinds

        override fun percepts(request: String): String {
            onHandled("2:$request")
            return answer(++answers)
        }

        override fun carryOut(command: String): BoardProgram.Outcome {
            if (command.startsWith("bad")) return BoardProgram.Outcome.REFUSED
            onHandled("2:$command")
            if (!command.startsWith("walk")) return BoardProgram.Outcome.DONE
            finishAt = now + walkTakes
            return BoardProgram.Outcome.LATER
        }
    }

    private fun post(bytes: ByteArray) {
        outgoing += maxOf(now + takes, outgoing.lastOrNull()?.first ?: 0.0) to bytes
    }

    private companion object {
        const val TIMEOUT_NANOS = 100_000_000L
        val CAPACITY = BoardSession.Capacity(60, WireFrame.MAX_PAYLOAD, 4, 16)
    }
}

internal fun VirtualBoard2.count(kind: FrameKind): Int = received.count { it.kind() == kind }
