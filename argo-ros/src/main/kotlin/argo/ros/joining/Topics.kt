package argo.ros.joining

import kotlinx.serialization.json.JsonObject

/**
 * A participant's topics: the type of each, and its newest messages. A new message waits until the bridge has read the earlier ones, so a
 * slow bridge delays no thread and gets no old messages. Safe for use by several threads; no function waits. [warn] takes warnings for the
 * user, each text once.
 */
internal class Topics(private val warn: (String) -> Unit) {
    private class Topic(val type: String) {
        var newest: List<JsonObject> = emptyList()
        var isWaiting = false
    }

    class News(val name: String, val type: String, val messages: List<JsonObject>)

    private val topics = LinkedHashMap<String, Topic>() // guarded by this

    /** The publishing thread calls this when messages wait. */
    @Volatile
    var onNews: () -> Unit = {}

    val types: Map<String, String> get() = synchronized(this) { topics.mapValues { it.value.type } }

    /** Publishes [messages] of one moment. A topic keeps the type of its first message. There are at most [MAX_TOPICS] topics. */
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

    /** Returns the waiting messages and removes them. */
    fun takeNews(): List<News> = synchronized(this) {
        topics.filterValues { it.isWaiting }.map { (name, topic) ->
            topic.isWaiting = false
            News(name, topic.type, topic.newest)
        }
    }

    /** Lets the newest messages of all topics wait again, for a graph that does not have them. */
    fun renew() = synchronized(this) { topics.values.forEach { it.isWaiting = true } }

    companion object {
        /** The largest number of topics, since a board may invent names. */
        const val MAX_TOPICS = 1_000
    }
}
