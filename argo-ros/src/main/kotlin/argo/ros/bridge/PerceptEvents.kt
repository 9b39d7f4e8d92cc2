package argo.ros.bridge

/** A percept that a message of [topic] gave when it came. The message was true at [trueNanos], by the platform's clock. */
internal class Percept(val topic: String, val text: String, val trueNanos: Long, val receivedNanos: Long)

/**
 * Percepts of which each is an event, the oldest first. If more than [MAX_EVENTS] wait, the oldest are lost, and [warn] takes their number
 * at each power of two. Not safe for use by several threads at once.
 */
internal class PerceptEvents(private val warn: (String) -> Unit) {
    private val waiting = ArrayDeque<Percept>()
    private var last: String? = null // the event in the message before; null: that message had no event
    private var lost = 0L

    val isEmpty: Boolean get() = waiting.isEmpty()

    /** True if the next message has another event than the message before. */
    val isNew: Boolean get() = waiting.isNotEmpty() || last != null

    fun add(percept: Percept) {
        waiting += percept
        if (waiting.size <= MAX_EVENTS) return
        val topic = waiting.removeFirst().topic
        if ((++lost).countOneBits() == 1) warn("$lost events of $topic and others are lost, since more than $MAX_EVENTS waited")
    }

    /** Takes the next event; null: there is none. Between two equal events one call returns null, so that both events count. */
    fun next(): Percept? {
        val next = waiting.firstOrNull()?.takeIf { it.text != last }
        last = next?.text
        return next?.also { waiting.removeFirst() }
    }

    fun keepOnly(topics: Set<String>) {
        waiting.removeIf { it.topic !in topics }
    }

    fun clear() = waiting.clear()

    private companion object {
        /** The most events that wait for the sensing thread. */
        const val MAX_EVENTS = 1_000
    }
}
