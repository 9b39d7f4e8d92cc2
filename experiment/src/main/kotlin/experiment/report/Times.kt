package experiment.report

import java.math.BigDecimal
import java.math.MathContext
import java.util.Locale
import kotlin.math.ceil
import kotlin.math.log10

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

private const val MAX_DECIMALS = 3
private const val ONE_DIGIT = 3.55

/**
 * The number of meaningful decimals of an interval, from 0 to 3. Half the width keeps two digits if they are 35 or less, and otherwise one.
 * The source is the Particle Data Group (Review of Particle Physics, introduction, section 5.3).
 */
internal val Interval.decimals: Int
    get() = if (high > low) ceil(log10(ONE_DIGIT / ((high - low) / 2))).toInt().coerceIn(0, MAX_DECIMALS) else MAX_DECIMALS

/** Writes [value] with this number of [decimals]. A value that rounds to 0 is written without a sign. */
internal fun rounded(value: Double, decimals: Int): String =
    String.format(Locale.ROOT, "%.${decimals}f", value).let { if (it.toDouble() == 0.0) it.removePrefix("-") else it }

internal fun whole(value: Double): String = rounded(value, 0)
internal fun one(value: Double): String = rounded(value, 1)
internal fun three(value: Double): String = rounded(value, 3)

internal fun twoDigits(value: Double): String = BigDecimal(value).round(MathContext(2)).toPlainString()
