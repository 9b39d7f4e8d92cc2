package experiment.report

import experiment.analysis.Interval

/**
 * The unit of the times in a table or a figure: seconds, or milliseconds where all are below one second.
 *
 * @property unit its symbol
 * @property word its name in the plural
 * @property perSecond how many of it are a second
 * @property fewDecimals of a time whose interval is not known
 */
internal enum class TimeScale(val unit: String, val word: String, val perSecond: Int, val fewDecimals: Int, private val mostDecimals: Int) {
    SECONDS("s", "seconds", 1, 2, 3), MILLISECONDS("ms", "milliseconds", 1000, 0, 1);

    /** [seconds] in this unit with so many [decimals]. */
    fun text(seconds: Double, decimals: Int = fewDecimals): String = rounded(seconds * perSecond, decimals)

    /** An interval of seconds in this unit, with as many decimals as it leaves a meaning. */
    fun text(seconds: Interval): String = range(of(seconds), decimals(seconds))

    /** How many decimals an interval of [seconds] leaves a meaning in this unit. */
    fun decimals(seconds: Interval): Int = if (seconds.isKnown) minOf(of(seconds).decimals, mostDecimals) else fewDecimals

    private val Interval.isKnown get() = low.isFinite() && high.isFinite()

    private fun of(seconds: Interval) = Interval(seconds.low * perSecond, seconds.high * perSecond)

    companion object {
        /** The scale for all of [seconds]; infinite ones, which are not known, do not count. */
        fun of(seconds: Collection<Double>): TimeScale {
            val known = seconds.filter(Double::isFinite)
            return if (known.isNotEmpty() && known.all { it < 1 && it > -1 }) MILLISECONDS else SECONDS
        }
    }
}

/** A measured time in a sentence, with the two digits that few runs carry: `58 ms`, `1.2 s`. */
internal fun time(seconds: Double): String = TimeScale.of(listOf(seconds)).let { "${twoDigits(seconds * it.perSecond)} ${it.unit}" }

/** [interval] as `0.41 to 0.43`. */
internal fun range(interval: Interval, decimals: Int): String = "${rounded(interval.low, decimals)} to ${rounded(interval.high, decimals)}"
