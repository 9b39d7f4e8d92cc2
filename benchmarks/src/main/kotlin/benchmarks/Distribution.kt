package benchmarks

/** A sample of durations, with its quantiles. [nanos] are in ns. */
class Distribution(nanos: LongArray) {
    private val sorted = nanos.sortedArray()

    /** The number of durations. */
    val size: Int get() = sorted.size

    /** Returns the duration in ms that a [share] of them, 0 to 1, does not exceed; NaN if there are none. */
    fun ms(share: Double): Double = if (sorted.isEmpty()) Double.NaN else sorted[((sorted.size - 1) * share).toInt()] / 1e6

    /** Returns the figures of a table's row: median, 90th and 99th percentile and the longest, in ms. */
    fun figures(): Map<String, Double> = mapOf("median" to ms(0.5), "p90" to ms(0.9), "p99" to ms(0.99), "longest" to ms(1.0))
}
