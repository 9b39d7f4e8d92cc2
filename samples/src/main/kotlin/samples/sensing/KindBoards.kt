package samples.sensing

import javino.LineClock
import javino.sim.Sketch
import javino.wire.BoardAction
import samples.collision.Robot
import samples.collision.log
import kotlin.random.Random

/** The robot of this program, which its three boards share. */
private val robot by lazy { Robot(LineClock.system(), Random.Default, ::log) }

/** A simulated board of a [robot], with the sensors whose percepts have [functor], and the [commands] that belong to them. */
open class KindBoard internal constructor(
    private val name: String, private val robot: Robot, private val functor: String, private vararg val commands: String,
) : Sketch {
    final override fun name() = name

    final override fun actions() = commands.map { BoardAction(it, 0) }

    final override fun percepts() = synchronized(robot) { robot.percepts() } // its sensors are for one thread, and each board has its own
        .filter { it.startsWith("$functor(") }

    final override fun act(command: String) = command in commands && robot.act(command)
}

/** `sim:distances`, the board of the sample `sensing-agents` with the distance sensors and the wheels. */
class DistanceBoard : KindBoard("distances", robot, "dist", "front", "stop")

/** `sim:lights`, the board with the light sensors and their lamp. */
class LightBoard : KindBoard("lights", robot, "light", "ledLightOn", "ledLightOff")

/** `sim:temperatures`, the board with the temperature sensors and their lamp. */
class TemperatureBoard : KindBoard("temperatures", robot, "temp", "ledTempOn", "ledTempOff")
