package samples.carrier

import javino.LineClock
import javino.Transport
import javino.sim.SimulatedBoard
import samples.board.LibraryBoard
import samples.board.Sketch
import samples.carrier.Carrier.Direction
import kotlin.math.roundToInt

/** The robot of this program, which its three boards share. */
private val carrier by lazy { Carrier(LineClock.system()) }

/** A simulated board of the robot with a [sketch], which logs its actions. */
abstract class CarrierBoard internal constructor(private val name: String, private val sketch: Sketch) : SimulatedBoard {
    private val logged = object : Sketch by sketch {
        override fun act(command: String) {
            System.getLogger("samples.$name").log(System.Logger.Level.INFO, command)
            sketch.act(command)
        }
    }

    final override fun name() = name

    final override fun run(line: Transport) = LibraryBoard(logged).run(line)
}

/** `sim:wheels`, the board of the sample `three-boards` that drives. */
class WheelsBoard : CarrierBoard("wheels", Wheels(carrier))

/** `sim:sensors`, the board that sees. */
class SensorsBoard : CarrierBoard("sensors", Eyes(carrier))

/** `sim:arm`, the board that grips. */
class ArmBoard : CarrierBoard("arm", Arm(carrier))

/** Actions `forward`, `backward`, `halt`; percepts `moving(forward)`, `moving(backward)` or `moving(no)`, and `way(Cm)` from the start. */
internal class Wheels(private val carrier: Carrier) : Sketch {
    override val actions = listOf("forward", "backward", "halt")

    override fun percepts() = "moving(${carrier.direction.word});way(${carrier.way.roundToInt()});"

    override fun act(command: String) = when (command) {
        "forward" -> carrier.move(Direction.FORWARD)
        "backward" -> carrier.move(Direction.BACKWARD)
        "halt" -> carrier.move(Direction.NO)
        else -> Unit
    }
}

/** Percept `dist(front,Cm)`. */
internal class Eyes(private val carrier: Carrier) : Sketch {
    override fun percepts() = "dist(front,${carrier.free.roundToInt()});"

    override fun act(command: String) = Unit
}

/** Actions `grip`, `release`, `halt`; percept `hand(open)`, `hand(closed)` or `hand(full)`. */
internal class Arm(private val carrier: Carrier) : Sketch {
    override val actions = listOf("grip", "release", "halt")

    override fun percepts() = "hand(${carrier.grasp.word});"

    override fun act(command: String) = when (command) {
        "grip" -> carrier.grip()
        "release" -> carrier.release()
        else -> Unit // a hand that moves at once has nothing to halt
    }
}
