package argo.ros.bridge

import argo.filters.Condition
import argo.filters.PerceptionFilter
import argo.filters.Predicate
import argo.filters.Rule
import argo.filters.matching.matcher
import argo.links.Wish
import argo.ros.mapping.Expression
import argo.ros.mapping.Frames
import argo.ros.mapping.PerceptRule
import argo.ros.mapping.Value
import argo.ros.mapping.asTerm

/**
 * A subscription to a topic. [throttleMs] is the shortest time between two messages from the bridge, in ms. The bridge queues the newest
 * [queueLength] messages during that time. If [queueLength] is 1, the bridge keeps only the newest message. If [throttleMs] and
 * [queueLength] are 0, the bridge sends each message at once.
 */
internal data class Subscription(val topic: String, val type: String, val throttleMs: Int, val queueLength: Int = 1)

/**
 * Returns the subscriptions for this wish of the agent, one for each topic. Leaves out topics whose percepts the filter drops completely.
 */
internal fun Wish.subscriptions(rules: List<PerceptRule>): List<Subscription> {
    if (!isSensed) return emptyList()
    return rules.groupBy { it.topic }.flatMap { (topic, its) ->
        val kept = its.filter { rule -> filter?.let { dropsAll(it, rule.percept) } != true }
        val everyMs = kept.minOfOrNull { rule -> filter?.let { everyMs(it, rule.percept) } ?: 0 }
        when {
            everyMs == null -> emptyList()
            its.any { it.frames != null } -> Frames.TOPICS.map { Subscription(it, Frames.TYPE, 0, 0) }
            kept.any { it.needsEach } -> listOf(Subscription(topic, its.first().type, 0, 0))
            else -> listOf(Subscription(topic, its.first().type, maxOf(intervalMs.toLong(), everyMs).toInt()))
        }
    }.groupBy { it.topic }.values.map { its -> its.minBy { it.throttleMs } }
}

internal fun dropsAll(filter: PerceptionFilter, percept: Expression.Compound): Boolean {
    if (filter.critical.any { isFor(it.rule, percept) }) return false
    val rules = filter.rules.filter { isFor(it, percept) }
    return when (filter.mode) {
        PerceptionFilter.Mode.DROP -> rules.any { it.rate == null && isAlwaysMet(it, percept) }
        PerceptionFilter.Mode.KEEP -> rules.all { rule -> rule.conditions.any { isMet(it, percept) == false } }
    }
}

/** Returns the time in ms for which [filter] holds back every percept with the form of [percept], or null if it holds back none. */
private fun everyMs(filter: PerceptionFilter, percept: Expression.Compound): Long? {
    val others = filter.critical.map { it.rule } + filter.smoothing.map { it.rule } // these rules inspect each percept
    if (filter.mode != PerceptionFilter.Mode.DROP || others.any { isFor(it, percept) }) return null
    return filter.rules.filter { isFor(it, percept) && isAlwaysMet(it, percept) }
        .mapNotNull { it.rate?.takeIf { rate -> rate.deadbands.isEmpty() }?.everyMs }.maxOrNull()?.coerceAtMost(Int.MAX_VALUE.toLong())
}

private fun isFor(rule: Rule, percept: Expression.Compound) = rule.predicate == Predicate(percept.functor) &&
    (rule.arity == null || rule.arity == percept.arguments.size || Expression.AllFields in percept.arguments)

private fun isAlwaysMet(rule: Rule, percept: Expression.Compound) = rule.conditions.all { isMet(it, percept) == true }

/** Returns true or false if [condition] is so for all percepts with the form of [percept], and null otherwise. */
private fun isMet(condition: Condition, percept: Expression.Compound): Boolean? {
    val index = (condition as? Condition.Argument)?.index ?: return false // messages have no annotations
    if (Expression.AllFields in percept.arguments) return null
    if (index >= percept.arguments.size) return false
    if (percept.arguments[index] !is Expression.Constant) return null
    val terms = percept.arguments.map { ((it as? Expression.Constant)?.value?.asTerm() as? Value.Symbol)?.text ?: "0" }
    val alone = PerceptionFilter("", Rule(percept.functor, condition))
    return alone.matcher().drops(terms.joinToString(",", "${percept.functor}(", ")"))
}
