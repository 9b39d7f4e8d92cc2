package samples.collision

import kotlin.time.Duration.Companion.nanoseconds
import kotlin.time.Duration.Companion.seconds
import kotlin.time.DurationUnit

/**
 * The way of a robot towards a wall. A course gives the distance from the wall at any time, according to the robot's commands.
 *
 * The robot drives at a constant speed, and starts and stops at once. At 10 cm/s, a wheeled robot coasts for less than a millimetre, the
 * unit of the results. At the distance 0, the robot has collided and stays there.
 *
 * Immutable. A command makes a new course. Times are ns of one steady clock. Distances are cm from the wall to the robot's front.
 */
class Course private constructor(private val legs: List<Leg>) {
    private class Leg(val start: Long, val distance: Double, val drives: Boolean)

    /** Returns the course after a command to drive at [now]. If the robot already drives or has collided, returns this course. */
    fun drive(now: Long): Course = if (stateAt(now).let { it == State.STANDING || it == State.STOPPED }) then(now, true) else this

    /** Returns the course after a command to stop at [now]. If the robot does not drive, returns this course. */
    fun stop(now: Long): Course = if (stateAt(now) == State.DRIVING) then(now, false) else this

    private fun then(now: Long, drives: Boolean) = Course(legs + Leg(now, distanceAt(now), drives))

    /** Returns the distance at [now], at least 0. [now] must not be before the last command. */
    fun distanceAt(now: Long): Double = legs.last().distanceAt(now)

    private fun Leg.distanceAt(instant: Long): Double =
        if (drives) (distance - SPEED_CM_S * (instant - start).nanoseconds.toDouble(DurationUnit.SECONDS)).coerceAtLeast(0.0) else distance

    /** Returns the state of the robot at [now], which must not be before the last command. */
    fun stateAt(now: Long): State = when {
        distanceAt(now) <= 0.0 -> State.COLLIDED
        legs.last().drives -> State.DRIVING
        legs.size > 1 -> State.STOPPED
        else -> State.STANDING
    }

    /** The time at which the robot first drove, or null if it never has. */
    val departure: Long? get() = legs.firstOrNull { it.drives }?.start

    /** The time of the last command that stopped the robot. Null if it was never stopped, or was started again. */
    val halt: Long? get() = legs.last().takeIf { !it.drives && legs.size > 1 }?.start

    /** Returns the time at which the robot was first [cm] from the wall, or null if it has not been so near by [now]. */
    fun reached(cm: Double, now: Long): Long? {
        legs.forEachIndexed { i, leg ->
            val end = legs.getOrNull(i + 1)?.start ?: now
            if (leg.drives && cm in leg.distanceAt(end)..leg.distance) {
                return leg.start + ((leg.distance - cm) / SPEED_CM_S).seconds.inWholeNanoseconds
            }
        }
        return null
    }

    enum class State {
        STANDING,

        DRIVING,

        STOPPED,

        COLLIDED,
    }

    companion object {
        const val START_CM = 200.0

        const val SPEED_CM_S = 10.0

        /** Returns the course of a robot that stands [START_CM] from the wall, from [now] on. */
        fun standing(now: Long): Course = Course(listOf(Leg(now, START_CM, drives = false)))
    }
}
