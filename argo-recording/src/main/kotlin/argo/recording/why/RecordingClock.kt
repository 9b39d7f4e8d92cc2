package argo.recording.why

/**
 * Seconds of a recording, which count from its first cycle.
 *
 * @param firstNs when that cycle began, in ns of the agents' clock
 */
internal class RecordingClock(private val firstNs: Long) {
    /** The seconds at [ns] of the agents' clock. */
    fun seconds(ns: Long): Double = (ns - firstNs) / NANOS

    /** The time by the agents' clock, in ns, at [seconds]. */
    fun nanos(seconds: Double): Long = firstNs + (seconds * NANOS).toLong()

    private companion object {
        const val NANOS = 1e9
    }
}
