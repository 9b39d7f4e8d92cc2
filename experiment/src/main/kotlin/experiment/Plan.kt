package experiment

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable
import kotlin.random.Random

/**
 * The runs of an experiment: a full factorial design with replications.
 *
 * @property limits the levels of the distance limit, in cm
 * @property intervals the levels of the sensing interval, in ms
 */
@Serializable
internal enum class Plan(
    val limits: List<Int>, val intervals: List<Int>, val replications: Int, val sensors: List<Int>, val bauds: List<Int>,
) {
    /** The published plan: 27 combinations, 81 runs. */
    @SerialName("full")
    FULL(listOf(40, 80, 120), listOf(20, 35, 50), 3, listOf(12, 48, 192, 768), listOf(9_600, 38_400, 115_200, 250_000, 1_000_000)),

    /** A part of the experiment that takes a few minutes: 12 combinations, 24 runs. */
    @SerialName("quick")
    QUICK(listOf(80, 120), listOf(20, 50), 2, listOf(12, 192), listOf(9_600, 115_200)),

    /** Tests the experiment itself: few combinations, with replications for an error term. */
    @SerialName("smoke")
    SMOKE(listOf(185, 190), listOf(20), 2, listOf(12), listOf(115_200)),
    ;

    fun trials(condition: Condition): List<Trial> = buildList {
        for (view in View.entries) for (limit in limits) for (interval in intervals) for (replication in 1..replications) {
            add(Trial(condition, view, limit, interval, replication))
        }
    }

    /**
     * Returns the runs beyond the factorial design, with more sensors and faster lines. All have one limit and one interval. The agent
     * perceives all sensors or only the front distance.
     */
    fun scaling(condition: Condition): List<Trial> = buildList {
        for (view in listOf(View.NONE, View.FRONT_DISTANCE)) for (count in sensors) for (baud in bauds) {
            add(Trial(condition, view, limits[limits.size / 2], intervals.first(), 1, baud, count))
        }
    }.filter { it.isScaled }
}

internal fun randomised(trials: List<Trial>, seed: Long): List<Trial> = trials.shuffled(Random(seed))

/** Returns the seed of the sensors' noise in [trial]. A repeated run keeps its seed. Different runs have different seeds. */
internal fun noiseSeed(trial: Trial, seed: Long): Long = 31 * seed + trial.id.hashCode()
