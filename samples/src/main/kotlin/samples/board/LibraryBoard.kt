package samples.board

import javino.Frame
import javino.FrameDecoder
import javino.LineClock
import javino.PerceptsRequest
import javino.Protocol
import javino.Transport
import java.util.ArrayDeque

/**
 * A board as the library in `javino-arduino/` makes it: it speaks version 2 of the Javino protocol with those who speak it, and
 * version 1 with others.
 *
 * It handles one message at a time and keeps those that arrive meanwhile. In version 2 it acknowledges an action when it has carried
 * it out, carries out once an action that is sent twice, answers `getPercepts(dist)` with percepts of that functor alone, and
 * sends an answer of any length, in fragments. While it sends it does not act.
 *
 * @param clock what bytes are timed by; the line's own
 */
class LibraryBoard(private val sketch: Sketch, private val clock: LineClock = LineClock.system()) {
    private var sequence = 0
    private var acted: Frame? = null

    /**
     * Runs the board until its [line] is gone.
     *
     * @throws javino.PortGoneException when it is
     * @throws InterruptedException when this thread is interrupted
     */
    fun run(line: Transport) {
        sequence = 0
        acted = null
        val messages = ArrayDeque<Frame>()
        val decoder = FrameDecoder(FrameDecoder.interByteTimeoutNanos(line.line()), Protocol.AUTO, messages::add)
        val bytes = ByteArray(MOST_READ)
        while (true) {
            val count = line.read(bytes, 0, bytes.size, READ_LIMIT_MS)
            if (count == 0) decoder.idle(clock.nanos()) else decoder.accept(bytes, 0, count, clock.nanos())
            while (messages.isNotEmpty()) handle(messages.remove(), line)
        }
    }

    private fun handle(message: Frame, line: Transport) {
        val text = message.text()
        when {
            PerceptsRequest.isIn(text) -> line.say(answer(text, message.version()), clock)
            message.flags() and Frame.ACK_WANTED == 0 -> sketch.act(text)
            else -> {
                if (message != acted) sketch.act(text)
                acted = message
                line.say(Frame.version2(ByteArray(0), Frame.ACK, message.sequence()).toBytes(), clock)
            }
        }
    }

    private fun answer(request: String, version: Int): ByteArray {
        val names = PerceptsRequest.functorsIn(request)
        val percepts = perceptsOf(sketch.percepts()).filter { names.isEmpty() || it.substringBefore('(') in names }
        if (version == 1) return messages(percepts).map { Frame.of(it).toBytes() }.reduce(ByteArray::plus)
        val frames = Frame.fragments(percepts.joinToString("").toByteArray(Charsets.ISO_8859_1), sequence)
        sequence = (frames.last().sequence() + 1) % Frame.SEQUENCES
        return frames.map(Frame::toBytes).reduce(ByteArray::plus)
    }

    private companion object {
        const val MOST_READ = 4096
        const val READ_LIMIT_MS = 100
    }
}
