package argo.ros.bridge

import java.util.concurrent.TimeUnit

/**
 * How much the clock of a robot is ahead of the platform's, by asking it for its time. Of the last [KEPT] answers the one counts that took
 * the shortest time: the robot's time was read somewhere in it, so the error is at most half of it. An answer that no clock of usual
 * quality can give after the others is of one that was set: then the others do not count any more. Safe for use by several threads.
 */
internal class ClockOffset {
    private class Sample(val offsetNanos: Long, val errorNanos: Long, val answeredNanos: Long)

    private val samples = ArrayDeque<Sample>()

    /** The offset in ns, null: it is not known. */
    @Volatile
    var offsetNanos: Long? = null
        private set

    /** How much the offset may be wrong, in ns. */
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

    /** When a clock that is ahead by the offset showed [stampNanos], by the platform's clock; null: the offset is not known. */
    fun whenShown(stampNanos: Long): Long? = offsetNanos?.let { stampNanos - it }

    private companion object {
        const val KEPT = 8

        /** Clocks of computers gain or lose less than one part in so many. */
        const val DRIFT = 5_000

        /** What is read of a clock may be a ms old. */
        val SLACK_NANOS = TimeUnit.MILLISECONDS.toNanos(1)
    }
}
