package benchmarks

import java.util.Locale

/** A sample of durations, in ns, with its quantiles. */
class Distribution(nanos: LongArray) {
    private val sorted = nanos.sortedArray()

    /** The number of durations. */
    val size: Int get() = sorted.size

    /** Returns the duration in ms that a [share] of the durations, 0 to 1, does not exceed; NaN: there are none. */
    fun ms(share: Double): Double = if (sorted.isEmpty()) Double.NaN else sorted[((sorted.size - 1) * share).toInt()] / 1e6
}

/** Returns [values] in the [format] of [String.format], with a decimal point in every language. */
internal fun figures(format: String, vararg values: Any?): String = format.format(Locale.ROOT, *values)
