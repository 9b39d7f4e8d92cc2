package benchmarks

import argo.filters.PerceptionFilter
import argo.filters.RuleList
import argo.filters.dropFilter
import argo.filters.matching.FilterSession
import java.util.Random

/** A kind of wrong numbers from a range finder. */
internal enum class Stray(val words: String, val cm: (Random) -> Int) {
    LOST("lost echoes, 0 cm", { 0 }),
    ANY("stray echoes, 2 to 400 cm", { 2 + it.nextInt(399) }),
    NEAR("stray echoes below the limit, 0 to 39 cm", { it.nextInt(LIMIT_CM) }),
}

internal val SMOOTHING: Map<String, RuleList.() -> Unit> = mapOf(
    "median 5" to { smooth("dist") { argument(1) median 5 } },
    "outliers 3 among 5" to { smooth("dist") { argument(1).outliers(3) } },
    "maxRate 200" to { smooth("dist") { argument(1) maxRate 200 } },
    "outliers 3 among 5, median 3" to { smooth("dist") { argument(1).outliers(3); argument(1) median 3 } },
)

/**
 * Simulates an agent whose critical rule stops a robot below 40 cm. A range finder is read 20 times per second. 5 % of its percepts are
 * outliers. While the robot stands at 45 cm, prints the share of false stops that smoothing leaves. For an exact sensor, prints the delay
 * of the stop by smoothing, in percepts. One wall comes nearer, and another appears suddenly.
 */
internal fun noise() {
    println("stops with outliers in 5 % of the percepts, 45 cm before the sensor with noise of 1 cm, limit 40 cm, simulated:")
    for (stray in Stray.entries) {
        val raw = falseStops({}, stray)
        for ((words, rules) in SMOOTHING) {
            println(figures("%-42s %-30s %8.3f %% of %d false stops left", stray.words, words, 100.0 * falseStops(rules, stray) / raw, raw))
        }
    }
    for ((words, rules) in SMOOTHING) {
        println(figures("%-30s delay of a stop: %d percepts driving at 50 cm/s, %d before a wall that appears",
            words, delay(rules, DRIVING), delay(rules, APPEARING)))
    }
}

/** Returns the number of false stops of a standing robot in so many [percepts]. */
internal fun falseStops(smoothing: RuleList.() -> Unit, stray: Stray, percepts: Int = 1_000_000): Int {
    val random = Random(42)
    val stops = Stops(careful(smoothing))
    return (1..percepts).count {
        stops.begin(if (random.nextInt(100) < OUTLIERS_PERCENT) stray.cm(random) else (STANDING_CM + random.nextGaussian()).toInt())
    }
}

/** The distances that the sensor shows while the robot drives towards a wall, for several starts. */
internal val DRIVING: List<List<Int>> = (60..69).map { begin -> List(40) { (begin - it * 2.5).toInt() } }

/** The distances that the sensor shows when a wall suddenly appears. */
internal val APPEARING: List<List<Int>> = listOf(List(40) { if (it < 8) 60 else 20 })

/** Returns the longest delay of the stop by [smoothing], in percepts, for the distances of all [courses]. */
internal fun delay(smoothing: RuleList.() -> Unit, courses: List<List<Int>>): Int = courses.maxOf { course ->
    fun begin(rules: RuleList.() -> Unit) = Stops(careful(rules)).let { stops -> course.indexOfFirst(stops::begin) }
    begin(smoothing) - begin {}
}

private fun careful(smoothing: RuleList.() -> Unit): PerceptionFilter = dropFilter("careful") {
    smoothing()
    critical("dist") {
        argument(1) lt LIMIT_CM
        smoothed()
        reflex("stop")
    }
}

private class Stops(filter: PerceptionFilter) {
    private val session = FilterSession.ofTexts().also { it.switchTo(filter) }
    private var nowMs = 0L
    private var isMet = false

    /** Takes a percept with the distance [cm]. Returns true if the critical rule starts to match. */
    fun begin(cm: Int): Boolean {
        val wasMet = isMet
        isMet = session.perceive(listOf("dist(f,$cm)"), nowMs).critical.isNotEmpty()
        nowMs += INTERVAL_MS
        return isMet && !wasMet
    }
}

private const val LIMIT_CM = 40
private const val STANDING_CM = 45
private const val OUTLIERS_PERCENT = 5
private const val INTERVAL_MS = 50L
