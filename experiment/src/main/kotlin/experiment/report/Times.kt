package experiment.report

import experiment.analysis.Interval

/**
 * The unit for times in a table or figure. The unit is milliseconds if all times are below one second, and otherwise seconds.
 *
 * @property word the unit's name in the plural
 * @property perSecond the number of units in a second
 * @property fewDecimals the decimals of a time without a known interval
 */
internal enum class TimeScale(val unit: String, val word: String, val perSecond: Int, val fewDecimals: Int, private val mostDecimals: Int) {
    SECONDS("s", "seconds", 1, 2, 3), MILLISECONDS("ms", "milliseconds", 1000, 0, 1);

    fun text(seconds: Double, decimals: Int = fewDecimals): String = rounded(seconds * perSecond, decimals)

    fun text(seconds: Interval): String = range(of(seconds), decimals(seconds))

    fun decimals(seconds: Interval): Int = if (seconds.isKnown) minOf(of(seconds).decimals, mostDecimals) else fewDecimals

    private val Interval.isKnown get() = low.isFinite() && high.isFinite()

    private fun of(seconds: Interval) = Interval(seconds.low * perSecond, seconds.high * perSecond)

    companion object {
        /** Returns the best scale for [seconds]. Infinite times stand for unknown ones, and do not count. */
        fun of(seconds: Collection<Double>): TimeScale {
            val known = seconds.filter(Double::isFinite)
            return if (known.isNotEmpty() && known.all { it < 1 && it > -1 }) MILLISECONDS else SECONDS
        }
    }
}

/** Writes a measured time with two digits for a sentence, such as `58 ms` or `1.2 s`. Few runs allow no more digits. */
internal fun time(seconds: Double): String = TimeScale.of(listOf(seconds)).let { "${twoDigits(seconds * it.perSecond)} ${it.unit}" }

internal fun range(interval: Interval, decimals: Int): String = "${rounded(interval.low, decimals)} to ${rounded(interval.high, decimals)}"
