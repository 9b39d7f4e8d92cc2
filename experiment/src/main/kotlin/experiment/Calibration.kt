package experiment

import java.lang.management.ManagementFactory
import java.util.Locale
import kotlin.math.sqrt

/**
 * Compares the speed of this computer with a single-board computer of 2016, by the work of `sysbench cpu`: counting the primes up to 10,000
 * by trial division.
 *
 * Only whole-number division by compiled code in one thread is compared, not caches and memory. So the factor is a stated assumption, and a
 * parameter of the experiment.
 */
internal object Calibration {
    /**
     * Events a second of a Raspberry Pi 3 Model B (February 2016, Cortex-A53 at 1.2 GHz). The published figure is 687.45 for the 3 Model
     * B+, the same core at 1.4 GHz, one thread, sysbench 1.0.20 (https://leoncode.co.uk/articles/raspberry-pi-benchmarks). This constant is
     * 1.2 / 1.4 of that figure.
     */
    const val REFERENCE_EVENTS_PER_S = 589.2

    private const val MOST = 10_000L
    private const val ROUNDS = 5
    private const val ROUND_NANOS = 300_000_000L

    /** Does the work of one event: counts the primes up to [most]. */
    fun primes(most: Long): Int {
        var primes = 0
        for (number in 2..most) {
            val root = sqrt(number.toDouble()).toLong()
            var divisor = 2L
            while (divisor <= root && number % divisor != 0L) divisor++
            if (divisor > root) primes++
        }
        return primes
    }

    /**
     * Measures the events a second of this computer in 1.5 s. Takes the best of some rounds, since other programs can only slow this one
     * down. [nanoTime] is the time that the calling thread has worked, in ns; the time of other threads does not count.
     */
    fun eventsPerSecond(nanoTime: () -> Long = ManagementFactory.getThreadMXBean()::getCurrentThreadCpuTime): Double = (1..ROUNDS).maxOf {
        val start = nanoTime()
        var events = 0
        do {
            check(primes(MOST) == PRIMES) { "this computer cannot count" }
            events++
        } while (nanoTime() - start < ROUND_NANOS)
        events * 1e9 / (nanoTime() - start)
    }

    private const val PRIMES = 1229

    /** Returns the factor for slowing the reasoning on a computer with [eventsPerSecond]; 1 if it is not faster than the reference. */
    fun slowdown(eventsPerSecond: Double): Double =
        String.format(Locale.ROOT, "%.1f", (eventsPerSecond / REFERENCE_EVENTS_PER_S).coerceAtLeast(1.0)).toDouble()

    /** Returns the factor that the user has [asked] for, else a measured one, with its origin in words. */
    fun slowdown(asked: Double?): Pair<Double, String> =
        if (asked != null) asked to "set with --slowdown" else eventsPerSecond().let { slowdown(it) to words(it) }

    /** Explains the origin of [slowdown] for the report. */
    fun words(eventsPerSecond: Double): String = String.format(
        Locale.ROOT, "%.0f events a second here, %.0f on a Raspberry Pi 3 Model B (sysbench cpu, primes up to 10,000, one thread)",
        eventsPerSecond, REFERENCE_EVENTS_PER_S,
    )
}
