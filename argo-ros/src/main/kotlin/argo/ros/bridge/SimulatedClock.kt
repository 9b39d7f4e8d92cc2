package argo.ros.bridge

import java.util.concurrent.TimeUnit

/**
 * The time of a simulator as its topic `/clock` shows it, which may run at any speed, stop, and jump. Safe for use by several threads.
 */
internal class SimulatedClock {
    private class Sample(val simNanos: Long, val atNanos: Long)

    private val samples = ArrayDeque<Sample>()

    /** The newest time that it has shown, and the platform's time then; null: it has shown none. */
    @get:Synchronized
    val newest: Pair<Long, Long>? get() = samples.lastOrNull()?.let { it.simNanos to it.atNanos }

    /** Notes that it shows [simNanos] at [atNanos], by the platform's clock. If the time goes back, all earlier samples are forgotten. */
    @Synchronized
    fun show(simNanos: Long, atNanos: Long) {
        val last = samples.lastOrNull()
        if (last != null && simNanos < last.simNanos) samples.clear()
        else if (last != null && atNanos - last.atNanos > STANDS_NANOS) standUntil(last, simNanos, atNanos)
        samples.addLast(Sample(simNanos, atNanos))
        if (samples.size > KEPT) samples.removeFirst()
    }

    /** Fills the gap before [simNanos] at [atNanos]: the clock stood while it was silent, then went on at its speed. */
    private fun standUntil(last: Sample, simNanos: Long, atNanos: Long) {
        val began = atNanos - ((simNanos - last.simNanos) / speed(samples.size - SHORT)).toLong()
        if (began > last.atNanos) samples.addLast(Sample(last.simNanos, began))
    }

    /** Returns its speed from the sample [from] on: its seconds per second; 1 while that is not known. */
    private fun speed(from: Int): Double {
        val (first, last) = samples[maxOf(0, from)] to samples.last()
        val took = last.atNanos - first.atNanos
        return if (took <= 0 || last.simNanos == first.simNanos) 1.0 else (last.simNanos - first.simNanos).toDouble() / took
    }

    /**
     * Returns the last time, by the platform's clock and as seen at [nowNanos], at which it showed [stampNanos]; it is later than
     * [nowNanos] for a time that is still to come. A standing clock shows its time now. Null: it has shown no time.
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
        /** The interval at which it is asked for, in ms: a change of its speed is known that much later. */
        const val INTERVAL_MS = 50

        /** The number of samples that are kept: a minute's. */
        private const val KEPT = 1_200

        /** The number of samples that give the present speed. */
        private const val SHORT = 10

        /** A clock that has been silent for this time stands. */
        private val STANDS_NANOS = TimeUnit.SECONDS.toNanos(1)
    }
}
