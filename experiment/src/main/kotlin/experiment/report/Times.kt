package experiment.report

import experiment.analysis.Interval

/**
 * The unit of the times in a table or a figure: seconds, or milliseconds if all times are below one second.
 *
 * @property word the unit's name in the plural
 * @property perSecond the number of units in a second
 * @property fewDecimals the number of decimals for a time without a known interval
 */
internal enum class TimeScale(val unit: String, val word: String, val perSecond: Int, val fewDecimals: Int, private val mostDecimals: Int) {
    SECONDS("s", "seconds", 1, 2, 3), MILLISECONDS("ms", "milliseconds", 1000, 0, 1);

    fun text(seconds: Double, decimals: Int = fewDecimals): String = rounded(seconds * perSecond, decimals)

    /** Writes an interval, given in seconds, in this unit and with its meaningful decimals. */
    fun text(seconds: Interval): String = range(of(seconds), decimals(seconds))

    fun decimals(seconds: Interval): Int = if (seconds.isKnown) minOf(of(seconds).decimals, mostDecimals) else fewDecimals

    private val Interval.isKnown get() = low.isFinite() && high.isFinite()

    private fun of(seconds: Interval) = Interval(seconds.low * perSecond, seconds.high * perSecond)

    companion object {
        /** Returns the scale that suits all of [seconds]. Infinite times, which stand for unknown ones, do not count. */
        fun of(seconds: Collection<Double>): TimeScale {
            val known = seconds.filter(Double::isFinite)
            return if (known.isNotEmpty() && known.all { it < 1 && it > -1 }) MILLISECONDS else SECONDS
        }
    }
}

/** Writes a measured time in a sentence, with only two digits, since there are few runs: `58 ms`, `1.2 s`. */
internal fun time(seconds: Double): String = TimeScale.of(listOf(seconds)).let { "${twoDigits(seconds * it.perSecond)} ${it.unit}" }

/** Writes [interval] as `0.41 to 0.43`. */
internal fun range(interval: Interval, decimals: Int): String = "${rounded(interval.low, decimals)} to ${rounded(interval.high, decimals)}"
