package argo.ros.bridge

import java.util.concurrent.TimeUnit

/**
 * Measures how far a robot's clock is ahead of the platform's clock, from the robot's answers when it is asked for its time. The quickest
 * of the last [KEPT] answers counts. The robot read its clock at some time between question and answer, so the error is at most half of the
 * time between them. If a new answer differs by more than drift explains, the robot's clock was set, so earlier answers are forgotten. Safe
 * for use by several threads.
 */
internal class ClockOffset {
    private class Sample(val offsetNanos: Long, val errorNanos: Long, val answeredNanos: Long)

    private val samples = ArrayDeque<Sample>()

    /** The offset in ns; null: it is not known. */
    @Volatile
    var offsetNanos: Long? = null
        private set

    /** The largest error of the offset, in ns. */
    @Volatile
    var errorNanos: Long = 0
        private set

    /** Adds an answer: the robot was asked at [askedNanos] and reported [rosNanos]; its answer came at [answeredNanos]. */
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

    /** Returns when the robot's clock showed [stampNanos], by the platform's clock; null: the offset is not known. */
    fun whenShown(stampNanos: Long): Long? = offsetNanos?.let { stampNanos - it }

    private companion object {
        const val KEPT = 8

        /** A computer's clock gains or loses less than one part in this number. */
        const val DRIFT = 5_000

        /** A clock's reading may be one ms old. */
        val SLACK_NANOS = TimeUnit.MILLISECONDS.toNanos(1)
    }
}
