package benchmarks.stops

import argo.testkit.TestAgent
import argo.testkit.agentOf

/** An agent with [program] on the robot of [course], in virtual time; the agent opens the port `uno`. For one thread at a time. */
internal class CourseRun(private val course: StopCourse, program: String) : AutoCloseable {
    private val uno = UnoOnLine(course)

    val timeline get() = uno.timeline

    /** The number of commands that the agent has sent in version 1. */
    val sent get() = uno.sent

    /** The robot, once the port has been opened. */
    val robot: WatchedRobot
        get() = checkNotNull(uno.robotOrNull) { "the agent has not opened its port\n${agent.log.joinToString("\n")}" }

    val traffic: Traffic get() = uno.traffic

    val agent: TestAgent = agentOf(program) {
        name = "robot"
        cycleTime = course.cycleTime
        sourcePath("${Bench.agents}")
        board("uno").leadsTo(uno::open)
    }

    override fun close() {
        agent.close()
        uno.close()
    }
}
