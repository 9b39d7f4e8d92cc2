package samples.collision

import javino.LineClock
import javino.Transport
import javino.sim.SimulatedBoard
import samples.board.FieldBoard
import samples.cm
import kotlin.random.Random

/**
 * `sim:robot`, the robot and the wall of the collision experiment. The robot outlives its port: opened again, it stands where
 * it stood.
 */
class RobotBoard(private val robot: Robot) : SimulatedBoard {
    /** The board that a Jason project finds as a service; it logs what the robot does. */
    constructor() : this(Robot(LineClock.system(), Random.Default, ::log))

    override fun name() = NAME

    override fun run(line: Transport) = FieldBoard(robot).run(line)

    companion object {
        /** The board's name after `sim:`. */
        const val NAME = "robot"
    }
}

private fun log(course: Course, state: Course.State) = System.getLogger("samples.robot").log(
    System.Logger.Level.INFO,
    when (state) {
        Course.State.STANDING -> "stands in front of the wall"
        Course.State.DRIVING -> "drives"
        Course.State.STOPPED -> "stopped ${cm(course.distanceAt(checkNotNull(course.halt)))} cm from the wall"
        Course.State.COLLIDED -> "ran into the wall"
    },
)
