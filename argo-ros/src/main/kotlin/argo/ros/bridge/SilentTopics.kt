package argo.ros.bridge

import java.util.concurrent.TimeUnit

/** Measures how long each subscribed topic has been silent. Not safe for use by several threads at once. */
internal class SilentTopics {
    private val dueNanos = HashMap<String, Long>()

    /** Forgets all topics except [topics]. The silence of a new topic starts at [nowNanos]. */
    fun keepOnly(topics: Collection<String>, nowNanos: Long) {
        dueNanos.keys.retainAll(topics.toSet())
        topics.forEach { dueNanos.putIfAbsent(it, nowNanos + LIMIT_NANOS) }
    }

    fun heard(topic: String, nowNanos: Long) {
        dueNanos[topic] = nowNanos + LIMIT_NANOS
    }

    /**
     * Returns the topics that have been silent for [LIMIT_NANOS]. If a topic stays silent, it is returned again after another
     * [LIMIT_NANOS].
     */
    fun next(nowNanos: Long): List<String> = dueNanos.filterValues { nowNanos - it > 0 }.keys.toList()
        .onEach { dueNanos[it] = nowNanos + LIMIT_NANOS }

    companion object {
        val LIMIT_NANOS = TimeUnit.SECONDS.toNanos(5)
    }
}
