package argo.ros.serving

import argo.ros.bridge.operation
import kotlinx.serialization.json.JsonObject
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.CopyOnWriteArrayList

/** Takes published messages. Called by any thread, and returns at once. */
internal fun interface TopicReader {
    /**
     * Takes [operation], which was published on [topic].
     *
     * @param isEvent whether it is an event, which the next message does not replace
     */
    fun published(topic: String, operation: String, isEvent: Boolean)
}

/**
 * The topics of the graph: the type of each, and its newest message. Safe for use by several threads.
 *
 * @param warn takes warnings for a person, each text once
 */
internal class Topics(private val warn: (String) -> Unit) {
    private class Topic(val type: String) {
        @Volatile
        var newest: String? = null
    }

    private val topics = ConcurrentHashMap<String, Topic>()
    private val readers = CopyOnWriteArrayList<TopicReader>()

    /** The types of all topics, by their names. */
    val types: Map<String, String> get() = topics.mapValues { it.value.type }

    fun add(reader: TopicReader) {
        readers += reader
    }

    fun remove(reader: TopicReader) {
        readers -= reader
    }

    /** Publishes [message]. A topic keeps the type of its first message, and a graph has [MAX_TOPICS] topics. */
    fun publish(name: String, type: String, message: JsonObject, isEvent: Boolean = false) {
        val topic = topics[name] ?: declare(name, type) ?: return
        if (topic.type != type) return warn("$name has the type ${topic.type}; a percept of the type $type is not published")
        val operation = operation("publish", "topic" to name, "msg" to message)
        if (!isEvent) topic.newest = operation
        readers.forEach { it.published(name, operation, isEvent) }
    }

    private fun declare(name: String, type: String): Topic? {
        if (topics.size >= MAX_TOPICS) {
            warn("there are $MAX_TOPICS topics; percepts that need more are not published")
            return null
        }
        return topics.computeIfAbsent(name) { Topic(type) }
    }

    /** Returns the newest message of [topic], which a subscriber gets at once; null: there is none. */
    fun newest(topic: String): String? = topics[topic]?.newest

    /** Forgets the topics below [base]. */
    fun removeBelow(base: String) {
        topics.keys.removeIf { it.startsWith("$base/") }
    }

    companion object {
        /** The largest number of topics: a board may make up names. */
        const val MAX_TOPICS = 1_000
    }
}
