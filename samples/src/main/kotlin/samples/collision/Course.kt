package samples.collision

import kotlin.time.Duration.Companion.nanoseconds
import kotlin.time.Duration.Companion.seconds
import kotlin.time.DurationUnit

/**
 * The way of a robot towards a wall: its distance from the wall at any instant, which follows from its commands.
 *
 * The robot drives at a constant speed, and starts and stops at once: at 10 cm/s a wheeled robot coasts for less than a millimetre, the
 * unit of the results. When the distance reaches 0, the robot has collided and stays there.
 *
 * Immutable: a command makes a new course. Instants are ns of any one steady clock, distances are cm from the wall to the robot's front.
 */
class Course private constructor(private val legs: List<Leg>) {
    private class Leg(val start: Long, val distance: Double, val drives: Boolean)

    /** Returns the course after a command to drive at [now], which is this course if the robot already drives or has collided. */
    fun drive(now: Long): Course = if (stateAt(now).let { it == State.STANDING || it == State.STOPPED }) then(now, true) else this

    /** Returns the course after a command to stop at [now], which is this course if the robot does not drive. */
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

    /** The instant at which the robot first drove; null: it never has. */
    val departure: Long? get() = legs.firstOrNull { it.drives }?.start

    /** The instant of the last command that stopped the robot; null: the robot was never stopped, or has been started again. */
    val halt: Long? get() = legs.last().takeIf { !it.drives && legs.size > 1 }?.start

    /** Returns the instant at which the robot was first [cm] from the wall; null if the robot has not been so near by [now]. */
    fun reached(cm: Double, now: Long): Long? {
        legs.forEachIndexed { i, leg ->
            val end = legs.getOrNull(i + 1)?.start ?: now
            if (leg.drives && cm in leg.distanceAt(end)..leg.distance) {
                return leg.start + ((leg.distance - cm) / SPEED_CM_S).seconds.inWholeNanoseconds
            }
        }
        return null
    }

    /** The states of a robot. */
    enum class State {
        /** The robot has never driven. */
        STANDING,

        /** The robot drives towards the wall. */
        DRIVING,

        /** The robot has driven and was stopped in front of the wall. */
        STOPPED,

        /** The robot has run into the wall. */
        COLLIDED,
    }

    companion object {
        /** The distance from the wall at which the robot of the experiment starts, in cm. */
        const val START_CM = 200.0

        /** The speed of the robot of the experiment, in cm/s. */
        const val SPEED_CM_S = 10.0

        /** Returns the course of a robot that does not drive, [START_CM] from the wall, from [now] on. */
        fun standing(now: Long): Course = Course(listOf(Leg(now, START_CM, drives = false)))
    }
}
