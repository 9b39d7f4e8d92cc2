package argo.ros.bridge

import argo.links.BoardMessage
import argo.ros.mapping.MessageScope
import argo.ros.mapping.MessageType
import argo.ros.mapping.Path
import argo.ros.mapping.PerceptRule
import argo.ros.mapping.Scope
import argo.ros.mapping.Value
import argo.ros.mapping.fields
import argo.ros.mapping.perceptIn
import kotlinx.serialization.json.JsonObject
import java.util.concurrent.TimeUnit

/**
 * The newest message of each topic, and the percepts of these messages. Not safe for use by several threads at once.
 *
 * @param typeOf returns the type of a rule's messages, or null if it is not known
 * @param warn takes each reason why a message gives no percept, once
 */
internal class TopicMessages(
    private val rules: List<PerceptRule>,
    private val typeOf: (PerceptRule) -> MessageType?,
    private val warn: (String) -> Unit,
) {
    /** The shortest time between two messages from unthrottled topics, in ns. */
    var intervalNanos = 0L

    private class Newest(val message: JsonObject, val trueNanos: Long, val receivedNanos: Long)

    private val newest = HashMap<String, Newest>()
    private val eachRules = rules.filter { it.needsEach }.groupBy { it.topic }
    private val unthrottled = eachRules.keys + rules.filter { it.frames != null }.map { it.topic }
    private val changing = rules.filter { !it.needsEach }.map { it.topic }.toSet()
    private val lasting = HashMap<PerceptRule, Percept>() // the newest percept of each rule with `if … for`
    private val events = PerceptEvents(warn)
    private val told = HashMap<PerceptRule, HashSet<String>>()
    private val bytes = HashMap<PerceptRule, Set<Path>>() // the byte fields of each rule with a known type
    private var isNew = false
    private var isNewSoon = false // true if news waits for the end of the interval
    private var takenNanos: Long? = null // null before the first take
    private var expiryNanos: Long? = null // the time at which a percept ends without a new message

    /** Adds a [message] of [topic]. [receivedNanos] and [trueNanos] are the platform times at which the message arrived and was true. */
    fun add(topic: String, message: JsonObject, trueNanos: Long, receivedNanos: Long) {
        val last = Newest(message, trueNanos, receivedNanos)
        newest[topic] = last
        eachRules[topic]?.forEach { rule -> textOf(rule, message)?.let { made(rule, Percept(topic, it, trueNanos, receivedNanos)) } }
        if (topic in unthrottled) isNewSoon = isNewSoon || topic in changing else isNew = true
    }

    private fun made(rule: PerceptRule, percept: Percept) {
        if (rule.isOfEach) return events.add(percept)
        val before = lasting.put(rule, percept)
        val endNanos = before?.receivedNanos?.plus(nanosOf(checkNotNull(rule.forMs)))
        if (before?.text != percept.text || endNanos == null || percept.receivedNanos - endNanos >= 0) isNew = true
    }

    fun keepOnly(topics: Collection<String>) {
        val kept = topics.toSet()
        if (newest.keys.retainAll(kept)) isNew = true
        lasting.keys.removeIf { it.topic !in kept }
        events.keepOnly(kept)
    }

    fun hasHeard(topic: String) = topic in newest

    fun forget(topic: String) {
        if (newest.remove(topic) != null) isNew = true
    }

    fun clear() {
        newest.clear()
        lasting.clear()
        events.clear()
        isNew = false
        isNewSoon = false
        expiryNanos = null
    }

    /** Returns true if [take] would return new percepts at [nowNanos]. */
    fun hasNews(nowNanos: Long): Boolean = isNew || events.isNew || dueNanos()?.let { it - nowNanos <= 0 } == true

    /** Returns the platform time at which the percepts change without a new message, or null for never. */
    fun dueNanos(): Long? {
        val soon = if (isNewSoon) takenNanos?.plus(intervalNanos) ?: newest.values.firstOrNull()?.receivedNanos else null
        return listOfNotNull(soon, expiryNanos).minWithOrNull { a, b -> (a - b).compareTo(0) }
    }

    /** Returns all percepts that hold at [nowNanos], in the order of the rules, and the next event. */
    fun take(nowNanos: Long): BoardMessage {
        isNew = false
        isNewSoon = false
        takenNanos = nowNanos
        expiryNanos = null
        val event = events.next()
        val eventText = event?.text ?: "".takeUnless { events.isEmpty }
        val seen = LinkedHashMap<String, Long>()
        for (percept in rules.mapNotNull { heldBy(it, nowNanos) } + listOfNotNull(event)) {
            seen.merge(percept.text, percept.trueNanos) { one, other -> if (other - one > 0) other else one }
        }
        val received = newest.values.map { it.receivedNanos }.maxWithOrNull { a, b -> (a - b).compareTo(0) } ?: nowNanos
        return BoardMessage(seen.keys.joinToString("") { "$it;" }, received, seen, eventText)
    }

    /** Returns the percept of [rule] that holds at [nowNanos]. Returns null without one, or if each percept is an event. */
    private fun heldBy(rule: PerceptRule, nowNanos: Long): Percept? {
        if (rule.isOfEach) return null
        val percept = if (rule.needsEach) lasting[rule] else newest[rule.topic]?.let { message ->
            textOf(rule, message.message)?.let { Percept(rule.topic, it, message.trueNanos, message.receivedNanos) }
        }
        return percept?.takeIf { rule.forMs == null || isYoung(it.receivedNanos, rule.forMs, nowNanos) }
    }

    private fun isYoung(receivedNanos: Long, forMs: Int, nowNanos: Long): Boolean {
        val end = receivedNanos + nanosOf(forMs)
        if (end - nowNanos <= 0) return false
        if (expiryNanos?.let { it - end > 0 } != false) expiryNanos = end
        return true
    }

    private fun nanosOf(ms: Int) = TimeUnit.MILLISECONDS.toNanos(ms.toLong())

    private fun textOf(rule: PerceptRule, message: JsonObject): String? = when (val percept = rule.perceptIn(scopeOf(rule, message))) {
        is Value.Symbol -> percept.text
        is Value.None -> null.also { leftOut(rule, percept.why) }
        else -> null
    }

    private fun scopeOf(rule: PerceptRule, message: JsonObject): Scope {
        val type = typeOf(rule) ?: return MessageScope(message)
        return MessageScope(message, bytes.getOrPut(rule) { type.bytesAmong(rule.fields()) }, type.constants)
    }

    private fun leftOut(rule: PerceptRule, why: String) {
        val reasons = told.getOrPut(rule, ::HashSet)
        if (reasons.size >= MAX_TOLD || !reasons.add(why)) return
        val end = if (reasons.size < MAX_TOLD) "" else "; further reasons are not reported"
        warn("line ${rule.place.line}: a message of ${rule.topic} (${rule.type}) gives no percept ${rule.percept.functor}: $why$end")
    }

    private companion object {
        /** The greatest number of reasons reported for each rule. Reasons contain values of messages, so their number has no limit. */
        const val MAX_TOLD = 3
    }
}
