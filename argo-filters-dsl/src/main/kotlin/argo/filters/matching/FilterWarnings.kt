package argo.filters.matching

import argo.filters.Condition
import argo.filters.CriticalRule
import argo.filters.GroundTerm
import argo.filters.PerceptionFilter
import argo.filters.PerceptionFilter.Mode
import argo.filters.Predicate
import argo.filters.Rule
import argo.filters.SmoothingRule
import argo.filters.nameProblem

/**
 * Finds parts of the filter that have no effect. Returns a sentence for each. Such parts are:
 * - rules that no percept can match;
 * - superfluous rules and conditions;
 * - deadbands and smoothing on missing arguments;
 * - smoothing of a single number;
 * - critical rules on smoothed percepts that no rule smooths;
 * - a filter without rules, or with a name that no agent can ask for.
 *
 * Rules are counted from 1. A reported part never has an effect. Not every part without effect is reported.
 */
fun PerceptionFilter.warnings(): List<String> {
    val ordinary = rules.mapIndexed { number, rule -> ReviewedRule("rule", number, rule) }
    val first = critical.mapIndexed { number, rule -> ReviewedRule("critical rule", number, rule.rule, rule) }
    val smooth = smoothing.mapIndexed { number, rule -> ReviewedRule("smoothing rule", number, rule.rule, smoothing = rule) }
    val smoothed = smoothing.map { it.rule.predicate }.toSet()
    return listOfNotNull(unaskable(), emptiness()) + reviewedSmoothing(smooth) + first.mapNotNull { it.unsmoothed(smoothed) } +
        reviewed(first, emptyList()) + reviewed(ordinary, first.filter { it.seesWhatRulesSee(smoothed) })
}

private fun PerceptionFilter.unaskable(): String? =
    nameProblem(name)?.let { "no agent can ask for a filter of the name '$name': $it" }

private fun PerceptionFilter.emptiness(): String? = when {
    rules.isNotEmpty() || critical.isNotEmpty() || smoothing.isNotEmpty() && mode == Mode.DROP -> null
    mode == Mode.KEEP -> "the filter has no rules, so it drops every percept"
    else -> "the filter has no rules, so it keeps every percept"
}

/** Returns the warnings on smoothing [rules]. The first rule that a percept meets smooths the percept. */
private fun reviewedSmoothing(rules: List<ReviewedRule>): List<String> {
    val all = ComparableRules(rules)
    return rules.flatMap { rule ->
        rule.contradiction()?.let { return@flatMap listOf(it) }
        val other = all.beside(rule).find { it.number < rule.number && it.covers(rule) }
        if (other != null) listOf(rule.superfluousBeside(other))
        else rule.superfluousConditions() + rule.missingArguments() + listOfNotNull(rule.fixedArgument())
    }
}

/** Returns the warnings on [rules]. The rules in [first] decide before [rules]. */
private fun reviewed(rules: List<ReviewedRule>, first: List<ReviewedRule>): List<String> {
    val all = ComparableRules(rules)
    val deciding = ComparableRules(first)
    return rules.flatMap { rule ->
        rule.contradiction()?.let { return@flatMap listOf(it) }
        val other = deciding.beside(rule).find { it.covers(rule) } ?: all.beside(rule).find {
            it !== rule && it.makesSuperfluous(rule) && (it.number < rule.number || !rule.makesSuperfluous(it))
        }
        if (other != null) listOf(rule.superfluousBeside(other)) else rule.superfluousConditions() + rule.missingArguments()
    }
}

/** Groups [rules], so that not all pairs of a large filter are compared. */
private class ComparableRules(rules: List<ReviewedRule>) {
    private val groups = rules.groupBy { it.predicate to it.first }

    /** Returns, in their order, all rules that can cover [rule]: a rule for one value of argument 0 covers only rules for this value. */
    fun beside(rule: ReviewedRule): List<ReviewedRule> {
        val general = groups[rule.predicate to null].orEmpty()
        val equal = rule.first?.let { groups[rule.predicate to it] } ?: return general
        return (general + equal).sortedBy { it.number }
    }
}

