package samples.fleet

import javino.LineClock
import javino.Transport
import javino.sim.SimulatedBoard
import javino.sim.Sketch
import samples.board.FieldBoard

/**
 * The firmware of a robot that drives to the place P after `goto(P)`. The percept is `driving(P)` on the way, and `at(P)` after [TRAVEL_MS]
 * ms. The first percept is `at(home)`.
 */
class Rover(private val clock: LineClock) : Sketch {
    private var place = "home"
    private var arrivesAt = clock.nanos()

    override fun percepts() = listOf(if (clock.nanos() - arrivesAt >= 0) "at($place)" else "driving($place)")

    override fun act(command: String): Boolean {
        val goal = GOTO.matchEntire(command)?.groupValues?.get(1) ?: return false
        if (goal != place) arrivesAt = clock.nanos() + TRAVEL_MS * 1_000_000L
        place = goal
        return true
    }

    companion object {
        /** The travel time between any two places, in ms. */
        const val TRAVEL_MS = 400

        private val GOTO = Regex("""goto\((\w+)\)""")
    }
}

/** `sim:rover`, the board of each scout in the sample `fleet`. Each process has one rover. */
class RoverBoard : SimulatedBoard {
    private val board = FieldBoard(Rover(LineClock.system()))

    override fun name() = "rover"

    override fun run(line: Transport) = board.run(line)
}
