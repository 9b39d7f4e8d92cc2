package samples.carrier

import javino.LineClock
import javino.sim.Sketch
import javino.wire.BoardAction
import samples.carrier.Carrier.Direction
import kotlin.math.roundToInt

/** The robot, which the three boards of this program share. */
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

/** The sketch of one of the robot's boards. [deeds] are its actions, each with its name. */
internal abstract class Part(private vararg val deeds: Pair<String, () -> Unit>) : Sketch {
    final override fun actions() = deeds.map { BoardAction(it.first, 0) }

    final override fun act(command: String): Boolean = deeds.toMap()[command]?.invoke() != null
}

/** `sim:wheels`, the board of the sample `three-boards` that drives. */
class WheelsBoard : CarrierBoard("wheels", Wheels(carrier))

/** `sim:sensors`, the board that sees. */
class SensorsBoard : CarrierBoard("sensors", Eyes(carrier))

/** `sim:arm`, the board that grips. */
class ArmBoard : CarrierBoard("arm", Arm(carrier))

/** Actions `forward`, `backward`, `halt`; percepts `moving(forward)`, `moving(backward)` or `moving(no)`, and `way(Cm)` from the start. */
internal class Wheels(private val carrier: Carrier) : Part(
    "forward" to { carrier.move(Direction.FORWARD) }, "backward" to { carrier.move(Direction.BACKWARD) },
    "halt" to { carrier.move(Direction.NO) },
) {
    override fun percepts() = listOf("moving(${carrier.direction.word})", "way(${carrier.way.roundToInt()})")
}

/** Percept `dist(front,Cm)`. */
internal class Eyes(private val carrier: Carrier) : Part() {
    override fun percepts() = listOf("dist(front,${carrier.free.roundToInt()})")
}

/** Actions `grip`, `release`, `halt`; percept `hand(open)`, `hand(closed)` or `hand(full)`. */
internal class Arm(private val carrier: Carrier) : Part(
    "grip" to { carrier.grip() }, "release" to { carrier.release() },
    "halt" to {}, // the hand moves at once, so there is nothing to halt
) {
    override fun percepts() = listOf("hand(${carrier.grasp.word})")
}
