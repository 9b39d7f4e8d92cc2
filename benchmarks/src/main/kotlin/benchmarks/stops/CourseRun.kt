package benchmarks.stops

import argo.testkit.TestAgent
import argo.testkit.agentOf

/**
 * Runs an agent with [program] on the robot of [course], in virtual time. [program] opens the port `uno`. Not safe for use by several
 * threads at once.
 */
internal class CourseRun(private val course: StopCourse, program: String) : AutoCloseable {
    val uno = UnoOnLine(course)

    val robot: WatchedRobot
        get() = checkNotNull(uno.robotOrNull) { "the agent has not opened its port\n${agent.log.joinToString("\n")}" }

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
