package javino

import javino.session.BoardModel
import javino.wire.BoardAction
import javino.wire.FrameKind
import javino.wire.WireDecoder
import javino.wire.WireFrame

/**
 * A board of version 2, in virtual time: it answers each request in the version it was asked in, carries out commands but those that begin
 * with `bad`, and takes longer over those that begin with `walk`.
 *
 * @param startsAt the time in ms until which what comes is lost
 * @param damage what the line makes of bytes, in either direction
 * @param readsVersion1 whether it answers version 1 too
 */
internal class VirtualBoard2(
    private val startsAt: Double = 0.0,
    private val readsVersion1: Boolean = true,
    actions: List<BoardAction> = emptyList(),
    private val damage: (ByteArray) -> ByteArray = { it },
) : EventBoard {
    /** Requests and commands in the order in which they were handled, as `2:getPercepts`. */
    val handled = mutableListOf<String>()

    /** All frames of version 2 that came. */
    val received = mutableListOf<WireFrame>()

    /** Is called with what is handled, as it is in [handled]; keeps it there unless something else is wanted. */
    var onHandled: (String) -> Unit = { handled += it }

    /** Is called with each frame that comes; keeps it in [received] unless something else is wanted. */
    var onReceived: (WireFrame) -> Unit = { received += it }

    /** What the board does with its frames before they go on the line: leaves them out, doubles them. */
    var posting: (WireFrame) -> List<WireFrame> = { listOf(it) }
    var answer: (Int) -> String = { "$it;" }

    /** ms that the board takes for a message, and for a command that begins with `walk`. */
    var takes = 0.0
    var walkTakes = 0.0
    var silent = false

    /** Whether it carries commands and requests out, or leaves frames unread. */
    var stopped = false
    private var answers = 0
    private val outgoing = ArrayDeque<Pair<Double, ByteArray>>()
    private var now = 0.0
    private var lastByteAt = Double.NEGATIVE_INFINITY
    private var finishAt = Double.POSITIVE_INFINITY
    val model = BoardModel(actions, percepts = ::percepts, act = ::act)
    private val version2 = WireDecoder(false, TIMEOUT_NANOS) { frame ->
        onReceived(frame)
        if (!silent) postAll(model.received(frame))
    }
    private val version1 = FrameDecoder(TIMEOUT_NANOS) { handleVersion1(it.text()) }

    override val dueMillis: Double
        get() = if (stopped) Double.POSITIVE_INFINITY
        else minOf(outgoing.firstOrNull()?.first ?: Double.POSITIVE_INFINITY, idleMillis(), finishAt)

    private fun idleMillis(): Double {
        val nanos = minOf(version1.nanosUntilIdle(nanos()), version2.nanosUntilIdle(nanos()))
        return if (nanos == Long.MAX_VALUE) Double.POSITIVE_INFINITY else now + nanos / 1e6
    }

    private fun nanos() = (now * 1e6).toLong()

    override fun look(end: Transport, now: Double) {
        if (stopped) return
        this.now = now
        val bytes = ByteArray(1024)
        val length = end.read(bytes, 0, bytes.size, 0)
        if (now < startsAt) return
        if (length > 0) accept(damage(bytes.copyOf(length))) else idle()
        if (finishAt <= now) {
            finishAt = Double.POSITIVE_INFINITY
            postAll(listOf(model.finish()))
        }
        while (outgoing.isNotEmpty() && outgoing.first().first <= now) {
            val frame = damage(outgoing.removeFirst().second)
            end.write(frame, 0, frame.size, 0)
        }
    }

    private fun idle() {
        version1.idle(nanos())
        version2.idle(nanos())
    }

    private fun accept(bytes: ByteArray) {
        val countsVersion1 = readsVersion1 && (model.nonce == 0 || now - lastByteAt >= QUIET_MILLIS)
        lastByteAt = now
        for (byte in bytes) {
            if (!version1.isInPayload && version2.accept(byte, nanos())) continue
            if (countsVersion1) version1.accept(byte, nanos())
        }
    }

    /** Sends percepts that nobody asked for. */
    fun say(text: String, version: Int = 2) {
        if (version == 1) post(Frame.of(text).toBytes()) else postAll(model.say(text))
    }

    private fun handleVersion1(text: String) {
        if (silent) return
        onHandled("1:$text")
        if (text.startsWith("getPercepts")) post(Frame.of(answer(++answers)).toBytes())
    }

    private fun percepts(functors: String): String {
        onHandled("2:getPercepts$functors")
        return answer(++answers)
    }

    private fun act(text: String): Boolean? {
        if (text.startsWith("bad")) return false
        onHandled("2:$text")
        if (!text.startsWith("walk")) return true
        finishAt = now + walkTakes
        return null
    }

    private fun postAll(frames: List<WireFrame>) = frames.flatMap(posting).forEach { post(it.toBytes()) }

    private fun post(bytes: ByteArray) {
        outgoing += maxOf(now + takes, outgoing.lastOrNull()?.first ?: 0.0) to bytes
    }

    private companion object {
        const val TIMEOUT_NANOS = 100_000_000L
        const val QUIET_MILLIS = 25.0
    }
}

/** The numbers of the frames of [kind]. */
internal fun VirtualBoard2.count(kind: FrameKind): Int = received.count { it.kind() == kind }
