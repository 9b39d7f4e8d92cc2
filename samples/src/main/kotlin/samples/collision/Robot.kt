package samples.collision

import javino.LineClock
import javino.sim.Sketch
import javino.wire.BoardAction
import java.util.concurrent.atomic.AtomicReference
import kotlin.random.Random

/**
 * A 4WD robot in front of a wall. The command `front` makes it drive, and `stop` makes it halt. `ledLightOn`, `ledLightOff`, `ledTempOn`
 * and `ledTempOff` switch its two lamps.
 *
 * @param noticed called with each change of the robot's state, when the board handles its next message
 */
class Robot(
    private val clock: LineClock, private val sensors: Sensors, private val noticed: (Course, Course.State) -> Unit = { _, _ -> },
) : Sketch {
    private val way = AtomicReference(Course.standing(clock.nanos()))
    private var lastNoticed = Course.State.STANDING

    /** Makes a robot with twelve sensors. [random] determines their noise. */
    constructor(
        clock: LineClock, random: Random, noticed: (Course, Course.State) -> Unit = { _, _ -> },
    ) : this(clock, Sensors(random), noticed)

    /** The robot's course up to now. Safe for use by several threads. */
    val course: Course get() = way.get()

    /** The lamps that are on, `light` and `temp`. Safe for use by several threads. */
    @Volatile
    var lamps: Set<String> = emptySet()
        private set

    /** Puts the robot back to its start, where it stands. Safe for use by several threads. */
    fun putBack() = way.set(Course.standing(clock.nanos()))

    override fun actions() = ACTIONS.map { BoardAction(it, 0) }

    override fun percepts(): List<String> {
        val now = clock.nanos()
        notice(now)
        return sensors.frame(course.distanceAt(now))
    }

    override fun act(command: String): Boolean {
        val now = clock.nanos()
        when (command) {
            "front" -> way.set(course.drive(now))
            "stop" -> way.set(course.stop(now))
            "ledLightOn" -> lamps += "light"
            "ledLightOff" -> lamps -= "light"
            "ledTempOn" -> lamps += "temp"
            "ledTempOff" -> lamps -= "temp"
        }
        notice(now)
        return command in ACTIONS
    }

    @Synchronized // a second board for the sensors has its own thread
    private fun notice(now: Long) {
        val state = course.stateAt(now)
        if (state == lastNoticed) return
        lastNoticed = state
        noticed(course, state)
    }

    private companion object {
        val ACTIONS = listOf("front", "stop", "ledLightOn", "ledLightOff", "ledTempOn", "ledTempOff")
    }
}