/** A rule of a filter: its [kind] in messages, its [number] from 0 among those of this kind, and the percepts that it allows. */
private class ReviewedRule(
    kind: String,
    val number: Int,
    private val rule: Rule,
    private val critical: CriticalRule? = null,
    private val smoothing: SmoothingRule? = null,
) {
    private val name = "$kind ${number + 1}"
    private val allowed = AllowedPercepts(rule.conditions)

    val predicate: Predicate get() = rule.predicate

    /** The only value that the conditions allow for argument 0; null: there are several, or none. */
    val first: GroundTerm? = allowed.single(0)

    private fun sentence(finding: String) = "$name ($rule) $finding"

    fun contradiction(): String? {
        val missing = rule.conditions.filterIsInstance<Condition.Argument>().find { isMissing(it.index) }
        val impossible = if (missing != null) "$missing" else allowed.contradiction()
        return impossible?.let { sentence("matches no percept: $it" + if (missing != null) ", and there is no such argument" else "") }
    }

    /**
     * Warns if the critical rule is smoothed, but no smoothing rule has its predicate. [smoothed] are the predicates with smoothing
     * rules.
     */
    fun unsmoothed(smoothed: Set<Predicate>): String? =
        if (critical?.smoothed != true || rule.predicate in smoothed) null
        else sentence("is smoothed, and there is no smoothing rule on ${rule.predicate}")

    /**
     * Returns true if the critical rule tests the percepts that ordinary rules test. [smoothed] are the predicates with smoothing rules.
     */
    fun seesWhatRulesSee(smoothed: Set<Predicate>): Boolean = critical?.smoothed == true || rule.predicate !in smoothed

    /** Returns true if this rule matches every percept that matches [other]. */
    fun covers(other: ReviewedRule): Boolean =
        rule.predicate == other.rule.predicate && (rule.arity == null || rule.arity == other.rule.arity) &&
            rule.conditions.all(other.allowed::imply)

    /** Returns true if this rule makes [other], a rule of the same list, superfluous. */
    fun makesSuperfluous(other: ReviewedRule): Boolean {
        val doesAtLeastAsMuch = when {
            critical != null ->
                critical.smoothed == other.critical?.smoothed && other.critical.reflex.let { it == null || it == critical.reflex }
            // a rule with a rate remembers percepts, so only a rule for exactly equal percepts can replace it
            else -> rule.rate == null || rule.rate == other.rule.rate && other.covers(this)
        }
        return doesAtLeastAsMuch && covers(other)
    }

    fun superfluousBeside(other: ReviewedRule): String {
        val words = when {
            other.smoothing != null -> "smooths all percepts that match it"
            other.critical != null && critical == null -> "keeps all percepts that match it"
            else -> "matches the same percepts"
        }
        return sentence("has no effect: ${other.name} (${other.rule}) $words")
    }

    fun superfluousConditions(): List<String> {
        val needed = rule.conditions.toMutableList()
        return rule.conditions.mapNotNull { condition ->
            val others = needed.toMutableList().also { it.remove(condition) }
            if (!AllowedPercepts(others).imply(condition)) return@mapNotNull null
            needed.remove(condition)
            sentence("does not need its condition '$condition': the other conditions imply it")
        }
    }

    fun missingArguments(): List<String> = rule.rate?.deadbands.orEmpty().mapNotNull { it.argument }.filter(::isMissing)
        .map { sentence("has a deadband on argument $it, and there is no such argument") } +
        listOfNotNull(smoothing?.argument).filter(::isMissing).map { sentence("smooths argument $it, and there is no such argument") }

    /** Warns if the conditions of a smoothing rule allow only one value of the smoothed argument. */
    fun fixedArgument(): String? = smoothing?.argument?.takeIf(allowed::isFixed)
        ?.let { sentence("smooths argument $it, and has a condition that leaves nothing to smooth there") }

    private fun isMissing(index: Int) = rule.arity?.let { index >= it } == true
}
