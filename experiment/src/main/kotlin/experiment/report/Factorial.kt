package experiment.report

import org.apache.commons.math3.distribution.TDistribution
import kotlin.math.abs
import kotlin.math.sqrt

/** A source of variation: one of three factors, or an interaction of two or three factors. The first factor is A. */
internal enum class Source(val factors: Set<Int>) {
    A(setOf(0)), B(setOf(1)), C(setOf(2)), AB(setOf(0, 1)), AC(setOf(0, 2)), BC(setOf(1, 2)), ABC(setOf(0, 1, 2)),
}

/**
 * The effect of one combination of levels of the factors in [source]. The effect is the mean response there, minus the total mean and the
 * effects of fewer of these factors. [levels] has the level of each factor, from 0, in the order of the factors.
 */
internal class Effect(val source: Source, val levels: List<Int>, val value: Double, val interval: Interval) {
    val isSignificant: Boolean get() = interval.low > 0 || interval.high < 0
}

/**
 * The analysis of a full factorial experiment with three factors and replications. The source is R. Jain, The Art of Computer Systems
 * Performance Analysis, Wiley 1991, chapters 22 and 23.
 *
 * The model is `y = mean + A + B + C + AB + AC + BC + ABC + error`. The effects add up to 0 over the levels of each factor. The share of a
 * source is its sum of squares divided by the total sum of squares.
 *
 * `responses[i][j][k][r]` is the response in replication r at level i of A, j of B and k of C. All cells have equally many responses, at
 * least one. With one response, the error cannot be estimated. The share of the error is then 0, and the confidence intervals are infinite.
 */
internal class Factorial(private val responses: List<List<List<List<Double>>>>) {
    private val sizes = listOf(responses.size, responses.first().size, responses.first().first().size)

    val replications = responses.first().first().first().size

    init {
        val isRegular = responses.all { b -> b.size == sizes[1] && b.all { c -> c.size == sizes[2] && c.all { it.size == replications } } }
        require(replications > 0 && isRegular) {
            "a full factorial experiment has all combinations of levels, each with the same number of replications"
        }
        require(sizes.all { it > 0 }) { "each factor has a level" }
    }

    private val cells: List<List<Int>> = sizes.fold(listOf(emptyList())) { cells, size ->
        cells.flatMap { cell -> (0 until size).map { cell + it } }
    }

    private fun at(cell: List<Int>) = responses[cell[0]][cell[1]][cell[2]]

    val count = cells.size * replications

    /** Smaller values are rounding errors of sums. */
    private val rounding = ROUNDING * cells.maxOf { cell -> at(cell).maxOf(::abs) }

    private fun squares(sum: Double): Double = if (sum > count * rounding * rounding) sum else 0.0

    val mean: Double = cells.sumOf { at(it).sum() } / count

    /** The total sum of squares: the variation of the responses around [mean]. */
    val total: Double = squares(cells.sumOf { cell -> at(cell).sumOf { (it - mean) * (it - mean) } })

    val error: Double = squares(cells.sumOf { cell -> at(cell).average().let { mean -> at(cell).sumOf { (it - mean) * (it - mean) } } })

    val errorFreedom = cells.size * (replications - 1)

    private val effects: Map<Source, Map<List<Int>, Double>> = buildMap {
        for (source in Source.entries.sortedBy { it.factors.size }) {
            val lower = filterKeys { it.factors.all(source.factors::contains) }
            val effect = cells.groupBy { cell -> cell.of(source) }.mapValues { (_, group) ->
                val marginal = group.sumOf { at(it).average() } / group.size
                (marginal - mean - lower.entries.sumOf { (below, values) -> values.getValue(group.first().of(below)) })
                    .takeIf { abs(it) > rounding } ?: 0.0
            }
            put(source, effect)
        }
    }

    private fun List<Int>.of(source: Source) = source.factors.map { this[it] }

    fun squares(source: Source): Double =
        effects.getValue(source).values.sumOf { it * it } * count / source.factors.fold(1) { n, f -> n * sizes[f] }

    fun freedom(source: Source): Int = source.factors.fold(1) { n, f -> n * (sizes[f] - 1) }

    /** Returns the share of [source] in the variation, from 0 to 1. Returns 0 if nothing varies. */
    fun share(source: Source): Double = if (total > 0) squares(source) / total else 0.0

    val errorShare: Double get() = if (total > 0) error / total else 0.0

    fun effects(source: Source, confidence: Double): List<Effect> {
        val margin = margin(freedom(source), confidence)
        return effects.getValue(source).map { (levels, value) -> Effect(source, levels, value, Interval(value - margin, value + margin)) }
    }

    fun mean(confidence: Double): Interval = margin(1, confidence).let { Interval(mean - it, mean + it) }

    /** Returns half the width of the confidence interval of an effect with this [freedom]. */
    private fun margin(freedom: Int, confidence: Double): Double {
        if (errorFreedom == 0) return Double.POSITIVE_INFINITY
        val deviation = sqrt(error / errorFreedom * freedom / count)
        return TDistribution(errorFreedom.toDouble()).inverseCumulativeProbability((1 + confidence) / 2) * deviation
    }

    private companion object {
        /** A number below this part of the largest response counts as a rounding error. A double has sixteen digits. */
        const val ROUNDING = 1e-12
    }
}
