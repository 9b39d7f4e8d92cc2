package javino.virtual

import javino.Transport
import javino.sim.BoardProgram
import javino.sim.BoardSession
import javino.wire.BoardAction
import javino.wire.FrameKind
import javino.wire.WireDecoder
import javino.wire.WireFrame
import kotlin.random.Random

/**
 * The longest times of a board, in ns.
 *
 * @property loop time of one run of the sketch's `loop()`, without the times below
 * @property action time of an action
 * @property sensors time to read the sensors for an answer and to code the answer
 * @property ruleSensors time to read the sensors of the rules and to compare their percepts with the rules
 * @property isSteady true: each time is the longest; false: each time is drawn, up to the longest
 */
internal data class BoardTimes(val loop: Long, val action: Long, val sensors: Long, val ruleSensors: Long, val isSteady: Boolean)

/** The percepts of a [LoopBoard], and its commands. */
internal interface TimedSketch {
    /** Returns the percepts at [nanos], each followed by `;`. */
    fun percepts(nanos: Long): String

    fun carriedOut(command: String, fromNanos: Long, toNanos: Long)
}

/**
 * A board of version 2 whose sketch calls the library once in each run of its `loop()`. A call handles up to eight messages. A call reads
 * the sensors of rules at most every 5 ms. Parts of an answer go out when the line is free. A write waits for room in the port's buffer.
 */
internal class LoopBoard(
    private val times: BoardTimes, private val byteNanos: Long, private val random: Random, private val sketch: TimedSketch,
    private val actions: List<BoardAction>,
) : EventBoard, BoardProgram {
    private val session = BoardSession(this, BoardSession.Capacity(CREDIT, WireFrame.MAX_PAYLOAD, RULES, SHAPES), ::send)
    private val decoder = WireDecoder(false, TIMEOUT_NANOS, ::nonce) { arrived += it }
    private val arrived = ArrayDeque<WireFrame>()
    private val parts = ArrayDeque<ByteArray>()
    private val outgoing = ArrayDeque<Pair<Long, ByteArray>>()
    private val buffer = ByteArray(1024)
    private var now = 0L // the program's time, ahead of the line's time while the program works
    private var spent = 0L // time spent by the program since `now`
    private var lineFreeAt = 0L
    private var lookedAt = -LOOK_NANOS
    private var messages = 0 // messages handled in this call
    private var isCalled = false // whether a call is in progress

    private val isRunning get() = arrived.isNotEmpty() || parts.isNotEmpty() || isCalled || session.hasRules()

    override val dueMillis: Double
        get() = minOf(if (isRunning) now else Long.MAX_VALUE, outgoing.firstOrNull()?.first ?: Long.MAX_VALUE)
            .let { if (it == Long.MAX_VALUE) Double.POSITIVE_INFINITY else it / NANOS_PER_MS }

    override fun look(end: Transport, now: Double) {
        val time = Math.round(now * NANOS_PER_MS)
        val wasRunning = isRunning
        decoder.accept(buffer, 0, end.read(buffer, 0, buffer.size, 0), time)
        if (!wasRunning) while (this.now < time) this.now += round() // loops without work
        while (isRunning && this.now <= time) step()
        while (outgoing.isNotEmpty() && outgoing.first().first <= time) {
            val frame = outgoing.removeFirst().second
            end.write(frame, 0, frame.size, 0)
        }
    }

    private fun round() = maxOf(1, draw(times.loop))

    /** Draws a time. Often returns the longest, because the longest times test the bounds. */
    private fun draw(longest: Long) = if (times.isSteady || random.nextInt(4) == 0) longest else random.nextLong(longest + 1)

    /** Does one thing: reads the sensors of the rules, handles a message, or ends the call. */
    private fun step() {
        spent = 0
        if (session.hasRules() && now - lookedAt >= LOOK_NANOS) {
            lookedAt = now
            val percepts = sketch.percepts(now)
            spent += draw(times.ruleSensors)
            session.look(percepts)
            isCalled = true
            now += spent // then the program takes bytes that have arrived meanwhile
            return
        }
        if (parts.isNotEmpty() && lineFreeAt <= now + spent) post(parts.removeFirst())
        val frame = if (messages < MESSAGES_PER_CALL) arrived.removeFirstOrNull() else null
        if (frame == null) {
            messages = 0
            isCalled = false
            spent += round()
        } else {
            messages++
            isCalled = true
            if (frame.kind() == FrameKind.ASK) while (parts.isNotEmpty()) post(parts.removeFirst())
            session.receive(frame)
        }
        now += spent
        spent = 0
    }

    /** Returns the nonce for new bytes: that of the last unhandled HELLO, or else that of the session. */
    private fun nonce() = arrived.lastOrNull { it.kind() == FrameKind.HELLO }?.number() ?: session.nonce()

    private fun send(frame: WireFrame, nonce: Int) {
        val isPart = frame.kind() == FrameKind.PERCEPTS_PART || frame.kind() == FrameKind.PERCEPTS_LAST
        val bytes = frame.toBytes(nonce)
        if (isPart && session.hasRules()) parts += bytes else post(bytes)
    }

    private fun post(bytes: ByteArray) {
        outgoing += now + spent to bytes
        lineFreeAt = maxOf(lineFreeAt, now + spent) + bytes.size * byteNanos
        spent = maxOf(spent, lineFreeAt - BUFFER * byteNanos - now)
    }

    override fun vocabulary() = actions

    override fun carryOut(command: String): BoardProgram.Outcome {
        val from = now + spent
        spent += draw(times.action)
        sketch.carriedOut(command, from, now + spent)
        return BoardProgram.Outcome.DONE
    }

    override fun percepts(request: String): String {
        val percepts = sketch.percepts(now + spent)
        spent += draw(times.sensors)
        return percepts
    }

    companion object {
        /** The most bytes of unacknowledged frames from the computer. */
        const val CREDIT = 60

        /** Number of bytes that the port takes before a write waits. */
        const val BUFFER = 64

        /** The least time between two readings of the sensors of rules. */
        const val LOOK_NANOS = 5_000_000L

        private const val NANOS_PER_MS = 1e6
        private const val MESSAGES_PER_CALL = 8
        private const val RULES = 4
        private const val SHAPES = 126
        private const val TIMEOUT_NANOS = 100_000_000L
    }
}
