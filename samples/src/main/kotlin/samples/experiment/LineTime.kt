package samples.experiment

import javino.Frame
import javino.LineSettings
import javino.PerceptsRequest
import samples.collision.Course
import samples.collision.Sensors
import kotlin.random.Random

private const val NANOS_PER_S = 1_000_000_000L

/** How long the board may take to answer: a second, or three times what the answer takes on the line. */
internal fun answerLimitMs(trial: Trial): Int = maxOf(1000L, 3 * exchangeNanos(trial.copy(view = View.NONE)) / 1_000_000).toInt()

/** What a request and its whole answer take on the line alone, in ns. A board of version 2 answers what the filter keeps. */
internal fun exchangeNanos(trial: Trial): Long {
    val percepts = Sensors(Random(0), trial.sensors / Sensors.PER_SET).frame(Course.START_CM)
    val asked = if (trial.condition == Condition.VERSION_2) trial.view.functors else null
    val answer = if (asked == null) percepts.length else percepts.split(';').filter { it.substringBefore('(') in asked }.sumOf { it.length + 1 }
    val request = PerceptsRequest.ALL.length + if (asked == null) 0 else asked.joinToString(",", "(", ")").length
    val frames = (answer + Frame.MAX_PAYLOAD - 1) / Frame.MAX_PAYLOAD
    return (request + answer + (1 + frames) * around(trial)) * byteNanos(trial)
}

/**
 * What the line and the sensors alone can take, in ns, from the instant at which the robot crosses its limit to the one at which `stop` takes effect
 * on its board, whatever program drives it and however fast: the reading that crosses the limit comes as late as the sensor's noise lets it, just after
 * the board has begun an answer without it; it is in the answer to the next request, which starts when that exchange is over or the sensing
 * interval is; and then there is the command.
 */
internal fun leastStopNanos(trial: Trial): Long {
    val exchange = exchangeNanos(trial)
    val reading = (Sensors.DISTANCE_NOISE / Course.SPEED_CM_S * NANOS_PER_S).toLong()
    return reading + maxOf(exchange, trial.interval * 1_000_000L) + exchange + ("stop".length + around(trial)) * byteNanos(trial)
}

/** How long the robot drives from its limit to the wall, in ns. */
internal fun limitNanos(trial: Trial): Long = (trial.limit / Course.SPEED_CM_S * NANOS_PER_S).toLong()

/** Whether the limit leaves the physical time to stop: no less than [leastStopNanos]. */
internal fun leavesTime(trial: Trial): Boolean = limitNanos(trial) >= leastStopNanos(trial)

/** What a frame has around its payload, in bytes. */
private fun around(trial: Trial): Int = if (trial.condition == Condition.VERSION_2) 12 else Frame.HEADER_LENGTH

private fun byteNanos(trial: Trial): Long = LineSettings(trial.baud).byteNanos()
