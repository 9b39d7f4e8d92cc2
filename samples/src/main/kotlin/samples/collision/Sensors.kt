package samples.collision

import kotlin.math.ceil
import kotlin.random.Random

/**
 * The twelve sensors of the robot. The sensors measure distance (cm), light (0 to 1023, as an analogue input) and temperature (°C) at the
 * robot's front, back, right and left. A robot with more sensors has several sets of twelve at these places. The sides of the second set
 * are `f2`, `b2` and so on.
 *
 * Every reading has noise, and no sensor repeats a reading at once. All twelve percepts therefore change in each frame. Changes of all
 * percepts are the worst case for an agent, and real sensors come close to it. A distance reading is never too short. The distance is
 * rounded up to a whole cm, plus up to [DISTANCE_NOISE] cm. The room is [ROOM_CM] long.
 *
 * Not safe for use by several threads at once.
 *
 * @param sets the number of the robot's sets of twelve sensors, at least 1
 */
class Sensors(private val random: Random, private val sets: Int = 1) {
    private val last = HashMap<Pair<String, String>, Int>()

    init {
        require(sets >= 1) { "a robot has at least one set of sensors, not $sets" }
    }

    /** Returns the percepts of one frame, from `dist(f,123)` to `temp(l,25)`. The robot's front is [distance] cm from the wall. */
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
        const val PER_SET = 12

        /** The greatest excess of a distance reading over the rounded-up true distance, in cm. */
        const val DISTANCE_NOISE = 1

        /** The length of the room in cm from the front wall to the back wall, minus the robot's length. */
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
