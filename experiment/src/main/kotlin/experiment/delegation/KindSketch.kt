package experiment.delegation

import javino.sim.Sketch
import javino.wire.BoardAction

/** A board with the sensors of these [kinds], which reads them from [stimuli]. With [motors], it has the action `stop(Cm)`. */
internal class KindSketch(private val stimuli: Stimuli, private val kinds: List<String>, private val motors: Boolean) : Sketch {
    override fun percepts(): List<String> = stimuli.read(kinds)

    override fun actions() = if (motors) listOf(BoardAction(STOP, 1)) else emptyList()

    override fun act(command: String): Boolean {
        if (!motors || !command.startsWith("$STOP(")) return false
        stimuli.stop(command.removePrefix("$STOP(").removeSuffix(")").toInt())
        return true
    }

    private companion object {
        const val STOP = "stop"
    }
}
