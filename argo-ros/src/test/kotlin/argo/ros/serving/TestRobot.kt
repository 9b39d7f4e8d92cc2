package argo.ros.serving

import javino.SendOptions
import javino.wire.BoardAction
import java.util.concurrent.ConcurrentLinkedQueue

/** A robot in this program. */
internal class TestRobot(
    override val name: String = "uno",
    override val actions: List<BoardAction>? = listOf(BoardAction("stop", 0), BoardAction("move", 2), BoardAction("fail", 0)),
) : Participant {
    /** The commands that it has carried out, in their order. */
    val done = ConcurrentLinkedQueue<String>()

    override fun act(command: String, options: SendOptions, done: (Outcome) -> Unit) {
        this.done += if (options.latest()) "$command, the latest" else command
        if (command != "hang") done(if (command == "fail") Outcome("act_failed", "the wheel is stuck") else Outcome.DONE)
    }
}

/** A server at a free port of this computer with [robot] on its graph. */
internal class TestServer(val robot: TestRobot = TestRobot(), address: String = "0") : AutoCloseable {
    /** The lines for a person. */
    val log = ConcurrentLinkedQueue<String>()
    val graph = Graph(log::add).apply { add(robot) }
    val server = RosServer(Access.of(address), graph, log::add)
    private val publisher = PerceptPublisher("/${robot.name}", graph.topics)

    /** Publishes [message] as the robot's board. */
    @Synchronized
    fun says(message: String) = publisher.publish(message)

    override fun close() = server.close()
}
