package experiment.report

import org.apache.commons.math3.distribution.BinomialDistribution
import org.apache.commons.math3.distribution.GammaDistribution
import org.apache.commons.math3.random.RandomGenerator
import org.apache.commons.math3.random.Well19937c
import org.apache.commons.math3.stat.interval.WilsonScoreInterval
import kotlin.math.sqrt

internal data class Squares(val sum: Double, val freedom: Int) {
    operator fun plus(other: Squares) = Squares(sum + other.sum, freedom + other.freedom)
}

/**
 * The intervals, at [CONFIDENCE], of the shares for infinitely many runs of each combination.
 *
 * The errors are assumed to be normal and independent, with one variance v. The share of a source is s / (t + v). s is the mean square of
 * its effects, and t the mean square of all effects. In a sample, the measured effects contain errors. The shares of sources are therefore
 * larger, and the share of the error is smaller. A small share in the sample can lie outside its interval.
 *
 * @property sources the intervals of factors and interactions
 */
internal class ShareIntervals(val sources: Map<Source, Interval>, val error: Interval)

/** Returns the intervals of the shares in [analysis]. Returns null for one replication, since the error is then not known. */
internal fun shareIntervals(analysis: Factorial, seed: Long, draws: Int = DRAWS): ShareIntervals? {
    if (analysis.errorFreedom == 0) return null
    val pivots = SharePivots(Squares(analysis.error, analysis.errorFreedom), analysis.count, Well19937c(seed), draws)
    val squares = Source.entries.associateWith { Squares(analysis.squares(it), analysis.freedom(it)) }
    fun sum(sources: Collection<Source>) = sources.map(squares::getValue).fold(NOTHING, Squares::plus)
    val effects = pivots.interval(sum(Source.entries), NOTHING, CONFIDENCE)
    return ShareIntervals(
        squares.mapValues { (source, own) -> pivots.interval(own, sum(Source.entries - source), CONFIDENCE) },
        if (analysis.total == 0.0) Interval(0.0, 0.0) else Interval(1 - effects.high, 1 - effects.low),
    )
}

/**
 * Generalized confidence intervals of shares. The sources are S. Weerahandi, Generalized Confidence Intervals, JASA 88, 1993, and J.
 * Hannig, H. Iyer and P. Patterson, Fiducial Generalized Confidence Intervals, JASA 101, 2006.
 *
 * A source's sum of squares divided by the errors' variance is noncentral chi-squared. A share is `own / (own + others + count)`. `own` is
 * the noncentrality of one source, `others` that of the other sources, and [count] the number of responses.
 *
 * Random numbers replace the unknown noncentralities. The probability that such a number is at most x equals another probability: that a
 * sum of squares with noncentrality x exceeds the observed one. [error] divided by a chi-squared random number replaces the variance. The
 * ends of the interval are two percentiles of the drawn shares.
 *
 * Without other effects, the noncentral F distribution gives an equal interval (J. H. Steiger, Beyond the F Test, Psychological Methods 9,
 * 2004). With several effects, it gives none.
 *
 * @param error the errors' sum of squares, with at least one degree of freedom
 */
internal class SharePivots(
    private val error: Squares, private val count: Int, private val random: RandomGenerator, private val draws: Int,
) {
    fun interval(own: Squares, others: Squares, confidence: Double): Interval {
        if (error.sum == 0.0) return (own.sum / (own.sum + others.sum)).let { if (it.isNaN()) Interval(0.0, 0.0) else Interval(it, it) }
        val errors = chiSquared(error.freedom)
        val part = noncentrality(own.freedom)
        val rest = noncentrality(others.freedom)
        val shares = DoubleArray(draws) {
            val precision = errors() / error.sum
            val drawn = part(own.sum * precision)
            drawn / (drawn + rest(others.sum * precision) + count)
        }
        return percentiles(shares, confidence)
    }

    /**
     * Returns a function that draws random noncentralities for an observed chi-squared number with [freedom]. Each draw subtracts a central
     * chi-squared number from the observed one. The result is 0 if the remainder is negative. For other remainders, the result is a
     * noncentral chi-squared number with two degrees of freedom. The remainder is its noncentrality.
     */
    private fun noncentrality(freedom: Int): (Double) -> Double {
        val central = chiSquared(freedom)
        return { seen ->
            val beyond = seen - central()
            if (beyond <= 0) 0.0 else square(sqrt(beyond) + random.nextGaussian()) + square(random.nextGaussian())
        }
    }

    private fun chiSquared(freedom: Int): () -> Double {
        if (freedom == 0) return { 0.0 }
        val half = GammaDistribution(random, freedom / 2.0, 1.0)
        return { 2 * half.sample() }
    }

    private fun square(value: Double) = value * value
}

private fun percentiles(values: DoubleArray, confidence: Double): Interval {
    values.sort()
    val outside = (values.size * (1 - confidence) / 2).toInt()
    return Interval(values[outside], values[values.size - 1 - outside])
}

private val NOTHING = Squares(0.0, 0)

/** The number of draws. With this number, the ends of an interval are within 0.2 of the wanted percentiles. */
private const val DRAWS = 10_000

internal const val CONFIDENCE = 0.95

internal data class Interval(val low: Double, val high: Double)

/**
 * Returns the confidence interval for the probability of an event that [found] of [of] runs had. The interval is Wilson's score interval,
 * which is recommended for few runs. The source is L. D. Brown, T. T. Cai and A. DasGupta, Interval Estimation for a Binomial Proportion,
 * Statistical Science 16 (2001). [of] is at least 1.
 */
internal fun proportionInterval(found: Int, of: Int): Interval =
    WilsonScoreInterval().createInterval(of, found, CONFIDENCE).let { Interval(it.lowerBound, it.upperBound) }

/**
 * Returns the interval of a population's median from its sample [values]. Its ends are two of [values], whatever the distribution (H. A.
 * David and H. N. Nagaraja, Order Statistics, Wiley 2003, section 7.1). Returns null for fewer than six values. Even their least and
 * greatest do not enclose the median often enough.
 */
internal fun medianInterval(values: List<Double>): Interval? {
    val below = BinomialDistribution(null, values.size, 0.5) // the number of values below the median
    val rank = (0 until values.size / 2).takeWhile { below.cumulativeProbability(it) <= (1 - CONFIDENCE) / 2 }.lastOrNull() ?: return null
    val sorted = values.sorted()
    return Interval(sorted[rank], sorted[sorted.size - 1 - rank])
}
