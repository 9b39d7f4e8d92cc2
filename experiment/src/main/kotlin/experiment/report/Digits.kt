package experiment.report

import experiment.analysis.Interval
import java.math.BigDecimal
import java.math.MathContext
import java.util.Locale
import kotlin.math.ceil
import kotlin.math.log10

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
