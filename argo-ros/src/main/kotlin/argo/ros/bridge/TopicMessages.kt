package argo.ros.bridge

import argo.links.BoardMessage
import argo.ros.mapping.MessageScope
import argo.ros.mapping.PerceptRule
import argo.ros.mapping.fields
import kotlinx.serialization.json.JsonObject
import java.util.concurrent.TimeUnit

/**
 * The newest message of each topic, and the percepts that they are. Not safe for use by several threads at once.
 *
 * @param rules what messages become
 * @param warn takes why a message is not what a rule expects, once until a message is
 */
internal class TopicMessages(private val rules: List<PerceptRule>, private val warn: (String) -> Unit) {
    private class Newest(val message: JsonObject, val trueNanos: Long, val receivedNanos: Long)

    private val newest = HashMap<String, Newest>()
    private val unfit = HashSet<PerceptRule>()
    private var isNew = false
    private var expiryNanos: Long? = null // when the message changes although none comes

    /** A [message] of [topic] has come at [receivedNanos] that is of [trueNanos], both by the platform's clock. */
    fun add(topic: String, message: JsonObject, trueNanos: Long, receivedNanos: Long) {
        newest[topic] = Newest(message, trueNanos, receivedNanos)
        isNew = true
    }

    /** Only [topics] are subscribed to: what the others said is of another time. */
    fun keepOnly(topics: Collection<String>) {
        if (newest.keys.retainAll(topics.toSet())) isNew = true
    }

    /** Forgets everything. */
    fun clear() {
        newest.clear()
        isNew = false
        expiryNanos = null
    }

    /** Whether [take] has something new at [nowNanos]. */
    fun hasNews(nowNanos: Long): Boolean = isNew || expiryNanos?.let { it - nowNanos <= 0 } == true

    /** When there is news though no message comes; null: never. */
    fun dueNanos(): Long? = expiryNanos

    /** All that holds at [nowNanos], in the order of the rules. */
    fun take(nowNanos: Long): BoardMessage {
        isNew = false
        expiryNanos = null
        val seen = LinkedHashMap<String, Long>()
        for (rule in rules) {
            val message = newest[rule.topic] ?: continue
            if (rule.forMs != null && !isYoung(message, rule.forMs, nowNanos)) continue
            val text = textOf(rule, message.message) ?: continue
            seen.merge(text, message.trueNanos) { one, other -> if (other - one > 0) other else one }
        }
        val received = newest.values.map { it.receivedNanos }.maxWithOrNull { a, b -> (a - b).compareTo(0) } ?: nowNanos
        return BoardMessage(seen.keys.joinToString("") { "$it;" }, received, seen)
    }

    private fun isYoung(message: Newest, forMs: Int, nowNanos: Long): Boolean {
        val end = message.receivedNanos + TimeUnit.MILLISECONDS.toNanos(forMs.toLong())
        if (end - nowNanos <= 0) return false
        if (expiryNanos?.let { it - end > 0 } != false) expiryNanos = end
        return true
    }

    private fun textOf(rule: PerceptRule, message: JsonObject): String? {
        val scope = MessageScope(message)
        val text = if (rule.conditions.all { it.holdsIn(scope) }) rule.percept.textIn(scope) else null
        val missing = if (text == null) missingIn(rule, message) else null
        if (missing == null) {
            unfit -= rule
        } else if (unfit.add(rule)) {
            warn("line ${rule.place.line}: a message of ${rule.topic} has no ${missing.joinToString(".")}; is it still a ${rule.type}?")
        }
        return text
    }

    /** A field that the rule uses and the message does not have at all, not even without a value. */
    private fun missingIn(rule: PerceptRule, message: JsonObject): List<String>? =
        rule.fields().map { it.path }.find { it.first() !in message }
}
