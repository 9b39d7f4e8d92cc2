package argo.ros.joining

import argo.ros.bridge.Bridge
import argo.ros.bridge.Outgoing
import argo.ros.bridge.operation
import javino.LineClock
import java.util.concurrent.TimeUnit

/**
 * Sends the newest messages of [topics] to a bridge in rounds. A round is a group of messages with a ping behind it. The next round waits
 * for the answer to the ping. One thread uses this object, but any thread may call [answered].
 */
internal class MessageRounds(private val topics: Topics, private val clock: LineClock, private val isNew: () -> Unit) {
    private val names = HashSet<String>()
    private var beganNanos = clock.nanos()

    @Volatile
    private var isUnderWay = false

    val advertised: Map<String, String> get() = topics.types.filterKeys(names::contains)

    /**
     * Starts the next round on [bridge] if the last one is answered. Returns false if the bridge has left a round unanswered for [ANSWER_S]
     * s.
     */
    fun goOn(bridge: Bridge): Boolean {
        val now = clock.nanos()
        if (isUnderWay) return now - beganNanos <= ANSWER_NANOS
        val round = topics.takeNews().flatMap(::operationsOf)
        if (round.isEmpty() && now - beganNanos < IDLE_NANOS) return true
        isUnderWay = true
        beganNanos = now
        send(bridge, round.map { Outgoing(it) })
        return true
    }

    private fun send(bridge: Bridge, messages: List<Outgoing>) {
        if (messages.isEmpty()) return bridge.ping()
        messages.last().left.whenComplete { _, _ -> bridge.ping() } // sends the ping after all messages
        messages.forEach(bridge::queue)
        bridge.flush()
    }

    private fun operationsOf(news: Topics.News): List<String> {
        val publications = news.messages.map { operation("publish", "topic" to news.name, "msg" to it, "latch" to true) }
        if (!names.add(news.name)) return publications
        isNew()
        return listOf(operation("advertise", "topic" to news.name, "type" to news.type, "latch" to true)) + publications
    }

    fun answered() {
        isUnderWay = false
    }

    companion object {
        const val ANSWER_S = 20L
        private val ANSWER_NANOS = TimeUnit.SECONDS.toNanos(ANSWER_S)

        /** The interval between pings while there are no messages. */
        private val IDLE_NANOS = TimeUnit.SECONDS.toNanos(3)
    }
}
