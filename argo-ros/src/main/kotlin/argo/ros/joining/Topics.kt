package argo.ros.joining

import kotlinx.serialization.json.JsonObject

/**
 * The topics of a participant, with their types and newest messages. A new message waits until the bridge has read the earlier ones. A
 * newer message replaces a waiting one. Safe for use by several threads. No function waits. [warn] takes warnings for the user, each text
 * once.
 */
internal class Topics(private val warn: (String) -> Unit) {
    private class Topic(val type: String) {
        var newest: List<JsonObject> = emptyList()
        var isWaiting = false
    }

    class News(val name: String, val type: String, val messages: List<JsonObject>)

    private val topics = LinkedHashMap<String, Topic>() // guarded by this

    /** Called when messages wait. */
    @Volatile
    var onNews: () -> Unit = {}

    val types: Map<String, String> get() = synchronized(this) { topics.mapValues { it.value.type } }

    /**
     * Publishes [messages] that belong to one moment. A topic keeps the type of its first message. Publishes at most [MAX_TOPICS] topics.
     */
    fun publish(name: String, type: String, messages: List<JsonObject>) {
        synchronized(this) {
            val topic = topics[name] ?: Topic(type).takeIf { topics.size < MAX_TOPICS }?.also { topics[name] = it }
                ?: return warn("there are $MAX_TOPICS topics; percepts that need more are not published")
            if (topic.type != type) return warn("$name has the type ${topic.type}; a percept of the type $type is not published")
            topic.newest = messages
            topic.isWaiting = true
        }
        onNews()
    }

    fun takeNews(): List<News> = synchronized(this) {
        topics.filterValues { it.isWaiting }.map { (name, topic) ->
            topic.isWaiting = false
            News(name, topic.type, topic.newest)
        }
    }

    /** Queues the newest messages of all topics again, for a new graph. */
    fun renew() = synchronized(this) { topics.values.forEach { it.isWaiting = true } }

    companion object {
        /** The greatest number of topics, since a board may send any names. */
        const val MAX_TOPICS = 1_000
    }
}
