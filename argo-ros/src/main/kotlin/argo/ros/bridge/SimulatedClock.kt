package argo.ros.bridge

import java.util.concurrent.TimeUnit

/**
 * The time of a simulator as its topic `/clock` shows it, which may run at any speed, stop, and jump. Safe for use by several threads.
 */
internal class SimulatedClock {
    private class Sample(val simNanos: Long, val atNanos: Long)

    private val samples = ArrayDeque<Sample>()

    /** The newest time that it has shown, and when by the platform's clock; null: it has shown none. */
    @get:Synchronized
    val newest: Pair<Long, Long>? get() = samples.lastOrNull()?.let { it.simNanos to it.atNanos }

    /** It shows [simNanos] at [atNanos], by the platform's clock. A time before the one shown last is a new beginning. */
    @Synchronized
    fun show(simNanos: Long, atNanos: Long) {
        val last = samples.lastOrNull()
        if (last != null && simNanos < last.simNanos) samples.clear()
        else if (last != null && atNanos - last.atNanos > STANDS_NANOS) standUntil(last, simNanos, atNanos)
        samples.addLast(Sample(simNanos, atNanos))
        if (samples.size > KEPT) samples.removeFirst()
    }

    /** A clock that says nothing stood, and went on at its speed to show [simNanos] at [atNanos]. */
    private fun standUntil(last: Sample, simNanos: Long, atNanos: Long) {
        val began = atNanos - ((simNanos - last.simNanos) / speed(samples.size - SHORT)).toLong()
        if (began > last.atNanos) samples.addLast(Sample(last.simNanos, began))
    }

    /** The seconds that it shows in one, from the sample [from] on; 1 while that is not known. */
    private fun speed(from: Int): Double {
        val (first, last) = samples[maxOf(0, from)] to samples.last()
        val took = last.atNanos - first.atNanos
        return if (took <= 0 || last.simNanos == first.simNanos) 1.0 else (last.simNanos - first.simNanos).toDouble() / took
    }

    /**
     * When it showed [stampNanos] last, by the platform's clock and as seen at [nowNanos]: a time that it has not shown yet may be later.
     * As long as it stands, it shows its time now. Null: it has shown no time.
     */
    @Synchronized
    fun whenShown(stampNanos: Long, nowNanos: Long): Long? {
        val last = samples.lastOrNull() ?: return null
        if (stampNanos >= last.simNanos) return if (stands(last, nowNanos)) nowNanos else at(last, stampNanos, speed(samples.size - SHORT))
        val before = samples.indexOfLast { it.simNanos <= stampNanos }
        if (before < 0) return at(samples.first(), stampNanos, speed(0))
        val (one, next) = samples[before] to samples[before + 1]
        return at(one, stampNanos, (next.simNanos - one.simNanos).toDouble() / (next.atNanos - one.atNanos))
    }

    private fun stands(last: Sample, nowNanos: Long): Boolean {
        val before = samples.getOrNull(samples.size - 2)
        return nowNanos - last.atNanos > STANDS_NANOS || before?.simNanos == last.simNanos
    }

    private fun at(sample: Sample, stampNanos: Long, speed: Double) = sample.atNanos + ((stampNanos - sample.simNanos) / speed).toLong()

    companion object {
        /** How often it is asked for, in ms: so much later than it changes is a change of its speed known. */
        const val INTERVAL_MS = 50

        /** How many samples are kept: those of a minute. */
        private const val KEPT = 1_200

        /** How many samples the present speed is taken from. */
        private const val SHORT = 10

        /** A clock that has shown nothing for so long stands. */
        private val STANDS_NANOS = TimeUnit.SECONDS.toNanos(1)
    }
}
