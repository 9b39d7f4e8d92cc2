package argo.ros.bridge

import java.util.concurrent.TimeUnit

/**
 * How much the clock of a robot is ahead of the platform's, by asking it for its time. Of the last [KEPT] answers the one counts that took
 * the shortest time: the robot's time was read somewhere in it, so the error is at most half of it. Safe for use by several threads.
 */
internal class ClockOffset {
    private class Sample(val offsetNanos: Long, val errorNanos: Long)

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
        samples.addLast(Sample(rosNanos - (askedNanos + half), half))
        if (samples.size > KEPT) samples.removeFirst()
        val best = samples.minBy { it.errorNanos }
        errorNanos = best.errorNanos
        offsetNanos = best.offsetNanos
    }

    /**
     * When something was true that has the time stamp [stampNanos] of the robot and came at [receivedNanos], by the platform's clock: not
     * after it came. What is said to be older than [MAX_AGE_NANOS] has a stamp of another clock, so that nothing is known but when it came.
     */
    fun trueAt(stampNanos: Long?, receivedNanos: Long): Long {
        val offset = offsetNanos
        if (stampNanos == null || offset == null) return receivedNanos
        val age = receivedNanos - (stampNanos - offset)
        return if (age in 0..MAX_AGE_NANOS) receivedNanos - age else receivedNanos
    }

    companion object {
        private const val KEPT = 8

        /** The oldest message that is believed to be that old, in ns. */
        val MAX_AGE_NANOS = TimeUnit.MINUTES.toNanos(10)
    }
}
