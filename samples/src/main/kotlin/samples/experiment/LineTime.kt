package samples.experiment

import javino.Frame
import javino.LineSettings
import javino.PerceptsRequest
import samples.collision.Course
import samples.collision.Sensors
import kotlin.random.Random
import kotlin.time.Duration.Companion.seconds

/** The answer timeout: a second, or three times the time of the answer on the line. */
internal fun answerLimitMs(trial: Trial): Int = maxOf(1000L, 3 * exchangeNanos(trial.copy(view = View.NONE)) / 1_000_000).toInt()

/** The time of a request and its whole answer on the line, in ns. A version 2 board answers with the percepts that the filter keeps. */
internal fun exchangeNanos(trial: Trial): Long {
    val percepts = Sensors(Random(0), trial.sensors / Sensors.PER_SET).frame(Course.START_CM)
    val asked = if (trial.condition.isVersion2) trial.view.functors else null
    val answer = if (asked == null) percepts.length
    else percepts.split(';').filter { it.substringBefore('(') in asked }.sumOf { it.length + 1 }
    val request = PerceptsRequest.ALL.length + if (asked == null) 0 else asked.joinToString(",", "(", ")").length
    val frames = (answer + Frame.MAX_PAYLOAD - 1) / Frame.MAX_PAYLOAD
    return (request + answer + (1 + frames) * around(trial)) * byteNanos(trial)
}

/**
 * The worst-case delay of line and sensors, in ns, from the instant at which the robot crosses its limit to the effect of `stop` on its
 * board, whatever program drives it: the reading below the limit comes as late as the sensor's noise allows, just after the board has begun
 * an answer without it; it is in the answer to the next request, which starts at the end of that exchange or of the sensing interval; then
 * follows the command. A board that stops the robot itself reads its sensors once more, and has a frame to send before.
 */
internal fun leastStopNanos(trial: Trial): Long {
    val reading = (Sensors.DISTANCE_NOISE / Course.SPEED_CM_S).seconds.inWholeNanoseconds
    if (trial.condition == Condition.REFLEX) return reading + maxOf(LOOK_NANOS, LONGEST_PART * byteNanos(trial))
    val exchange = exchangeNanos(trial)
    return reading + maxOf(exchange, trial.interval * 1_000_000L) + exchange + ("stop".length + around(trial)) * byteNanos(trial)
}

/** How often a board compares its sensors with its rules. */
private const val LOOK_NANOS = 5_000_000L

/** The bytes of the longest part of an answer of a board that watches rules. */
private const val LONGEST_PART = 20

/** How long the robot drives from its limit to the wall, in ns. */
internal fun limitNanos(trial: Trial): Long = (trial.limit / Course.SPEED_CM_S).seconds.inWholeNanoseconds

/** Whether the limit leaves the physical time to stop: no less than [leastStopNanos]. */
internal fun leavesTime(trial: Trial): Boolean = limitNanos(trial) >= leastStopNanos(trial)

/** The bytes of a frame besides its payload. */
private fun around(trial: Trial): Int = if (trial.condition.isVersion2) 12 else Frame.HEADER_LENGTH

private fun byteNanos(trial: Trial): Long = LineSettings(trial.baud).byteNanos()
