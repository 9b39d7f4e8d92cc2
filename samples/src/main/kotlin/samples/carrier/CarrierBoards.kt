package samples.carrier

import javino.LineClock
import javino.sim.Sketch
import javino.wire.BoardAction
import samples.carrier.Carrier.Direction
import kotlin.math.roundToInt

/** The robot of the three boards in this program. */
private val carrier by lazy { Carrier(LineClock.system()) }

/** A simulated board of the robot, which runs [sketch] and logs its actions. */
abstract class CarrierBoard internal constructor(private val name: String, private val sketch: Sketch) : Sketch {
    final override fun name() = name

    final override fun actions(): List<BoardAction> = sketch.actions()

    final override fun percepts(): List<String> = sketch.percepts()

    final override fun act(command: String): Boolean {
        System.getLogger("samples.$name").log(System.Logger.Level.INFO, command)
        return sketch.act(command)
    }
}

/** The sketch of one board of the robot. [deeds] are its actions, by name. */
internal abstract class Part(private vararg val deeds: Pair<String, () -> Unit>) : Sketch {
    final override fun actions() = deeds.map { BoardAction(it.first, 0) }

    final override fun act(command: String): Boolean = deeds.toMap()[command]?.invoke() != null
}

/** `sim:wheels`, the board with the wheels in the sample `three-boards`. */
class WheelsBoard : CarrierBoard("wheels", Wheels(carrier))

/** `sim:sensors`, the board with the distance sensor. */
class SensorsBoard : CarrierBoard("sensors", Eyes(carrier))

/** `sim:arm`, the board with the hand. */
class ArmBoard : CarrierBoard("arm", Arm(carrier))

/**
 * The actions are `forward`, `backward` and `halt`. The percepts are `moving(forward)`, `moving(backward)` or `moving(no)`, and `way(Cm)`
 * from the start.
 */
internal class Wheels(private val carrier: Carrier) : Part(
    "forward" to { carrier.move(Direction.FORWARD) }, "backward" to { carrier.move(Direction.BACKWARD) },
    "halt" to { carrier.move(Direction.NO) },
) {
    override fun percepts() = listOf("moving(${carrier.direction.word})", "way(${carrier.way.roundToInt()})")
}

/** The percept is `dist(front,Cm)`. */
internal class Eyes(private val carrier: Carrier) : Part() {
    override fun percepts() = listOf("dist(front,${carrier.free.roundToInt()})")
}

/** The actions are `grip`, `release` and `halt`. The percept is `hand(open)`, `hand(closed)` or `hand(full)`. */
internal class Arm(private val carrier: Carrier) : Part(
    "grip" to { carrier.grip() }, "release" to { carrier.release() },
    "halt" to {}, // the hand moves at once and cannot be halted
) {
    override fun percepts() = listOf("hand(${carrier.grasp.word})")
}
