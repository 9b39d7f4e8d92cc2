package benchmarks

import javino.LineClock
import javino.Protocol
import javino.Transport
import javino.sim.BoardLoop
import javino.sim.BoardProgram
import javino.sim.BoardSession
import javino.sim.SimulatedBoard

/**
 * A board that answers requests at once, in the version of the request, and acknowledges actions.
 *
 * @param speaks the version of the protocol that the board reads, or both versions
 * @param percepts returns the board's answer to the nth request, n counted from 1
 * @param answered called by the board's thread with n, the [System.nanoTime] at which the last byte of the answer leaves the line, and the
 *   bytes of request and answer
 * @param acted called by the board's thread with each action that does not repeat the previous one
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
        /** Returns the message of a robot with sensors on its four sides: twelve percepts, all different from the percepts of [n] - 1. */
        fun robot(n: Int): String {
            val sides = listOf("f", "b", "l", "r")
            val readings = sides.map { "dist($it,${n % 100 + 20})" } +
                sides.map { "light($it,${n % 90})" } + sides.map { "temp($it,${n % 30})" }
            return readings.joinToString(";", postfix = ";")
        }
    }
}
