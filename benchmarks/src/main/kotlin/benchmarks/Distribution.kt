package benchmarks

import java.util.Locale

/** A sample of durations, in ns, with its quantiles. */
class Distribution(nanos: LongArray) {
    private val sorted = nanos.sortedArray()

    /** The number of durations. */
    val size: Int get() = sorted.size

    /** Returns the quantile for [share], from 0 to 1, in ms: this share of the durations does not exceed it. NaN: no durations. */
    fun ms(share: Double): Double = if (sorted.isEmpty()) Double.NaN else sorted[((sorted.size - 1) * share).toInt()] / 1e6
}

/** Formats [values] as [String.format] does, but with a decimal point in every language. */
internal fun figures(format: String, vararg values: Any?): String = format.format(Locale.ROOT, *values)
