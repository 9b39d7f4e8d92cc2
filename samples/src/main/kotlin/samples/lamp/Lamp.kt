package samples.lamp

import javino.Transport
import javino.sim.SimulatedBoard
import javino.sim.Sketch
import samples.board.FieldBoard

/**
 * The firmware of a board with one LED. The actions `ledOn` and `ledOff` switch the LED. The percept is `led(Name,on)` or `led(Name,off)`.
 *
 * @param name the board's name in its percept, an atom
 * @param switched called by the board's thread at each change of the LED
 */
class Lamp(private val name: String, private val switched: (on: Boolean) -> Unit) : Sketch {
    private var on = false

    override fun percepts() = listOf("led($name,${if (on) "on" else "off"})")

    override fun act(command: String) = when (command) {
        "ledOn" -> switch(true)
        "ledOff" -> switch(false)
        else -> false
    }

    private fun switch(on: Boolean): Boolean {
        if (on != this.on) switched(on)
        this.on = on
        return true
    }
}

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
