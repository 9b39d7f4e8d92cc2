package javino.virtual

import javino.LineSettings
import javino.wire.WireFrame
import kotlin.random.Random

/** The durations for which docs/real-time.md gives bounds. */
internal enum class Bounded(val words: String) {
    ANSWER("an answer"),
    PARTS("an answer, rules on the board"),
    COMMAND("a command on an idle line"),
    OUTCOME("its outcome"),
    URGENT("an urgent command behind others, while a request is out"),
    PLAN("from a sensor through a plan to a motor, by the answer"),
    REFLEX("from a sensor to the reflex that the board carries out"),
    REPORT("from a sensor through a plan to a motor, by the board's report"),
}

/**
 * A line, a board and the messages between them.
 *
 * @property intervalMs the sensing interval
 * @property percepts number of further percepts in an answer; each has a number of [digits] digits
 */
internal data class BoundsCase(
    val baud: Int, val times: BoardTimes, val intervalMs: Int, val percepts: Int, val digits: Int, val hasRules: Boolean,
) {
    val byteNanos: Long = LineSettings(baud).byteNanos()

    companion object {
        private const val MICROS = 1_000L
        private val RATES = listOf(9_600, 19_200, 57_600, 115_200, 500_000, 1_000_000)

        /** A random case that meets the assumptions of the bounds. */
        fun random(random: Random): BoundsCase {
            val hasRules = random.nextBoolean()
            val times = BoardTimes(
                loop = random.nextLong(if (hasRules) 500 else 50, 20_000) * MICROS,
                action = random.nextLong(10, 10_000) * MICROS,
                sensors = random.nextLong(50, 10_000) * MICROS,
                ruleSensors = random.nextLong(20, 3_000) * MICROS,
                isSteady = random.nextInt(4) == 0,
            )
            return BoundsCase(RATES.random(random), times, random.nextInt(10, 200), random.nextInt(30), random.nextInt(1, 5), hasRules)
        }
    }
}

/** The bounds of docs/real-time.md for [course], in ns. The computer's own time is not included. */
internal class Bounds(private val course: BoundsCase) {
    private val times = course.times
    private val look = if (course.hasRules) times.ruleSensors else 0
    private val loop = times.loop + look

    /** Length of the items of an answer: `news(10);`, `near(0);` and the other percepts. */
    private val items: Int = 2 + (course.percepts * (course.digits + 1) + 3 + 2 + 1) / 2
    private val parts = if (course.hasRules && items > PART) (items + PART - 1) / PART else 1
    private val answer = if (parts > 1) items + parts * AROUND_PART else items + AROUND_PART - 1

    /** Time to read the sensors, and to write the bytes that exceed the port's buffer. */
    private val sensors = times.sensors + look + if (parts > 1) 0 else bytes(maxOf(0, answer - LoopBoard.BUFFER))

    /** Length of the longest frame that the board may be sending. */
    private val sending = if (parts > 1) PART + AROUND_PART else answer

    private fun bytes(count: Int) = count * course.byteNanos

    fun answer() = bytes(REQUEST + answer) + times.sensors + look + parts * loop

    fun command(bytes: Int) = bytes(bytes) + loop

    fun outcome(bytes: Int) = command(bytes) + times.action + bytes(ACKNOWLEDGEMENT)

    /** The bound of an urgent command when [ahead] earlier commands are unacknowledged. */
    fun urgent(bytes: Int, ahead: Int) = bytes(LONGEST_ROW + LoopBoard.CREDIT + bytes) + (ahead + 1) * (loop + times.action) + sensors

    fun planFromAnswer(bytes: Int) = maxOf(course.intervalMs * NANOS_PER_MS, answer()) + bytes(GRACE) +
        times.sensors + look + bytes(answer) + parts * loop + command(bytes)

    fun reflex() = LoopBoard.LOOK_NANOS + times.loop + times.ruleSensors + sensors

    fun planFromReport(report: Int, bytes: Int) =
        reflex() + times.action + bytes(sending + report + REQUEST) + command(bytes) + sensors

    companion object {
        /** Number of bytes around the text of a single command. */
        const val AROUND_COMMAND = WireFrame.OVERHEAD + 1

        /** Number of bytes around the text of a report. */
        const val AROUND_REPORT = WireFrame.OVERHEAD + 2

        private const val NANOS_PER_MS = 1_000_000L
        private const val PART = 12
        private const val AROUND_PART = WireFrame.OVERHEAD + 2
        private const val REQUEST = WireFrame.OVERHEAD + 1
        private const val ACKNOWLEDGEMENT = WireFrame.OVERHEAD
        private const val LONGEST_ROW = WireFrame.OVERHEAD + 32
        private const val GRACE = 3
    }
}
