package argo.ros.bridge

import java.util.concurrent.TimeUnit

/**
 * A simulator's time, according to its topic `/clock`. A simulator's time may run at any speed, stop, and jump. Safe for use by several
 * threads.
 */
internal class SimulatedClock {
    private class Sample(val simNanos: Long, val atNanos: Long)

    private val samples = ArrayDeque<Sample>()

    /** The newest simulated time and the platform time of its message; null before the first message. */
    @get:Synchronized
    val newest: Pair<Long, Long>? get() = samples.lastOrNull()?.let { it.simNanos to it.atNanos }

    /**
     * Stores that the simulator showed [simNanos] at the platform time [atNanos]. If simulated time goes back, forgets all earlier samples.
     */
    @Synchronized
    fun show(simNanos: Long, atNanos: Long) {
        val last = samples.lastOrNull()
        if (last != null && simNanos < last.simNanos) samples.clear()
        else if (last != null && atNanos - last.atNanos > STANDS_NANOS) standUntil(last, simNanos, atNanos)
        samples.addLast(Sample(simNanos, atNanos))
        if (samples.size > KEPT) samples.removeFirst()
    }

    /**
     * Adds a sample for the time at which a stopped clock continued. The clock is assumed to have stopped first, and then to have run at
     * its previous speed until [simNanos] at [atNanos].
     */
    private fun standUntil(last: Sample, simNanos: Long, atNanos: Long) {
        val began = atNanos - ((simNanos - last.simNanos) / speed(samples.size - SHORT)).toLong()
        if (began > last.atNanos) samples.addLast(Sample(last.simNanos, began))
    }

    /** Returns the speed since sample number [from], in simulated seconds per second. Returns 1 if the speed is not known. */
    private fun speed(from: Int): Double {
        val (first, last) = samples[maxOf(0, from)] to samples.last()
        val took = last.atNanos - first.atNanos
        return if (took <= 0 || last.simNanos == first.simNanos) 1.0 else (last.simNanos - first.simNanos).toDouble() / took
    }

    /**
     * Returns the last platform time at which the simulator showed [stampNanos], as known at [nowNanos]. If the simulator has not shown
     * that time yet, the result is in the future. If the simulator's clock has stopped, the result is then [nowNanos]. Returns null if the
     * simulator has shown no time.
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
        /** The interval between requested samples, in ms. A change of speed is noticed after this time at the latest. */
        const val INTERVAL_MS = 50

        private const val KEPT = 1_200

        /** The number of newest samples that determine the current speed. */
        private const val SHORT = 10

        /** A clock counts as stopped after this silence. */
        private val STANDS_NANOS = TimeUnit.SECONDS.toNanos(1)
    }
}
