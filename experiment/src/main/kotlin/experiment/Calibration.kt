package experiment

import java.lang.management.ManagementFactory
import java.util.Locale
import kotlin.math.sqrt

/**
 * Compares the speed of this computer with that of a single-board computer of 2016. The two computers do the work of `sysbench cpu`: they
 * count primes up to 10,000 by trial division.
 *
 * The work compares integer division in compiled code of one thread. Caches and memory are not compared. The factor is therefore an
 * assumption. The report states it, and the user can set it.
 */
internal object Calibration {
    /**
     * Events per second of a Raspberry Pi 3 Model B (February 2016, Cortex-A53 at 1.2 GHz). The published figure is 687.45 for the 3 Model
     * B+, which has the core at 1.4 GHz (one thread, sysbench 1.0.20, https://leoncode.co.uk/articles/raspberry-pi-benchmarks). The
     * constant is 1.2 / 1.4 of the published figure.
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
     * Measures the events per second of this computer for 1.5 s. The best of several rounds counts, since other programs can only slow this
     * one down. [nanoTime] returns the processor time of the calling thread, in ns.
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

    /** Returns the factor by which a computer with [eventsPerSecond] is faster than the reference, but at least 1. */
    fun slowdown(eventsPerSecond: Double): Double =
        String.format(Locale.ROOT, "%.1f", (eventsPerSecond / REFERENCE_EVENTS_PER_S).coerceAtLeast(1.0)).toDouble()

    /** Returns the factor and its origin in words. Measures the factor if the user has not [asked] for one. */
    fun slowdown(asked: Double?): Pair<Double, String> =
        if (asked != null) asked to "set with --slowdown" else eventsPerSecond().let { slowdown(it) to words(it) }

    /** Explains a measured factor for the report. */
    fun words(eventsPerSecond: Double): String = String.format(
        Locale.ROOT, "%.0f events a second here, %.0f on a Raspberry Pi 3 Model B (sysbench cpu, primes up to 10,000, one thread)",
        eventsPerSecond, REFERENCE_EVENTS_PER_S,
    )
}
