package argo.ros.joining

import argo.observing.AgentObserver
import argo.observing.ObservedAgent
import argo.observing.PerceivedMessage
import javino.link.SendOptions
import javino.wire.BoardAction
import kotlinx.serialization.json.JsonPrimitive

/**
 * Publishes the boards of an agent in a ROS graph: their actions, and their percepts before the agent's filter. A command from the graph is
 * sent as by `argo.act`. [warn] takes reports of unpublished percepts, each text once.
 */
internal class AgentRos(
    private val agent: ObservedAgent,
    private val topics: Topics,
    private val warn: (String) -> Unit,
    private val leave: () -> Unit,
) : AgentObserver, Participant {
    private class Board(val publisher: PerceptPublisher) {
        var publishedNanos: Long? = null
    }

    private val boards = HashMap<String, Board>() // by port name and namespace; guarded by this

    override val name = graphName(agent.name)
    override val actions: List<BoardAction>? get() = agent.actions

    override fun messageFiltered(message: PerceivedMessage) {
        synchronized(this) {
            val base = listOfNotNull(name, message.namespace?.let(::graphName)).joinToString("/", "/")
            val board = boards.getOrPut("${message.portName} $base") { Board(PerceptPublisher(base, topics, warn)) }
            if (board.publishedNanos == message.receivedNanos) return // already published; it returns because of held-back percepts
            board.publishedNanos = message.receivedNanos
            board.publisher.publish(message.texts)
        }
    }

    override fun portChanged(port: String, status: String, reason: String?) =
        topics.publish("/$name/port/${graphName(port.removeSurrounding("\""))}", STRING, listOf(data(JsonPrimitive(status))))

    override fun act(command: String, options: SendOptions, done: (Outcome) -> Unit) = agent.act(command, options) { failure ->
        done(failure?.let { Outcome(it.error, it.cause) } ?: Outcome.DONE)
    }

    override fun close() = leave()
}
