package samples.collision

import javino.LineClock
import javino.Transport
import javino.sim.SimulatedBoard
import javino.sim.Sketch
import samples.board.FieldBoard
import kotlin.random.Random

/** `sim:robot`, the robot and the wall of the collision experiment. Opening its port again does not move the robot. */
class RobotBoard internal constructor(private val name: String, private val sketch: Sketch) : SimulatedBoard {
    /** Makes the board for a Jason project. ServiceLoader calls this constructor. The board logs the robot's actions. */
    constructor() : this(NAME, Robot(LineClock.system(), Random.Default, ::log))

    override fun name() = name

    override fun run(line: Transport) = FieldBoard(sketch).run(line)

    internal companion object {
        const val NAME = "robot"

        /** The name of the board for the sensors of a robot with two boards. */
        const val SENSORS = "robot-sensors"

        /** Returns the [boards] boards of [robot]: one, or one with wheels and lamps and one with the sensors. */
        fun of(robot: Robot, boards: Int): List<RobotBoard> =
            if (boards == 1) listOf(RobotBoard(NAME, robot))
            else listOf(RobotBoard(NAME, Motion(robot)), RobotBoard(SENSORS, Senses(robot)))
    }
}

private class Motion(private val robot: Robot) : Sketch {
    override fun actions() = robot.actions()

    override fun percepts() = emptyList<String>()

    override fun act(command: String) = robot.act(command)
}

private class Senses(private val robot: Robot) : Sketch {
    override fun percepts() = robot.percepts()

    override fun act(command: String) = false
}

internal fun log(course: Course, state: Course.State) = System.getLogger("samples.robot").log(
    System.Logger.Level.INFO,
    when (state) {
        Course.State.STANDING -> "stands in front of the wall"
        Course.State.DRIVING -> "drives"
        Course.State.STOPPED -> "stopped ${cm(course.distanceAt(checkNotNull(course.halt)))} cm from the wall"
        Course.State.COLLIDED -> "ran into the wall"
    },
)
