package experiment.delegation

import javino.LineClock
import kotlin.random.Random

/**
 * The world of a run. From time to time an obstacle, the stimulus, comes near one of the robot's distance sensors, and stays until the
 * robot has stopped for it. Any thread may call these functions.
 *
 * Each reading of each sensor differs from its last one. A distance is at least [CLEAR_CM], but less than [NEAR_CM] for a sensor with an
 * obstacle. Successive obstacles have different distances, so a command, which names the distance, belongs to one of them.
 *
 * @param sensors the number of sensors, a multiple of three
 */
internal class Stimuli(private val sensors: Int, private val clock: LineClock, private val random: Random) {
    private val perKind = sensors / KINDS.size
    private val ended = ArrayList<Reaction>()
    private var readings = 0
    private var near = next(clock.nanos())

    /** An obstacle, which comes at the instant [at] before the sensor with this number, [cm] away. */
    private class Near(val at: Long, val sensor: Int, val cm: Int)

    /** The reaction, after [ms], to a stimulus that came at the instant [at]; null: none within [LIMIT_MS]. */
    class Reaction(val at: Long, val ms: Double?)

    /** The stimuli that are over. */
    val reactions: List<Reaction> @Synchronized get() = ended.toList()

    /** Returns true if all stimuli from before [instant] are over. */
    @Synchronized
    fun areOver(instant: Long) = near.at >= instant

    private fun next(now: Long) =
        Near(now + random.nextLong(MIN_PAUSE_NANOS, MAX_PAUSE_NANOS), random.nextInt(perKind), ended.size % (NEAR_CM - 1) + 1)

    private fun end(now: Long, ms: Double?) {
        ended += Reaction(near.at, ms)
        near = next(now)
    }

    /** Reads the sensors of these [kinds] anew: first sensor 1 of each kind, then sensor 2 of each, and so on. */
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

    /** Takes the command to stop for an obstacle that is [cm] away. Has no effect if the obstacle has gone. */
    @Synchronized
    fun stop(cm: Int) {
        val now = clock.nanos()
        if (cm == near.cm && now >= near.at) end(now, (now - near.at) / 1e6)
    }

    companion object {
        /** A stimulus without a reaction ends after this time, in ms. */
        const val LIMIT_MS = 2_000

        const val NEAR_CM = 40
        const val CLEAR_CM = 100
        private const val CHANGES = 300
        private const val MIN_PAUSE_NANOS = 50_000_000L
        private const val MAX_PAUSE_NANOS = 150_000_000L
    }
}
