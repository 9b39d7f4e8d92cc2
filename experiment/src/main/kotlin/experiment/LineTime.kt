package experiment

import javino.Frame
import javino.LineSettings
import javino.PerceptsRequest
import javino.sim.BoardSession.PART_WITH_RULES
import javino.wire.AnswerPart
import javino.wire.FrameKind
import javino.wire.PerceptWriter
import javino.wire.WireFrame
import samples.collision.Course
import samples.collision.Sensors
import kotlin.random.Random
import kotlin.time.Duration.Companion.seconds

/**
 * Returns the time limit for an answer: three times the longest answer, but at least a second. In version 2, the first answer is the
 * longest.
 */
internal fun answerLimitMs(trial: Trial): Int =
    maxOf(1000L, 3 * exchangeBytes(trial.copy(view = View.NONE), 0) * byteNanos(trial) / 1_000_000).toInt()

/**
 * Returns the line time of a request and its whole answer, in ns. A version 2 board answers only with percepts that the filter keeps. The
 * computer already knows their texts.
 */
internal fun exchangeNanos(trial: Trial): Long = exchangeBytes(trial, MAX_KNOWN) * byteNanos(trial)

/** Returns the bytes of a request and its answer. In version 2, the computer already knows the texts of [known] percepts. */
private fun exchangeBytes(trial: Trial, known: Int): Int {
    val all = Sensors(Random(0), trial.sensors / Sensors.PER_SET).frame(Course.START_CM).map { "$it;" }
    if (!trial.condition.isVersion2) {
        val bytes = all.sumOf { it.length }
        val frames = (bytes + Frame.MAX_PAYLOAD - 1) / Frame.MAX_PAYLOAD
        return PerceptsRequest.ALL.length + bytes + (1 + frames) * Frame.HEADER_LENGTH
    }
    val asked = trial.view.functors
    val texts = all.filter { asked == null || it.substringBefore('(') in asked }
    val writer = PerceptWriter(MAX_KNOWN)
    writer.items(texts, 0) // the writer now knows the shapes of the texts
    val items = writer.items(texts, known)
    val parts = if (trial.condition == Condition.REFLEX) AnswerPart.split(1, items, PART_WITH_RULES) else AnswerPart.split(1, items)
    val request = WireFrame.of(FrameKind.ASK, 1, Char(known) + asked?.joinToString(",", "(", ")").orEmpty())
    return request.length() + parts.sumOf { WireFrame.of(it.kind, 0, it.payload).length() }
}

private const val MAX_KNOWN = 126

/**
 * Returns the worst delay that line and sensors cause for any program, in ns. The delay is the time from crossing the limit to the effect
 * of `stop`. Four delays add up. First, noise delays the reading below the limit. Second, an exchange has just started without this
 * reading. The next exchange starts at its end, or at the end of the sensing interval. Third, that exchange brings the reading. Fourth, the
 * command is sent. If the board itself stops the robot, it reads its sensors within 5 ms or after its current frame.
 */
internal fun leastStopNanos(trial: Trial): Long {
    val reading = (Sensors.DISTANCE_NOISE / Course.SPEED_CM_S).seconds.inWholeNanoseconds
    if (trial.condition == Condition.REFLEX) return reading + maxOf(LOOK_NANOS, longestPart.length() * byteNanos(trial))
    val exchange = exchangeNanos(trial)
    return reading + maxOf(exchange, trial.interval * 1_000_000L) + exchange + stopBytes(trial) * byteNanos(trial)
}

private const val LOOK_NANOS = 5_000_000L

/** The longest answer frame of a board that checks rules. The payload starts with the numbers of request and part. */
private val longestPart = WireFrame.of(FrameKind.PERCEPTS_PART, 0, " ".repeat(2 + PART_WITH_RULES))

internal fun limitNanos(trial: Trial): Long = (trial.limit / Course.SPEED_CM_S).seconds.inWholeNanoseconds

/** Returns true if the limit leaves at least [leastStopNanos] to stop. */
internal fun leavesTime(trial: Trial): Boolean = limitNanos(trial) >= leastStopNanos(trial)

/** Returns the length of the command `stop` in bytes. Version 2 sends a number for the word. */
private fun stopBytes(trial: Trial): Int = if (trial.condition.isVersion2) WireFrame.OVERHEAD + 1 else "stop".length + Frame.HEADER_LENGTH

private fun byteNanos(trial: Trial): Long = LineSettings(trial.baud).byteNanos()
