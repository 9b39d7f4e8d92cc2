package samples.board

import javino.LineClock
import javino.PerceptsRequest
import javino.Protocol
import javino.Transport
import javino.sim.BoardLoop
import javino.sim.BoardProgram
import javino.sim.BoardProgram.Outcome
import javino.sim.BoardSession
import javino.wire.BoardAction

/**
 * A board as the library in `javino-arduino/` makes it: it speaks version 2 of the Javino protocol with computers that do, and
 * version 1 with others.
 *
 * It handles one message at a time and keeps those that arrive meanwhile. In version 2 it acknowledges commands when it has carried them
 * out, carries out once a command that is sent twice, answers `getPercepts(dist)` only with percepts of that functor, and sends an answer
 * of any length, in parts. It tells the actions of its sketch. While it sends it carries out nothing, except for the reflexes of critical
 * rules that it watches.
 *
 * @param clock the clock that times bytes; the line's own
 * @param rules the number of critical rules that it watches, 0 to 255: it then looks at the sensors every 5 ms, and between two frames that
 * it sends
 */
class LibraryBoard(private val sketch: Sketch, private val clock: LineClock = LineClock.system(), private val rules: Int = 0) {
    /**
     * Runs the board until its [line] is gone.
     *
     * @throws javino.PortGoneException when it is
     * @throws InterruptedException when this thread is interrupted
     */
    fun run(line: Transport) = Program(line).loop.run()

    private inner class Program(line: Transport) : BoardProgram {
        val loop = BoardLoop(line, this, Protocol.AUTO, BoardSession.Capacity.FULL.withRules(rules), clock)

        override fun vocabulary() = sketch.actions.map { BoardAction(it, 0) }

        override fun carryOut(command: String): Outcome {
            sketch.act(command)
            return Outcome.DONE
        }

        override fun percepts(request: String): String {
            val names = PerceptsRequest.functorsIn(request)
            val percepts = perceptsOf(sketch.percepts()).filter { names.isEmpty() || it.substringBefore('(') in names }
            val messages = if (loop.version() == 1) messages(percepts) else listOf(percepts.joinToString(""))
            messages.dropLast(1).forEach(loop::say)
            return messages.lastOrNull().orEmpty()
        }

        override fun sensors(): String = sketch.sensors()
    }
}
