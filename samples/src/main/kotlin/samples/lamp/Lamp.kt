package samples.lamp

import javino.sim.Sketch

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
