package argo.recording.why

/**
 * Converts between ns of the agents' clock and the seconds of a recording, which count from its first cycle.
 *
 * @param firstNs the beginning of that cycle, in ns of the agents' clock
 */
internal class RecordingClock(private val firstNs: Long) {
    /** Returns the seconds at [ns] of the agents' clock. */
    fun seconds(ns: Long): Double = (ns - firstNs) / NANOS

    /** Returns the time of the agents' clock, in ns, at [seconds]. */
    fun nanos(seconds: Double): Long = firstNs + (seconds * NANOS).toLong()

    private companion object {
        const val NANOS = 1e9
    }
}
