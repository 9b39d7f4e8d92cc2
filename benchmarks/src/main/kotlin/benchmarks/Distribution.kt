package benchmarks

import java.util.Locale

class Distribution(nanos: LongArray) {
    private val sorted = nanos.sortedArray()

    val size: Int get() = sorted.size

    /**
     * Returns the quantile for [share], from 0 to 1, in ms. The share [share] of the durations is not longer than the result. Returns NaN
     * without durations.
     */
    fun ms(share: Double): Double = if (sorted.isEmpty()) Double.NaN else sorted[((sorted.size - 1) * share).toInt()] / 1e6
}

/** Formats [values] like [String.format], with a decimal point in every language. */
internal fun figures(format: String, vararg values: Any?): String = format.format(Locale.ROOT, *values)
