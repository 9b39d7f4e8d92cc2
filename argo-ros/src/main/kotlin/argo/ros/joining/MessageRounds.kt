package argo.ros.joining

import argo.ros.bridge.Bridge
import argo.ros.bridge.Outgoing
import argo.ros.bridge.operation
import javino.LineClock
import java.util.concurrent.TimeUnit

/**
 * Sends the newest messages of [topics] to a bridge in rounds. A round begins only when the bridge has read the previous round, as its
 * answer to a ping shows. For one thread; only [answered] may be called by another thread.
 */
internal class MessageRounds(private val topics: Topics, private val clock: LineClock, private val isNew: () -> Unit) {
    private val names = HashSet<String>()
    private var beganNanos = clock.nanos()

    @Volatile
    private var isUnderWay = false

    /** The advertised topics, with their types. */
    val advertised: Map<String, String> get() = topics.types.filterKeys(names::contains)

    /** Begins a round on [bridge], unless one is under way. Returns false if the bridge has left a round unanswered for [ANSWER_S] s. */
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
        messages.last().left.whenComplete { _, _ -> bridge.ping() } // so the ping goes out behind all messages
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

        /** The time from one ping to the next while there are no messages. */
        private val IDLE_NANOS = TimeUnit.SECONDS.toNanos(3)
    }
}
