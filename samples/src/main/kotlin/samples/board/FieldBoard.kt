package samples.board

import javino.Frame
import javino.FrameDecoder
import javino.LineClock
import javino.PerceptsRequest
import javino.Transport
import javino.sim.Sketch
import java.util.concurrent.TimeUnit
import kotlin.math.ceil
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.nanoseconds

/**
 * Simulates a board with the old Javino library: version 1 of the protocol, one message at a time.
 *
 * In each `loop()`, the board reads all bytes that have arrived. The board has room for only one message. Up to four bytes of the next
 * frame may have arrived, too. These bytes empty the message, the sketch calls a null pointer, and the board restarts. With more bytes of
 * the next frame, the board only loses the message.
 *
 * The board does not read while it sends an answer. Every byte of the answer takes ten bit times. If the percepts do not fit into one
 * message, the board sends several.
 *
 * @param clock the clock of the line
 * @param loopMs the duration of `loop()` in ms. 0 means that the board reads every byte when it arrives
 * @param startMs the duration of a restart in ms
 */
class FieldBoard(
    private val sketch: Sketch,
    private val clock: LineClock = LineClock.system(),
    private val loopMs: Int = 0,
    private val startMs: Int = 100,
) {
    private var message: String? = null
    private var bytesBehind = 0 // bytes read after the message

    /** The number of restarts because frames followed each other too closely. */
    @Volatile
    var restarts = 0
        private set

    /**
     * Runs the board on [line] until an exception.
     *
     * @throws javino.PortGoneException if the line is lost
     * @throws InterruptedException if this thread is interrupted
     */
    fun run(line: Transport) {
        message = null
        val decoder = FrameDecoder(FrameDecoder.interByteTimeoutNanos(line.line())) {
            message = it.text()
            bytesBehind = 0
        }
        val unread = Unread(line, clock)
        while (true) {
            val burst = unread.take(TimeUnit.MILLISECONDS.toNanos(loopMs.toLong()))
            if (burst.isEmpty()) decoder.idle(clock.nanos())
            for (byte in burst) {
                bytesBehind++
                decoder.accept(byte, clock.nanos())
            }
            val complete = message ?: continue
            message = null
            when (bytesBehind) {
                0 -> handle(complete, line, unread)
                in 1..CLEARING -> restart(unread, decoder)
            }
        }
    }

    private fun handle(message: String, line: Transport, unread: Unread) {
        if (message != PerceptsRequest.ALL) {
            sketch.act(message)
            return
        }
        val answer = messages(sketch.percepts()).map { Frame.of(it).toBytes() }.reduce(ByteArray::plus)
        line.write(answer, 0, answer.size, WRITE_LIMIT_MS)
        unread.lookAwayUntil(clock.nanos() + answer.size * line.line().byteNanos())
    }

    private fun restart(unread: Unread, decoder: FrameDecoder) {
        restarts++
        unread.lookAwayUntil(clock.nanos() + TimeUnit.MILLISECONDS.toNanos(startMs.toLong()))
        unread.forget()
        decoder.reset()
    }

    /** Puts [percepts] into as few messages as possible, but at least one. Does not split a percept. */
    private fun messages(percepts: List<String>) = percepts.fold(listOf("")) { messages, percept ->
        if (messages.last().length + percept.length >= Frame.MAX_PAYLOAD) messages + "$percept;"
        else messages.dropLast(1) + "${messages.last()}$percept;"
    }

    private companion object {
        /** With 1 to this many bytes of the next frame behind a message, the board restarts. With more, it loses the message. */
        const val CLEARING = 4
        const val WRITE_LIMIT_MS = 30_000
    }
}

/**
 * The unread bytes of a board. The board reads bytes one by one. Bytes that arrived while it was busy form one burst.
 *
 * A busy computer may wake the simulated board too late. Bytes that arrive after the right time do not belong to the burst. A real board
 * would not lose their commands.
 */
private class Unread(private val line: Transport, private val clock: LineClock) {
    private val arrived = ByteArray(MAX_WAITING)
    private var waiting = ByteArray(0)
    private var burst = 0

    /** Waits until [end] by the line's clock. Only bytes that arrived by then form the burst, even if this function returns later. */
    fun lookAwayUntil(end: Long) {
        do {
            val left = end - clock.nanos()
            val leftMs = ceil(left.coerceAtLeast(0).nanoseconds / 1.milliseconds).toLong()
            val count = read(arrived.size, leftMs)
            val late = ((clock.nanos() - end) / line.line().byteNanos()).coerceIn(0, count.toLong()).toInt()
            burst = waiting.size - late
        } while (left > 0)
    }

    /** Returns the next bytes to read after a `loop()` of [loopNanos]. The array is empty if no bytes arrived for a while. */
    fun take(loopNanos: Long): ByteArray {
        if (loopNanos > 0 && burst == 0) lookAwayUntil(clock.nanos() + loopNanos) else if (waiting.isEmpty()) read(1, READ_LIMIT_MS)
        val count = if (loopNanos > 0) burst else maxOf(burst, minOf(1, waiting.size))
        burst = 0
        return waiting.copyOf(count).also { waiting = waiting.copyOfRange(count, waiting.size) }
    }

    fun forget() {
        waiting = ByteArray(0)
        burst = 0
    }

    private fun read(most: Int, limitMs: Long): Int = line.read(arrived, 0, most, limitMs.toInt()).also { waiting += arrived.copyOf(it) }

    private companion object {
        const val MAX_WAITING = 4096
        const val READ_LIMIT_MS = 100L
    }
}
