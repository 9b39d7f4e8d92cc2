package argo.ros.bridge

import java.util.concurrent.TimeUnit

/**
 * Measures how much the clock of a robot is ahead of the platform's, from its answers to questions for its time. The quickest of the last
 * [KEPT] answers counts: the robot read its time somewhere in between, so the error is at most half of the time that the answer took. If no
 * clock of usual quality could give an answer after the earlier ones, the robot's clock was set, and the earlier answers count no more.
 * Safe for use by several threads.
 */
internal class ClockOffset {
    private class Sample(val offsetNanos: Long, val errorNanos: Long, val answeredNanos: Long)

    private val samples = ArrayDeque<Sample>()

    /** The offset in ns, null: it is not known. */
    @Volatile
    var offsetNanos: Long? = null
        private set

    /** The largest error of the offset, in ns. */
    @Volatile
    var errorNanos: Long = 0
        private set

    /** The robot said [rosNanos] when it was asked at [askedNanos]; the answer came at [answeredNanos]. */
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

    /**
     * Returns the time, by the platform's clock, at which a clock ahead by the offset showed [stampNanos]; null: the offset is not known.
     */
    fun whenShown(stampNanos: Long): Long? = offsetNanos?.let { stampNanos - it }

    private companion object {
        const val KEPT = 8

        /** Clocks of computers gain or lose less than one part in this number. */
        const val DRIFT = 5_000

        /** A time that is read from a clock may be a ms old. */
        val SLACK_NANOS = TimeUnit.MILLISECONDS.toNanos(1)
    }
}
