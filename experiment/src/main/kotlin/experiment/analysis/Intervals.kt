package experiment.analysis

import org.apache.commons.math3.distribution.BinomialDistribution
import org.apache.commons.math3.stat.interval.WilsonScoreInterval

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
