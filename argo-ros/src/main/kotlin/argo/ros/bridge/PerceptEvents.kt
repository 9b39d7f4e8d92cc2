package argo.ros.bridge

/** A percept from one message of [topic]. The message was true at the platform time [trueNanos]. */
internal class Percept(val topic: String, val text: String, val trueNanos: Long, val receivedNanos: Long)

/**
 * A queue of percepts that are events, the oldest first. If more than [MAX_EVENTS] wait, the oldest are lost. [warn] takes the number of
 * losses at each power of two. Not safe for use by several threads at once.
 */
internal class PerceptEvents(private val warn: (String) -> Unit) {
    private val waiting = ArrayDeque<Percept>()
    private var last: String? = null // the event in the previous message, or null without one
    private var lost = 0L

    val isEmpty: Boolean get() = waiting.isEmpty()

    /** True if [next] would return another value than in its last call. */
    val isNew: Boolean get() = waiting.isNotEmpty() || last != null

    fun add(percept: Percept) {
        waiting += percept
        if (waiting.size <= MAX_EVENTS) return
        val topic = waiting.removeFirst().topic
        if ((++lost).countOneBits() == 1) warn("$lost events of $topic and others are lost, since more than $MAX_EVENTS waited")
    }

    /**
     * Takes the next event, or returns null if there is none. Returns null once between two equal events, so that the agent perceives both.
     */
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
        const val MAX_EVENTS = 1_000
    }
}
