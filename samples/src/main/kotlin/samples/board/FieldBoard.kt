package samples.board

import javino.Frame
import javino.FrameDecoder
import javino.LineClock
import javino.Transport
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/**
 * A board as they are in the field: version 1 of the Javino protocol, one message at a time.
 *
 * A command takes effect when its last byte has arrived. While the board sends an answer it does not read; of several messages
 * that have arrived meanwhile it handles the last one only. How long an answer takes is the line's business: every byte takes
 * ten bit times at the rate that the port was opened with.
 *
 * @param clock what bytes are timed by; the line's own
 */
class FieldBoard(private val sketch: Sketch, private val clock: LineClock = LineClock.system()) {
    private val lock = ReentrantLock()
    private val never = lock.newCondition()

    /**
     * Runs the board until its [line] is gone.
     *
     * @throws javino.PortGoneException when it is
     * @throws InterruptedException when this thread is interrupted
     */
    fun run(line: Transport) {
        var message: String? = null
        val decoder = FrameDecoder(FrameDecoder.interByteTimeoutNanos(line.line())) { message = it.text() }
        val arrived = ByteArray(MOST_WAITING)
        var hasLookedAway = false
        while (true) {
            val count = line.read(arrived, 0, if (hasLookedAway) arrived.size else 1, READ_LIMIT_MS)
            if (count == 0) decoder.idle(clock.nanos()) else decoder.accept(arrived, 0, count, clock.nanos())
            hasLookedAway = message?.let { handle(it, line) } ?: false
            message = null
        }
    }

    /** Does what [message] asks for; returns whether that took time in which the board did not read. */
    private fun handle(message: String, line: Transport): Boolean {
        if (message != REQUEST) {
            sketch.act(message)
            return false
        }
        val answer = Frame.of(sketch.percepts()).toBytes()
        line.write(answer, 0, answer.size, WRITE_LIMIT_MS)
        pause(answer.size * line.line().byteNanos())
        return true
    }

    private fun pause(nanos: Long) = lock.withLock {
        val end = clock.nanos() + nanos
        while (end - clock.nanos() > 0) clock.await(never, end - clock.nanos())
    }

    private companion object {
        const val REQUEST = "getPercepts"
        const val MOST_WAITING = 4096
        const val READ_LIMIT_MS = 100
        const val WRITE_LIMIT_MS = 10_000
    }
}
