package argo.ros.bridge

import java.util.concurrent.TimeUnit

/**
 * Measures how far a robot's clock is ahead of the platform's clock. Uses the quickest of the robot's last [KEPT] answers to the question
 * for its time. The robot reads its clock between question and answer. The error is at most half of that time. If drift cannot explain a
 * new answer, the robot's clock was set. Earlier answers are then dropped. Safe for use by several threads.
 */
internal class ClockOffset {
    private class Sample(val offsetNanos: Long, val errorNanos: Long, val answeredNanos: Long)

    private val samples = ArrayDeque<Sample>()

    /** The offset in ns, or null if it is not known. */
    @Volatile
    var offsetNanos: Long? = null
        private set

    @Volatile
    var errorNanos: Long = 0
        private set

    /** Adds an answer. The robot was asked at [askedNanos] and reported [rosNanos]. The answer arrived at [answeredNanos]. */
    @Synchronized
    fun add(askedNanos: Long, rosNanos: Long, answeredNanos: Long) {
        val half = (answeredNanos - askedNanos) / 2
        val sample = Sample(rosNanos - (askedNanos + half), half, answeredNanos)
        samples.removeIf { !mayPrecede(it, sample) }
        samples.addLast(sample)
        if (samples.size > KEPT) samples.removeFirst()
        val best = samples.minBy { it.errorNanos }
        errorNanos = best.errorNanos
        offsetNanos = best.offsetNanos
    }

    private fun mayPrecede(before: Sample, after: Sample): Boolean {
        val driftNanos = (after.answeredNanos - before.answeredNanos) / DRIFT
        return Math.abs(after.offsetNanos - before.offsetNanos) <= before.errorNanos + after.errorNanos + driftNanos + SLACK_NANOS
    }

    /** Returns the platform time at which the robot's clock showed [stampNanos], or null if the offset is not known. */
    fun whenShown(stampNanos: Long): Long? = offsetNanos?.let { stampNanos - it }

    private companion object {
        const val KEPT = 8

        /** The inverse of the greatest relative drift of a computer's clock. */
        const val DRIFT = 5_000

        /** The greatest age of a clock reading. */
        val SLACK_NANOS = TimeUnit.MILLISECONDS.toNanos(1)
    }
}
