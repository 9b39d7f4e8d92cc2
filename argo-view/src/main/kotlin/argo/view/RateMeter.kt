package argo.view

import java.util.concurrent.TimeUnit

/** Measures rates of events over the last [WINDOW_NANOS] ns. Not safe for use by several threads. */
internal class RateMeter {
    private val samples = ArrayDeque<Pair<Long, Counts>>()

    /** Returns the rates at [now]; null if the measured time is too short. [counts] are the numbers of events until [now]. */
    fun rates(now: Long, counts: Counts): Rates? {
        samples += now to counts
        while (samples.size > 2 && now - samples[1].first >= WINDOW_NANOS) samples.removeFirst()
        val (begin, before) = samples.first()
        val seconds = (now - begin) / 1e9
        if (now - begin < MIN_NANOS) return null
        fun rate(count: (Counts) -> Long) = (count(counts) - count(before)) / seconds
        return Rates(rate(Counts::frames), rate(Counts::handOvers), rate(Counts::commands), rate(Counts::cycles))
    }

    private companion object {
        val WINDOW_NANOS = TimeUnit.SECONDS.toNanos(2)
        val MIN_NANOS = TimeUnit.MILLISECONDS.toNanos(500)
    }
}
