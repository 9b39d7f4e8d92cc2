package samples.lamp

import javino.Transport
import javino.sim.SimulatedBoard
import samples.board.FieldBoard

/** A simulated board with a [Lamp]. The board logs the changes of the lamp. */
abstract class LampBoard internal constructor(private val name: String) : SimulatedBoard {
    private val board =
        FieldBoard(Lamp(name) { on -> System.getLogger("samples.$name").log(System.Logger.Level.INFO, "LED ${if (on) "on" else "off"}") })

    final override fun name() = name

    final override fun run(line: Transport) = board.run(line)
}

/** `sim:blink`, the board of the sample `blink`. */
class BlinkBoard : LampBoard("blink")

/** `sim:left`, one of the boards of the sample `two-boards`. */
class LeftBoard : LampBoard("left")

/** `sim:right`, the other board of the sample `two-boards`. */
class RightBoard : LampBoard("right")
