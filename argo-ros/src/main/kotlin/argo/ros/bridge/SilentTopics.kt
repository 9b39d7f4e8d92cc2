package argo.ros.bridge

import java.util.concurrent.TimeUnit

/** For how long each topic that is subscribed to has said nothing. Not safe for use by several threads at once. */
internal class SilentTopics {
    private val dueNanos = HashMap<String, Long>()

    /** Only [topics] are subscribed to, those that were not before since [nowNanos]. */
    fun keepOnly(topics: Collection<String>, nowNanos: Long) {
        dueNanos.keys.retainAll(topics.toSet())
        topics.forEach { dueNanos.putIfAbsent(it, nowNanos + LIMIT_NANOS) }
    }

    /** A message of [topic] has come at [nowNanos]. */
    fun heard(topic: String, nowNanos: Long) {
        dueNanos[topic] = nowNanos + LIMIT_NANOS
    }

    /** The topics that have said nothing for [LIMIT_NANOS] at [nowNanos], each again after that time: it may come with another type. */
    fun next(nowNanos: Long): List<String> = dueNanos.filterValues { nowNanos - it > 0 }.keys.toList()
        .onEach { dueNanos[it] = nowNanos + LIMIT_NANOS }

    companion object {
        /** After how long a silence is worth a question, in ns. */
        val LIMIT_NANOS = TimeUnit.SECONDS.toNanos(5)
    }
}
