package samples.board

import javino.Frame
import javino.FrameDecoder
import javino.LineClock
import javino.PerceptsRequest
import javino.Transport

/**
 * A board as they are in the field: version 1 of the Javino protocol, one message at a time.
 *
 * A command takes effect when its last byte has arrived. While the board sends an answer it does not read; of several messages
 * that have arrived meanwhile it handles the last one only. How long an answer takes is the line's business: every byte takes
 * ten bit times at the rate that the port was opened with. Percepts that do not fit into one message are sent in several.
 *
 * @param clock what bytes are timed by; the line's own
 */
class FieldBoard(private val sketch: Sketch, private val clock: LineClock = LineClock.system()) {
    /**
     * Runs the board until its [line] is gone.
     *
     * @throws javino.PortGoneException when it is
     * @throws InterruptedException when this thread is interrupted
     */
    fun run(line: Transport) {
        var message: String? = null
        val decoder = FrameDecoder(FrameDecoder.interByteTimeoutNanos(line.line())) { message = it.text() }
        val unread = Unread(line, clock)
        while (true) {
            val burst = unread.take()
            if (burst.isEmpty()) decoder.idle(clock.nanos())
            decoder.accept(burst, 0, burst.size, clock.nanos())
            message?.let { handle(it, line, unread) }
            message = null
        }
    }

    private fun handle(message: String, line: Transport, unread: Unread) {
        if (message != PerceptsRequest.ALL) return sketch.act(message)
        val answer = messages(perceptsOf(sketch.percepts())).map { Frame.of(it).toBytes() }.reduce(ByteArray::plus)
        unread.lookedAwayUntil(line.say(answer, clock))
    }
}

/**
 * What has arrived at a board and has not been read: byte by byte, but all at once what came while it looked away.
 *
 * A machine that is busy with other things wakes the board too late. What has arrived since it should have looked again is not
 * part of the burst, or commands would be lost that no real board loses.
 */
private class Unread(private val line: Transport, private val clock: LineClock) {
    private val arrived = ByteArray(MOST_WAITING)
    private var waiting = ByteArray(0)
    private var lookedAwayUntil: Long? = null

    /** The board has not looked until then, by the line's clock. */
    fun lookedAwayUntil(end: Long) {
        lookedAwayUntil = end
    }

    /** The next bytes to read; empty if none came for a while. */
    fun take(): ByteArray {
        val end = lookedAwayUntil
        if (end != null || waiting.isEmpty()) {
            val count = line.read(arrived, 0, if (end == null) 1 else arrived.size, READ_LIMIT_MS)
            waiting += arrived.copyOf(count)
        }
        val late = if (end == null) 0 else ((clock.nanos() - end) / line.line().byteNanos()).coerceIn(0, waiting.size.toLong()).toInt()
        val burst = if (end == null) minOf(1, waiting.size) else waiting.size - late
        lookedAwayUntil = null
        return waiting.copyOf(burst).also { waiting = waiting.copyOfRange(burst, waiting.size) }
    }

    private companion object {
        const val MOST_WAITING = 4096
        const val READ_LIMIT_MS = 100
    }
}
