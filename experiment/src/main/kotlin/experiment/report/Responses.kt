package experiment.report

import experiment.Condition
import experiment.Entry
import experiment.Finished
import experiment.Outcome
import experiment.Plan
import experiment.View
import samples.collision.Course

/**
 * The analysed number of each run.
 *
 * After a collision, the time is not known, since the run ended before the agent reacted. The number for a collision is therefore a choice.
 *
 * @property collisions the number for a collision, in words
 */
internal enum class Response(val title: String, val unit: String, val collisions: String) {
    /** The published response. All collisions get one number. The number does not depend on the limit, since the limit is a factor. */
    PERCEIVED_TIME("time from perceiving the wall", "s", "with the longest time that any limit leaves, the same for all") {
        override fun of(result: Entry.Result, plan: Plan) = result.orLongest(plan) { sincePerceivingMs ?: 0.0 }
    },

    /** [PERCEIVED_TIME] with another number for collisions: the time until the wall. The agent needed at least this time. */
    LEAST_PERCEIVED_TIME(
        "least time from perceiving the wall", "s",
        "with the time from perceiving the wall to reaching it, which is less than its agent needed",
    ) {
        override fun of(result: Entry.Result, plan: Plan) = (result.sincePerceivingMs ?: 0.0) / 1000
    },

    /** The time since the robot was at the limit. The time includes the delay from the sensor to the agent. */
    LIMIT_TIME("time from crossing the limit", "s", "with the longest time that any limit leaves, the same for all") {
        override fun of(result: Entry.Result, plan: Plan) = result.orLongest(plan) { sinceLimitMs }
    },

    DISTANCE("stopping distance", "cm", "with 0 cm") {
        override fun of(result: Entry.Result, plan: Plan) = result.distance
    }, ;

    val isTime: Boolean get() = unit == "s"

    /** True if the paper has this response, possibly with other numbers for collisions. */
    val isPublished: Boolean get() = this == PERCEIVED_TIME || this == LEAST_PERCEIVED_TIME

    abstract fun of(result: Entry.Result, plan: Plan): Double
}

/** Returns [ms] in seconds. For a collision, returns the longest time that any limit leaves. */
private fun Entry.Result.orLongest(plan: Plan, ms: Entry.Result.() -> Double) =
    if (outcome == Outcome.COLLIDED) plan.limits.max() / Course.SPEED_CM_S else ms() / 1000

/** The factors in the order of the analysis: L, I and F are A, B and C. */
internal val FACTORS = listOf("L", "I", "F")

/** Returns the name of [source] in terms of these three [factors], such as `L×F`. */
internal fun words(source: Source, factors: List<String> = FACTORS): String = source.factors.joinToString("×") { factors[it] }

/** Analyses [response] in the runs of [plan] under [condition]. Returns null if some of these runs are missing or failed. */
internal fun analysis(finished: List<Finished>, plan: Plan, condition: Condition, response: Response): Factorial? {
    val results = finished.filter { it.isMeasured }.associate { it.trial to it.result }
    val trials = plan.trials(condition)
    if (!results.keys.containsAll(trials)) return null
    return Factorial(
        plan.limits.map { limit ->
            plan.intervals.map { interval ->
                View.entries.map { view ->
                    trials.filter { it.limit == limit && it.interval == interval && it.view == view }.map {
                        response.of(results.getValue(it), plan)
                    }
                }
            }
        },
    )
}

/**
 * The published shares in percent, for the variation of the time from perceiving the wall. The source is C. E. Pantoja et al., EMAS 2016,
 * Table 2. F is the filter, L the distance limit, I the perception interval.
 */
internal object Published {
    val percent: Map<Source, Double> = mapOf(
        Source.A to 1.415, Source.B to 0.165, Source.C to 88.965,
        Source.AB to 0.525, Source.AC to 3.715, Source.BC to 0.265, Source.ABC to 1.725,
    )

    const val ERROR_PERCENT = 3.285

    val sumPercent: Double get() = percent.values.sum() + ERROR_PERCENT
}
