package benchmarks.stops

import argo.testkit.TestAgent
import argo.testkit.agentOf
import javino.FrameDecoder
import javino.LineClock
import javino.LineSettings
import javino.PerceptsRequest
import java.util.concurrent.atomic.AtomicInteger

/** An agent with [program] on the robot of [course], in virtual time; the agent opens the port `uno`. For one thread at a time. */
internal class CourseRun(private val course: StopCourse, program: String) : AutoCloseable {
    private val uno = SteppedUno(Bench.simulator, course.elf)
    private var line: SteppedLine? = null
    private var robotOrNull: WatchedRobot? = null

    /** What happens on the line and on the board. */
    val timeline = Timeline(LineSettings(course.baud).byteNanos())

    /** How many commands the agent has sent in version 1. */
    var sent = 0
        private set

    /** The robot, once the port has been opened. */
    val robot: WatchedRobot get() = checkNotNull(robotOrNull) { "the agent has not opened its port\n${agent.log.joinToString("\n")}" }

    /** The bytes on the line so far. */
    val traffic: Traffic get() = line?.traffic ?: Traffic(0, 0)

    /** The agent. */
    val agent: TestAgent = agentOf(program) {
        name = "robot"
        cycleTime = course.cycleTime
        sourcePath("${Bench.agents}")
        board("uno").leadsTo { port, settings, clock -> open(port, settings, clock) }
    }

    private fun open(port: String, settings: LineSettings, clock: LineClock): SteppedLine {
        if (robotOrNull == null) robotOrNull = WatchedRobot(uno, clock, timeline) else uno.reset()
        val decoder = FrameDecoder(FrameDecoder.interByteTimeoutNanos(settings)) { if (!PerceptsRequest.isIn(it.text())) sent++ }
        return SteppedLine("$port-${lines.incrementAndGet()}", settings, clock, uno, timeline).also {
            line = it
            it.tap = { bytes -> decoder.accept(bytes, 0, bytes.size, clock.nanos()) }
        }
    }

    override fun close() {
        agent.close()
        uno.close()
    }

    private companion object {
        /** Each line has a name of its own: links remember the numbers that they have used by it, and the next run is to be like the first. */
        val lines = AtomicInteger()
    }
}
