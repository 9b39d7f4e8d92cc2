package samples.collision

import kotlin.math.ceil
import kotlin.random.Random

/**
 * The twelve sensors of the robot: distance (cm), light (0 to 1023, like an analogue input) and temperature (°C) at its front, back, right
 * and left. A robot with more sensors has several sets of twelve at the same places. The sides of the second set are called `f2`, `b2` and
 * so on.
 *
 * Every reading has noise, and no sensor gives the same reading twice in a row. So all twelve percepts change from frame to frame. Percepts
 * that all change are the worst case for an agent, and real sensors come close to that. A distance reading is never too short: it is
 * rounded up to a whole cm, and up to [DISTANCE_NOISE] cm longer. The room is [ROOM_CM] long.
 *
 * For one thread.
 *
 * @param sets the number of the robot's sets of twelve sensors, at least 1
 */
class Sensors(private val random: Random, private val sets: Int = 1) {
    private val last = HashMap<Pair<String, String>, Int>()

    init {
        require(sets >= 1) { "a robot has at least one set of sensors, not $sets" }
    }

    /** Returns the percepts of one frame, from `dist(f,123)` to `temp(l,25)`, of a robot whose front is [distance] cm from the wall. */
    fun frame(distance: Double): List<String> = buildList {
        for (set in 1..sets) for (kind in KINDS) for (side in SIDES) {
            val place = if (set == 1) "$side" else "$side$set"
            add("${kind.functor}($place,${read(kind, place, kind.level(side, distance))})")
        }
    }

    private fun read(kind: Kind, place: String, level: Int): Int {
        val before = last[kind.functor to place]
        val readings = kind.noise.map { level + it }.filter { it != before }
        return readings.random(random).also { last[kind.functor to place] = it }
    }

    private class Kind(val functor: String, val noise: IntRange, val level: (side: Char, distance: Double) -> Int)

    companion object {
        /** The number of sensors in a set: three kinds on four sides. */
        const val PER_SET = 12

        /** A distance reading exceeds the true distance, rounded up, by at most this, in cm. */
        const val DISTANCE_NOISE = 1

        /** The length of the room in cm, from the wall in front to the wall behind, less the robot's own length. */
        const val ROOM_CM = 400.0

        private const val AISLE_CM = 80.0
        private const val SIDES = "fbrl"
        private val LIGHT = mapOf('f' to 95, 'b' to 105, 'r' to 140, 'l' to 60) // some are near limits in the agent's plans
        private val TEMPERATURE = mapOf('f' to 25, 'b' to 26, 'r' to 25, 'l' to 24)

        private val KINDS = listOf(
            Kind("dist", 0..DISTANCE_NOISE) { side, distance -> ceil(distanceOf(side, distance)).toInt() },
            Kind("light", -15..15) { side, _ -> LIGHT.getValue(side) },
            Kind("temp", -2..2) { side, _ -> TEMPERATURE.getValue(side) },
        )

        private fun distanceOf(side: Char, front: Double) = when (side) {
            'f' -> front
            'b' -> ROOM_CM - front
            else -> AISLE_CM
        }
    }
}
