package argo.ros.bridge

import java.util.concurrent.TimeUnit

/**
 * The time of a simulator, as its topic `/clock` shows it. A simulator's time may run at any speed, stop, and jump. Safe for use by several
 * threads.
 */
internal class SimulatedClock {
    private class Sample(val simNanos: Long, val atNanos: Long)

    private val samples = ArrayDeque<Sample>()

    /** The newest time that the simulator has shown, and the platform's time of that moment; null: it has shown none. */
    @get:Synchronized
    val newest: Pair<Long, Long>? get() = samples.lastOrNull()?.let { it.simNanos to it.atNanos }

    /**
     * Notes that the simulator showed [simNanos] at [atNanos], a time of the platform's clock. If the simulator's time goes back, forgets
     * all earlier samples.
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
     * Adds a sample for the time at which the simulator's clock went on. A silence has ended with [simNanos] at [atNanos]: the clock is
     * assumed to have stopped at first, and then to have run at its previous speed.
     */
    private fun standUntil(last: Sample, simNanos: Long, atNanos: Long) {
        val began = atNanos - ((simNanos - last.simNanos) / speed(samples.size - SHORT)).toLong()
        if (began > last.atNanos) samples.addLast(Sample(last.simNanos, began))
    }

    /** Returns the speed since sample number [from], in simulated seconds per second; 1 while the speed is not known. */
    private fun speed(from: Int): Double {
        val (first, last) = samples[maxOf(0, from)] to samples.last()
        val took = last.atNanos - first.atNanos
        return if (took <= 0 || last.simNanos == first.simNanos) 1.0 else (last.simNanos - first.simNanos).toDouble() / took
    }

    /**
     * Returns the last time of the platform's clock at which the simulator showed [stampNanos], as known at [nowNanos]. The result is in
     * the future if the simulator has yet to show that time; but it is [nowNanos] if the simulator's clock has stopped. Null: the simulator
     * has shown no time.
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
        /** The interval between requested samples, in ms. A change of speed is noticed after at most this time. */
        const val INTERVAL_MS = 50

        private const val KEPT = 1_200

        /** The number of samples from which the present speed follows. */
        private const val SHORT = 10

        /** A clock that has been silent for this time has stopped. */
        private val STANDS_NANOS = TimeUnit.SECONDS.toNanos(1)
    }
}
