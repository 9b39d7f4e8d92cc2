package samples.board

import javino.Frame
import javino.LineClock
import javino.PerceptsRequest
import javino.Protocol
import javino.Transport
import javino.sim.BoardLoop

/**
 * A board as the library in `javino-arduino/` makes it: it speaks version 2 of the Javino protocol with computers that do, and
 * version 1 with others.
 *
 * It handles one message at a time and keeps those that arrive meanwhile. In version 2 it acknowledges an action when it has carried
 * it out, carries out once an action that is sent twice, answers `getPercepts(dist)` with percepts of that functor alone, and
 * sends an answer of any length, in fragments. While it sends it does not act.
 *
 * @param clock what bytes are timed by; the line's own
 */
class LibraryBoard(private val sketch: Sketch, private val clock: LineClock = LineClock.system()) {
    /**
     * Runs the board until its [line] is gone.
     *
     * @throws javino.PortGoneException when it is
     * @throws InterruptedException when this thread is interrupted
     */
    fun run(line: Transport) {
        val loop = BoardLoop(line, Protocol.AUTO, clock)
        while (true) handle(loop.next(READ_LIMIT_MS) ?: continue, loop)
    }

    private fun handle(message: Frame, loop: BoardLoop) {
        val text = message.text()
        if (PerceptsRequest.isIn(text)) answer(text, loop.version()).forEach(loop::say) else sketch.act(text)
        loop.acknowledge(message)
    }

    private fun answer(request: String, version: Int): List<String> {
        val names = PerceptsRequest.functorsIn(request)
        val percepts = perceptsOf(sketch.percepts()).filter { names.isEmpty() || it.substringBefore('(') in names }
        return if (version == 1) messages(percepts) else listOf(percepts.joinToString(""))
    }
}

private const val READ_LIMIT_MS = 100
