package benchmarks.stops

import javino.FrameDecoder
import javino.LineClock
import javino.LineSettings
import javino.PerceptsRequest
import java.util.concurrent.atomic.AtomicInteger

/** The board and the robot of [course], on a line that an agent opens. For one thread at a time. */
internal class UnoOnLine(course: StopCourse) : AutoCloseable {
    private val uno = SteppedUno(Bench.simulator, course.elf)
    private var line: SteppedLine? = null

    val timeline = Timeline(LineSettings(course.baud).byteNanos())

    /** The robot; null: the port has never been opened. */
    var robotOrNull: WatchedRobot? = null
        private set

    /** The number of commands sent to the board in version 1. */
    var sent = 0
        private set

    val traffic: Traffic get() = line?.traffic ?: Traffic(0, 0)

    /** Opens the board's line. Resets the board, except at the first call. */
    fun open(port: String, settings: LineSettings, clock: LineClock): SteppedLine {
        if (robotOrNull == null) robotOrNull = WatchedRobot(uno, clock, timeline) else uno.reset()
        val decoder = FrameDecoder(FrameDecoder.interByteTimeoutNanos(settings)) { if (!PerceptsRequest.isIn(it.text())) sent++ }
        return SteppedLine("$port-${lines.incrementAndGet()}", settings, clock, uno, timeline).also {
            line = it
            it.tap = { bytes -> decoder.accept(bytes, 0, bytes.size, clock.nanos()) }
        }
    }

    fun disconnects() = requireLine().close()

    fun hangs() = requireLine().hang(null)

    /** Stops the board, and sends [message] again and again in its place, without a pause. */
    fun floods(message: ByteArray) = requireLine().hang(message)

    private fun requireLine() = checkNotNull(line) { "its port has not been opened" }

    override fun close() = uno.close()

    private companion object {
        /** Numbers the lines, so that each has its own name. Links remember used numbers by that name, so each run is like the first. */
        val lines = AtomicInteger()
    }
}
