package argo.ros.bridge

import java.util.concurrent.TimeUnit

/** For how long each topic that is subscribed to has said nothing. Not safe for use by several threads at once. */
internal class SilentTopics {
    private val sinceNanos = HashMap<String, Long>()
    private val named = HashSet<String>()

    /** Only [topics] are subscribed to, those that were not before since [nowNanos]. */
    fun keepOnly(topics: Collection<String>, nowNanos: Long) {
        sinceNanos.keys.retainAll(topics.toSet())
        named.retainAll(topics.toSet())
        topics.forEach { sinceNanos.putIfAbsent(it, nowNanos) }
    }

    /** A message of [topic] has come at [nowNanos]. */
    fun heard(topic: String, nowNanos: Long) {
        sinceNanos[topic] = nowNanos
        named -= topic
    }

    /** The topics that have said nothing for [LIMIT_NANOS] at [nowNanos], each once until it says something. */
    fun next(nowNanos: Long): List<String> = sinceNanos.filterValues { nowNanos - it > LIMIT_NANOS }.keys.filter(named::add)

    companion object {
        /** After how long a silence is worth a question, in ns. */
        val LIMIT_NANOS = TimeUnit.SECONDS.toNanos(5)
    }
}
