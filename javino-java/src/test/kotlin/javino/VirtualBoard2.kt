package javino

/**
 * A board of version 2, in virtual time: it answers each request in the version it was asked in, carries an action out once however often
 * it comes, acknowledges it, and refuses those that begin with `bad`.
 *
 * @param startsAt the time in ms until which what comes is lost
 * @param damage what the line makes of bytes, in either direction
 * @param readsVersion1 whether it answers version 1 too
 */
internal class VirtualBoard2(
    private val startsAt: Double = 0.0,
    private val readsVersion1: Boolean = true,
    private val damage: (ByteArray) -> ByteArray = { it },
) : EventBoard {
    /** Requests and actions in the order in which they were handled, as `2:getPercepts`; repeated actions are not among them. */
    val handled = mutableListOf<String>()

    /** All frames that came. */
    val received = mutableListOf<Frame>()

    /** Told what is handled, as it is in [handled]; keeps it there unless something else is wanted. */
    var onHandled: (String) -> Unit = { handled += it }

    /** Told each frame that comes; keeps it in [received] unless something else is wanted. */
    var onReceived: (Frame) -> Unit = { received += it }

    /** What the board does with its frames before they go on the line: leaves them out, doubles them. */
    var posting: (Frame) -> List<Frame> = { listOf(it) }
    var answer: (Int) -> String = { "$it;" }

    /** ms that the board takes for a message. */
    var takes = 0.0
    var silent = false

    private var sequence = 0
    private var answers = 0
    private var last: Frame? = null
    private var lastAt = 0.0
    private var lastFlags = 0
    private val outgoing = ArrayDeque<Pair<Double, Frame>>()
    private var now = 0.0
    private val decoder = FrameDecoder(100_000_000, if (readsVersion1) Protocol.AUTO else Protocol.V2) { onReceived(it); handle(it) }

    override val dueMillis: Double
        get() = minOf(outgoing.firstOrNull()?.first ?: Double.POSITIVE_INFINITY, idleMillis())

    private fun idleMillis(): Double {
        val nanos = decoder.nanosUntilIdle((now * 1e6).toLong())
        return if (nanos == Long.MAX_VALUE) Double.POSITIVE_INFINITY else now + nanos / 1e6
    }

    override fun look(end: Transport, now: Double) {
        this.now = now
        val bytes = ByteArray(1024)
        val length = end.read(bytes, 0, bytes.size, 0)
        if (now < startsAt) return
        val nanos = (now * 1e6).toLong()
        if (length > 0) damage(bytes.copyOf(length)).let { decoder.accept(it, 0, it.size, nanos) } else decoder.idle(nanos)
        while (outgoing.isNotEmpty() && outgoing.first().first <= now) {
            val frame = damage(outgoing.removeFirst().second.toBytes())
            end.write(frame, 0, frame.size, 0)
        }
    }

    /** Sends a message that nobody asked for. */
    fun say(text: String, version: Int = 2) = post(if (version == 1) listOf(Frame.of(text)) else message(text))

    private fun handle(frame: Frame) {
        if (silent) return
        val text = frame.text()
        if (text.startsWith("getPercepts")) {
            onHandled("${frame.version()}:$text")
            val percepts = answer(++answers)
            post(if (frame.version() == 1) listOf(Frame.of(percepts)) else message(percepts))
        } else if (frame.version() == 1) {
            // no action: what is left of a version 2 frame with a damaged preamble
            if (!text.take(1).all(Char::isDigit)) onHandled("1:$text")
        } else {
            if (!(frame == last && now - lastAt < 3_000)) act(frame)
            if (frame.flags() and Frame.ACK_WANTED != 0) post(listOf(Frame.version2(ByteArray(0), lastFlags, frame.sequence())))
        }
    }

    private fun act(frame: Frame) {
        last = frame
        lastAt = now + takes
        lastFlags = if (frame.text().startsWith("bad")) Frame.REFUSAL else Frame.ACK
        if (lastFlags == Frame.ACK) onHandled("2:${frame.text()}")
    }

    private fun message(text: String): List<Frame> = Frame.fragments(text.toByteArray(Charsets.ISO_8859_1), sequence)
        .also { sequence = (sequence + it.size) % 16 }

    private fun post(frames: List<Frame>) = frames.flatMap(posting).forEach {
        outgoing += maxOf(now + takes, outgoing.lastOrNull()?.first ?: 0.0) to it
    }
}
