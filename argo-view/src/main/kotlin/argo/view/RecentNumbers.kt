package argo.view

import java.util.concurrent.TimeUnit

/** The numbers of one sensor in the last minute: for each half second the newest numbers. Not safe for use by several threads. */
internal class RecentNumbers {
    private val points = ArrayDeque<Point>()

    /** Notes that the sensor gave [numbers] at [nanos]. [nanos] never goes back. */
    fun add(numbers: List<Double>, nanos: Long) {
        val step = Math.floorDiv(nanos, STEP_NANOS)
        if (points.lastOrNull()?.step == step) points.removeLast()
        points += Point(step, numbers)
        while (points.size > STEPS) points.removeFirst()
    }

    /**
     * Returns [STEPS] values of each number until [now], oldest first. A value is null if its half second had no number or an infinite one.
     */
    fun values(now: Long): List<List<Double?>> {
        val last = Math.floorDiv(now, STEP_NANOS)
        val numbers = points.lastOrNull()?.numbers?.size ?: 0
        val byStep = points.associateBy { it.step }
        return (0 until numbers).map { i -> (last - STEPS + 1..last).map { byStep[it]?.numbers?.getOrNull(i)?.takeIf(Double::isFinite) } }
    }

    private class Point(val step: Long, val numbers: List<Double>)

    companion object {
        /** How many values of each number are kept: one for each half second of a minute. */
        const val STEPS = 120
        private val STEP_NANOS = TimeUnit.MILLISECONDS.toNanos(500)
    }
}
