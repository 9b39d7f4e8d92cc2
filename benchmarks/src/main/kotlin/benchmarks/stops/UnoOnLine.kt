package benchmarks.stops

import javino.FrameDecoder
import javino.LineClock
import javino.LineSettings
import javino.PerceptsRequest
import java.util.concurrent.atomic.AtomicInteger

/** The board and the robot of [course], on a line that an agent opens. Not safe for use by several threads at once. */
internal class UnoOnLine(course: StopCourse) : AutoCloseable {
    private val uno = SteppedUno(Bench.simulator, course.elf)
    private var line: SteppedLine? = null

    val timeline = Timeline(LineSettings(course.baud).byteNanos())

    /** The robot, or null before the port is opened. */
    var robotOrNull: WatchedRobot? = null
        private set

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

    fun floods(message: ByteArray) = requireLine().hang(message)

    private fun requireLine() = checkNotNull(line) { "its port has not been opened" }

    override fun close() = uno.close()

    private companion object {
        /** Gives each line its own name. Links store used numbers under that name. With a new name, each run starts like the first. */
        val lines = AtomicInteger()
    }
}
