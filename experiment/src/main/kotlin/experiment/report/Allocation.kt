package experiment.report

import experiment.Condition
import experiment.Plan
import experiment.View
import kotlin.math.sqrt

internal val ALLOCATION_METHOD = """<p>By the method of R. Jain, <em>The Art of Computer Systems Performance Analysis</em>: the share of
each factor and interaction in the variation of a response, as sums of squares of the effects over the total one.</p>
<p>Estimated effects contain some random error. So a factor without any effect has a share in the sample, too, and the error's
share is smaller by it. The 95 % intervals are those of the shares as they would be if each combination were run without end; a small share
can lie above its interval, and the error's below. 0 is in the interval of an effect that is none in 97.5 % of experiments. The intervals
are generalized confidence intervals (S. Weerahandi, JASA 88, 1993), which for a single effect, and for the error, are those of the
noncentral F distribution (J. H. Steiger, Psychological Methods 9, 2004). They suppose errors that are normal and of one variance in all
combinations; the interval of an effect that varies less than errors make likely is short, or only 0. The shares of a
condition have as many digits as the widest of their intervals allows.</p>
"""

/** Makes the tables of the shares for [response]. [columns] has the analysis of each condition. */
internal class Allocation(private val response: Response, private val columns: Map<Condition, Factorial>, seed: Long) {
    private val intervals = columns.mapValues { (_, analysis) -> shareIntervals(analysis, seed) }
    private val decimals = intervals.mapValues { (_, all) ->
        minOf(all?.widest()?.let(::percent)?.decimals ?: UNSURE_DECIMALS, MOST_DECIMALS)
    }

    fun heading(): String = "<h3>${response.title.replaceFirstChar(Char::uppercase)}</h3>\n<p>In percent. A robot that ran into the wall " +
        "enters ${escaped(response.collisions)}. " +
        (if (response == Response.LEAST_PERCEIVED_TIME) "Conditions without such a robot are left out: their shares are those of the " +
            "${Response.PERCEIVED_TIME.title}. " else "") + "The last row is the variance that is divided up." +
        (if (response.isPublished) " The published shares are those of the paper's Table 2, which add up to " +
            "${rounded(Published.sumPercent, 2)} %." else "") + "</p>\n"

    /** Returns the table of the sample's shares beside the published shares. The table's name is [number]. */
    fun shares(number: String): String {
        val rows = Source.entries.map { source -> row(words(source), Published.percent.getValue(source)) { it.share(source) } } +
            listOf(row("error", Published.ERROR_PERCENT) { it.errorShare }, variances())
        return table(
            "$number. Allocation of variation of the ${response.title}, in percent.",
            listOf("share") + published("published") + heads(), rows,
        )
    }

    private fun row(name: String, published: Double, share: (Factorial) -> Double) = listOf(name) + published("$published") +
        columns.map { (condition, analysis) -> rounded(100 * share(analysis), decimals.getValue(condition)) }

    fun intervals(number: String): String {
        val rows = Source.entries.map { source -> intervalsRow(words(source)) { it.sources.getValue(source) } } +
            listOf(intervalsRow("error") { it.error })
        return table(
            "$number. 95 % intervals of the shares in the ${response.title}, without the errors' part, in percent.",
            listOf("share") + heads(), rows,
        )
    }

    private fun intervalsRow(name: String, interval: (ShareIntervals) -> Interval) = listOf(name) +
        intervals.map { (condition, all) -> all?.let { range(percent(interval(it)), decimals.getValue(condition)) } ?: "unknown" }

    private fun heads() = columns.keys.map { "(${it.letter})" }

    private fun published(text: String) = if (response.isPublished) listOf(text) else emptyList()

    private fun variances(): List<String> {
        val variances = columns.values.map { it.total / (it.count - 1) }
        val scale = if (response.isTime) TimeScale.of(variances.map(::sqrt)) else null
        val factor = scale?.perSecond ?: 1
        return listOf("variance, ${scale?.unit ?: response.unit}²") + published("–") + variances.map { twoDigits(it * factor * factor) }
    }

    private fun ShareIntervals.widest() = (sources.values + error).maxBy { it.high - it.low }

    private fun percent(interval: Interval) = Interval(100 * interval.low, 100 * interval.high)

    private companion object {
        /** The greatest number of decimals for shares with intervals. The published shares have three. */
        const val MOST_DECIMALS = 2

        const val UNSURE_DECIMALS = 1
    }
}

/**
 * Returns the table with the effects of [plan]'s factors on the time from perceiving the wall in [condition]. The table's name is [number].
 */
internal fun effects(number: String, condition: Condition, analysis: Factorial, plan: Plan): String {
    val effects = listOf(Source.A, Source.B, Source.C).flatMap { analysis.effects(it, CONFIDENCE) }
    val mean = analysis.mean(CONFIDENCE)
    val scale = TimeScale.of(effects.flatMap { listOf(it.value, it.interval.low, it.interval.high) } + analysis.mean)
    val table = table(
        "$number. Effects on the time from perceiving the wall in condition (${condition.letter}).",
        listOf("factor", "level", "effect, ${scale.unit}", "95 % interval, ${scale.unit}", "differs from 0"),
        effects.map { row(it, plan, scale) }, words = 2,
    )
    return "<details><summary>Effects on the time from perceiving the wall, (${condition.letter}) ${escaped(condition.title)}: mean " +
        "${scale.text(analysis.mean, scale.decimals(mean))} ${scale.unit}</summary>\n$table</details>"
}

private fun row(effect: Effect, plan: Plan, scale: TimeScale): List<String> = listOf(
    words(effect.source), level(effect, plan), scale.text(effect.value, scale.decimals(effect.interval)),
    if (effect.interval.low.isInfinite()) "unknown: one replication" else scale.text(effect.interval),
    if (effect.isSignificant) "yes" else "no",
)

private fun level(effect: Effect, plan: Plan): String = effect.levels.single().let {
    when (effect.source) {
        Source.A -> "${plan.limits[it]} cm"
        Source.B -> "${plan.intervals[it]} ms"
        else -> words(View.entries[it])
    }
}
