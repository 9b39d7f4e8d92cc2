package samples.experiment.analysis

import samples.collision.Course
import samples.experiment.Condition
import samples.experiment.Entry
import samples.experiment.Finished
import samples.experiment.Outcome
import samples.experiment.Plan
import samples.experiment.View

/**
 * What is analysed: a number for each run.
 *
 * A robot that ran into the wall has no response time: its agent needed longer than there was. Its entry is a choice.
 *
 * @property title what it is called
 * @property unit what it is measured in
 * @property collisions how a robot that ran into the wall enters
 */
internal enum class Response(val title: String, val unit: String, val collisions: String) {
    /** All collisions are equally bad, so that the limit, which is a factor, does not also decide how bad they are. */
    TIME("response time", "s", "with the longest time that any limit leaves, the same for all") {
        override fun of(result: Entry.Result, plan: Plan) =
            if (result.outcome == Outcome.COLLIDED) plan.limits.max() / Course.SPEED_CM_S else result.responseMs / 1000
    },

    /** What is certain: the agent needed no less. */
    LEAST_TIME("least response time", "s", "with the time that its own limit left, which is less than its agent needed") {
        override fun of(result: Entry.Result, plan: Plan) = result.responseMs / 1000
    },

    /** The distance from the wall in the end. */
    DISTANCE("stopping distance", "cm", "with 0 cm") {
        override fun of(result: Entry.Result, plan: Plan) = result.distance
    }, ;

    /** Whether it is a time, in seconds. */
    val isTime: Boolean get() = unit == "s"

    /** Its value in a run with [result] of [plan]. */
    abstract fun of(result: Entry.Result, plan: Plan): Double
}

/** The factors in the order of the analysis: L, I, F as A, B, C. */
internal val FACTORS = listOf("L", "I", "F")

/** What [source] is called: `L×F`. */
internal fun words(source: Source): String = source.factors.joinToString("×") { FACTORS[it] }

/** The analysis of [response] in the runs of [plan] under [condition], or null if some of them are missing or have failed. */
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
 * The shares of the variation of the response time that were published: C. E. Pantoja et al., EMAS 2016, in percent. The filter is called
 * F, the distance limit L, the perception interval I.
 */
internal object Published {
    val percent: Map<Source, Double> = mapOf(
        Source.A to 1.415, Source.B to 0.165, Source.C to 88.965,
        Source.AB to 0.525, Source.AC to 3.715, Source.BC to 0.265, Source.ABC to 1.725,
    )

    /** Of the error. */
    const val ERROR_PERCENT = 3.285
}
