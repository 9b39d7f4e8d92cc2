package experiment.delegation

import javino.LineClock
import javino.sim.Sketch
import javino.wire.BoardAction
import kotlin.random.Random

/**
 * The world of a run. From time to time an obstacle, the stimulus, appears in front of a distance sensor. The obstacle stays until the
 * robot has stopped for it. Safe for use by several threads.
 *
 * Each reading of each sensor differs from its last one. A distance is at least [CLEAR_CM]. For a sensor with an obstacle, it is less than
 * [NEAR_CM]. Successive obstacles have different distances. A command names the distance, so it belongs to one obstacle.
 *
 * @param sensors the number of sensors, a multiple of three
 */
internal class Stimuli(private val sensors: Int, private val clock: LineClock, private val random: Random) {
    private val perKind = sensors / KINDS.size
    private val ended = ArrayList<Reaction>()
    private var readings = 0
    private var near = next(clock.nanos())

    /** An obstacle that appears at [at] in front of sensor number [sensor], [cm] away. */
    private class Near(val at: Long, val sensor: Int, val cm: Int)

    /** The reaction to a stimulus of the time [at], after [ms]. Null means no reaction within [LIMIT_MS]. */
    class Reaction(val at: Long, val ms: Double?)

    val reactions: List<Reaction> @Synchronized get() = ended.toList()

    @Synchronized
    fun areOver(instant: Long) = near.at >= instant

    private fun next(now: Long) =
        Near(now + random.nextLong(MIN_PAUSE_NANOS, MAX_PAUSE_NANOS), random.nextInt(perKind), ended.size % (NEAR_CM - 1) + 1)

    private fun end(now: Long, ms: Double?) {
        ended += Reaction(near.at, ms)
        near = next(now)
    }

    /** Reads the sensors of these [kinds]: sensor 1 of each kind, then sensor 2 of each, and so on. */
    @Synchronized
    fun read(kinds: List<String>): List<String> {
        val now = clock.nanos()
        if (now - near.at > LIMIT_MS * 1_000_000L) end(now, null)
        val changing = CLEAR_CM + readings++ % CHANGES
        val isNear = now >= near.at
        return List(perKind) { sensor ->
            kinds.map { kind -> "$kind($sensor,${if (kind == "dist" && isNear && sensor == near.sensor) near.cm else changing})" }
        }.flatten()
    }

    /** Takes the command to stop for an obstacle at the distance [cm]. Has no effect if the obstacle has gone. */
    @Synchronized
    fun stop(cm: Int) {
        val now = clock.nanos()
        if (cm == near.cm && now >= near.at) end(now, (now - near.at) / 1e6)
    }

    companion object {
        /** A stimulus without a reaction ends after this time in ms. */
        const val LIMIT_MS = 2_000

        const val NEAR_CM = 40
        const val CLEAR_CM = 100
        private const val CHANGES = 300
        private const val MIN_PAUSE_NANOS = 50_000_000L
        private const val MAX_PAUSE_NANOS = 150_000_000L
    }
}

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
