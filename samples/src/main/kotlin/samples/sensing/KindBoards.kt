package samples.sensing

import javino.LineClock
import javino.sim.Sketch
import javino.wire.BoardAction
import samples.collision.Robot
import samples.collision.log
import kotlin.random.Random

/** The robot of the three boards in this program. */
private val robot by lazy { Robot(LineClock.system(), Random.Default, ::log) }

/** A simulated board of [robot]. The board has the sensors with the functor [functor], and accepts only [commands]. */
open class KindBoard internal constructor(
    private val name: String, private val robot: Robot, private val functor: String, private vararg val commands: String,
) : Sketch {
    final override fun name() = name

    final override fun actions() = commands.map { BoardAction(it, 0) }

    final override fun percepts() = synchronized(robot) { robot.percepts() } // only one thread at a time may read the sensors
        .filter { it.startsWith("$functor(") }

    final override fun act(command: String) = command in commands && robot.act(command)
}

/** `sim:distances`, the board with the distance sensors and the wheels in the sample `sensing-agents`. */
class DistanceBoard : KindBoard("distances", robot, "dist", "front", "stop")

/** `sim:lights`, the board with the light sensors and their lamp. */
class LightBoard : KindBoard("lights", robot, "light", "ledLightOn", "ledLightOff")

/** `sim:temperatures`, the board with the temperature sensors and their lamp. */
class TemperatureBoard : KindBoard("temperatures", robot, "temp", "ledTempOn", "ledTempOff")
