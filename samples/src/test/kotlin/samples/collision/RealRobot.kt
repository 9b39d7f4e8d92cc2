package samples.collision

import javino.LineClock
import javino.LineSettings
import javino.PortGoneException
import javino.Transports
import javino.sim.PseudoTerminals
import samples.board.FieldBoard
import kotlin.concurrent.thread
import kotlin.random.Random

/** The robot on a pseudo-terminal. A program cannot distinguish it from a real one. */
internal class RealRobot : AutoCloseable {
    private val line = PseudoTerminals.open()
    private val clock = LineClock.system()
    private val robot = Robot(clock, Random(1))
    private val end = Transports.open("${line.board()}", LineSettings.defaults())
    private val board = thread(name = "robot") {
        try {
            FieldBoard(robot).run(end)
        } catch (_: PortGoneException) {
            // the robot was closed
        }
    }

    val port: String = "${line.computer()}"

    fun unplug() = line.close()

    fun awaitState(state: Course.State) {
        val deadline = clock.nanos() + DEADLINE_NANOS
        while (robot.course.stateAt(clock.nanos()) != state) {
            check(clock.nanos() < deadline) { "the robot is still ${robot.course.stateAt(clock.nanos())}, not $state" }
            Thread.sleep(5)
        }
    }

    override fun close() {
        end.close()
        board.join()
        line.close()
    }

    private companion object {
        const val DEADLINE_NANOS = 60_000_000_000L
    }
}
