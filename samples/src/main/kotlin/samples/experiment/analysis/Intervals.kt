package samples.experiment.analysis

import org.apache.commons.math3.distribution.BinomialDistribution
import org.apache.commons.math3.stat.interval.WilsonScoreInterval
import kotlin.math.ceil
import kotlin.math.log10
import kotlin.random.Random

/** How sure the intervals of the report are. */
internal const val CONFIDENCE = 0.95

/** A confidence interval at [CONFIDENCE]. */
internal data class Interval(val low: Double, val high: Double) {
    /** How many decimals it leaves a meaning: the last is the first digit of its width. From 0 to 3. */
    val decimals: Int get() = if (high > low) ceil(-log10(high - low)).toInt().coerceIn(0, MAX_DECIMALS) else MAX_DECIMALS

    private companion object {
        const val MAX_DECIMALS = 3
    }
}

/**
 * The interval of a probability of which [found] of [of] runs had it: Wilson's score interval, which L. D. Brown, T. T. Cai and
 * A. DasGupta, Interval Estimation for a Binomial Proportion, Statistical Science 16 (2001), recommend for few runs.
 *
 * @param of at least 1
 */
internal fun proportionInterval(found: Int, of: Int): Interval =
    WilsonScoreInterval().createInterval(of, found, CONFIDENCE).let { Interval(it.lowerBound, it.upperBound) }

/**
 * The interval of the median of what [values] are a sample of: two of them, whatever the distribution (H. A. David and H. N. Nagaraja,
 * Order Statistics, Wiley 2003, section 7.1). Null: there are fewer than six, of which even the least and the greatest are not far enough
 * apart.
 */
internal fun medianInterval(values: List<Double>): Interval? {
    val below = BinomialDistribution(null, values.size, 0.5) // how many of them are less than the median
    val rank = (0 until values.size / 2).takeWhile { below.cumulativeProbability(it) <= (1 - CONFIDENCE) / 2 }.lastOrNull() ?: return null
    val sorted = values.sorted()
    return Interval(sorted[rank], sorted[sorted.size - 1 - rank])
}

/**
 * The intervals of the shares of factors and interactions in [analysis], by percentiles of [RESAMPLES] experiments in which each response is
 * the mean of its cell and an error drawn from those of all runs: A. C. Davison and D. V. Hinkley, Bootstrap Methods and their Application,
 * Cambridge 1997, section 6.2. There are none where there is one replication, which has no error. The share of the error has none: an
 * experiment with errors drawn anew has them twice, in the means of its cells too, so too much of it is effects.
 */
internal fun shareIntervals(analysis: Factorial, random: Random): Map<Source, Interval> {
    if (analysis.errorFreedom == 0) return emptyMap()
    val resamples = List(RESAMPLES) { analysis.resampled(random) }
    return Source.entries.associateWith { source -> percentiles(resamples.map { it.share(source) }) }
}

private fun percentiles(values: List<Double>): Interval {
    val sorted = values.sorted()
    val outside = (sorted.size * (1 - CONFIDENCE) / 2).toInt()
    return Interval(sorted[outside], sorted[sorted.size - 1 - outside])
}

private const val RESAMPLES = 1000
