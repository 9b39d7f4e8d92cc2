package benchmarks

import javino.LineClock
import javino.Protocol
import javino.Transport
import javino.sim.BoardLoop
import javino.sim.BoardProgram
import javino.sim.BoardSession
import javino.sim.SimulatedBoard

/**
 * A board that answers each request at once, in the protocol version of the request. The board acknowledges actions.
 *
 * @param speaks the protocol version of the board, or both versions
 * @param percepts returns the answer to the nth request, counted from 1
 * @param answered called by the board's thread after the nth answer. Gets n, the [System.nanoTime] at which the answer's last byte leaves
 * the line, and the number of bytes of request and answer
 * @param acted called by the board's thread with each action, except repetitions of a command
 */
class SensorBoard(
    private val speaks: Protocol,
    private val percepts: (Int) -> String,
    private val answered: (n: Int, endNanos: Long, bytes: Int) -> Unit = { _, _, _ -> },
    private val acted: (action: String) -> Unit = {},
) : SimulatedBoard {
    override fun run(line: Transport) = BoardLoop(line, Program(), speaks, BoardSession.Capacity.FULL, LineClock.system()).run()

    private inner class Program : BoardProgram {
        private var answers = 0

        override fun percepts(request: String) = percepts(++answers)

        override fun answered(requestBytes: Int, answerBytes: Int, endNanos: Long) =
            answered(answers, endNanos, requestBytes + answerBytes)

        override fun carryOut(command: String): BoardProgram.Outcome {
            acted(command)
            return BoardProgram.Outcome.DONE
        }
    }

    companion object {
        /** Returns message [n] of a robot with sensors on four sides. All its twelve percepts differ from those of message [n] - 1. */
        fun robot(n: Int): String {
            val sides = listOf("f", "b", "l", "r")
            val readings = sides.map { "dist($it,${n % 100 + 20})" } +
                sides.map { "light($it,${n % 90})" } + sides.map { "temp($it,${n % 30})" }
            return readings.joinToString(";", postfix = ";")
        }
    }
}
