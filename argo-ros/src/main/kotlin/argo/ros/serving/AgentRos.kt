package argo.ros.serving

import argo.observing.AgentObserver
import argo.observing.ObservedAgent
import argo.observing.PerceivedMessage
import javino.SendOptions
import javino.wire.BoardAction
import kotlinx.serialization.json.JsonPrimitive
import java.util.concurrent.atomic.AtomicBoolean

/**
 * Offers [agent]'s boards on a graph: their percepts, before its filter, and their actions. Commands of clients go the way of `argo.act`.
 *
 * @param leave takes the agent off the graph; called once
 */
internal class AgentRos(
    private val agent: ObservedAgent,
    private val topics: Topics,
    private val leave: (AgentRos) -> Unit,
) : AgentObserver, Participant {
    private class Board(val publisher: PerceptPublisher) {
        var publishedNanos: Long? = null
    }

    private val boards = HashMap<String, Board>() // by port; guarded by this
    private val isLeft = AtomicBoolean()

    override val name = graphName(agent.name)
    override val actions: List<BoardAction>? get() = agent.actions

    override fun messageFiltered(message: PerceivedMessage) {
        synchronized(this) {
            val base = listOfNotNull(name, message.namespace?.let(::graphName)).joinToString("/", "/")
            val board = boards.getOrPut("${message.portName} $base") { Board(PerceptPublisher(base, topics)) }
            if (board.publishedNanos == message.receivedNanos) return // the filter has let more of the message through
            board.publishedNanos = message.receivedNanos
            board.publisher.publish(message.texts)
        }
    }

    override fun portChanged(port: String, status: String, reason: String?) =
        topics.publish("/$name/port/${graphName(port.removeSurrounding("\""))}", STRING, data(JsonPrimitive(status)))

    override fun act(command: String, options: SendOptions, done: (Outcome) -> Unit) = agent.act(command, options) { failure ->
        done(failure?.let { Outcome(it.error, it.cause) } ?: Outcome.DONE)
    }

    override fun close() {
        if (!isLeft.getAndSet(true)) leave(this)
    }
}
