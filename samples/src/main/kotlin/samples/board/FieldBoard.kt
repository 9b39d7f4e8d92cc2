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
        unread.lookAwayUntil(line.beginToSay(answer, clock))
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
    private var burst = 0

    /** Lets bytes come until [end] by the line's clock, and then no longer, even if this takes longer. */
    fun lookAwayUntil(end: Long) {
        do {
            val left = end - clock.nanos()
            val count = read(arrived.size, (left.coerceAtLeast(0) + NANOS_PER_MILLI - 1) / NANOS_PER_MILLI)
            val late = ((clock.nanos() - end) / line.line().byteNanos()).coerceIn(0, count.toLong()).toInt()
            burst = waiting.size - late
        } while (left > 0)
    }

    /** The next bytes to read; empty if none came for a while. */
    fun take(): ByteArray {
        if (waiting.isEmpty()) read(1, READ_LIMIT_MS)
        val count = maxOf(burst, minOf(1, waiting.size))
        burst = 0
        return waiting.copyOf(count).also { waiting = waiting.copyOfRange(count, waiting.size) }
    }

    private fun read(most: Int, limitMs: Long): Int = line.read(arrived, 0, most, limitMs.toInt()).also { waiting += arrived.copyOf(it) }

    private companion object {
        const val MOST_WAITING = 4096
        const val READ_LIMIT_MS = 100L
        const val NANOS_PER_MILLI = 1_000_000L
    }
}
