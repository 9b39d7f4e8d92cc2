package argo.filters.matching

import argo.filters.Condition
import argo.filters.CriticalRule
import argo.filters.HeadScanner
import argo.filters.PerceptionFilter
import argo.filters.PerceptionFilter.Mode
import argo.filters.SmoothingRule

/**
 * Applies a filter's rules to percepts. Immutable, and safe for use by several threads at once.
 *
 * A matcher treats each percept as the first of its sensor: no rate holds the percept back, and no smoothing rule replaces it. Rates,
 * smoothing rules and second limits depend on time and on earlier percepts. Only a [FilterSession] knows the time and the earlier
 * percepts.
 */
class PerceptMatcher internal constructor(
    /** The filter of this matcher. */
    val filter: PerceptionFilter,
    before: PerceptMatcher? = null, // critical rules in both filters stay identical objects, so a hysteresis knows them
) {
    private val index = RuleIndex(filter.rules.map { CompiledRule(it) })
    private val critical: List<CompiledRule> =
        filter.critical.map { rule -> before?.critical?.find { it.critical == rule } ?: CompiledRule(rule.rule, rule) }
    private val criticalIndex = if (critical.isEmpty()) null else RuleIndex(critical)
    private val smoothingIndex =
        if (filter.smoothing.isEmpty()) null else RuleIndex(filter.smoothing.map { CompiledRule(it.rule, smoothing = it) })
    private val drops = filter.mode == Mode.DROP

    /** True if a condition has two limits. [Hysteresis] then decides. */
    internal val hasHysteresis: Boolean = (filter.rules + filter.critical.map { it.rule })
        .any { rule -> rule.conditions.any { it is Condition.Argument && it.until != null } }

    /**
     * True if no smoothing rule has a condition on a smoothed argument. The rule for a percept then does not depend on the percept's
     * number.
     */
    internal val smoothsByName: Boolean = filter.smoothing.map { it.argument }.toSet().let { smoothed ->
        filter.smoothing.none { smoothing -> smoothing.rule.conditions.any { it is Condition.Argument && it.index in smoothed } }
    }

    /**
     * Returns true if the filter drops the percept in [percept] from [start] to [end]. The percept is in the form that boards send:
     * `dist(f,123)`.
     *
     * Keeps text that is no percept, so its reader can report it. Never throws for positions inside the text. Allocates nothing for a
     * percept without a namespace if all conditions are on arguments that are plain atoms or numbers.
     */
    @JvmOverloads
    fun drops(percept: CharSequence, start: Int = 0, end: Int = percept.length): Boolean =
        scan(percept, start, end, false) { functor, functorEnd, tail, head ->
            isDropped(percept, functor, functorEnd, end, tail, head, null) && (criticalIndex == null ||
                firstMet(criticalIndex, percept, functor, functorEnd, end, tail, head, null) { true } == null)
        }

    /** Returns true if the ordinary rules drop [percept]. A critical rule may still keep [percept]. */
    internal fun drops(percept: String, hysteresis: Hysteresis?): Boolean =
        scan(percept, 0, percept.length, false) { functor, functorEnd, tail, head ->
            isDropped(percept, functor, functorEnd, percept.length, tail, head, hysteresis)
        }

    private fun isDropped(
        text: CharSequence, functor: Int, functorEnd: Int, end: Int, tail: Long, head: HeadScanner?, hysteresis: Hysteresis?,
    ): Boolean = (firstMet(index, text, functor, functorEnd, end, tail, head, hysteresis) { !drops || it.rate == null } != null) == drops

    /**
     * Returns the first rule of [index] that the percept meets and for which [counts] returns true, or null. Also applies later rules
     * with two limits, so [hysteresis] records what holds.
     */
    private inline fun firstMet(
        index: RuleIndex, text: CharSequence, functor: Int, functorEnd: Int, end: Int, tail: Long, head: HeadScanner?,
        hysteresis: Hysteresis?, counts: (CompiledRule) -> Boolean,
    ): CompiledRule? {
        var first: CompiledRule? = null
        for (rule in index.find(text, functor, functorEnd)) {
            if (first != null && !rule.hasHysteresis || !counts(rule) || !rule.isFor(tail, head)) continue
            if (rule.areMet(text, functorEnd, end, tail, hysteresis) && first == null) first = rule
        }
        return first
    }

    internal fun smoothingRule(text: String, functor: Int, functorEnd: Int, tail: Long, head: HeadScanner?): CompiledRule? =
        smoothingIndex?.let { firstMet(it, text, functor, functorEnd, text.length, tail, head, null) { true } }

    /** Returns the critical rules that the text [percept] meets, in the order of the filter. Never throws. */
    fun criticalRules(percept: String): List<CriticalRule> = PerceptText.of(percept)?.let { criticalRules(it, it, null) }.orEmpty()

    /** Explains why the filter keeps or drops the text [percept]. */
    fun explain(percept: String): Explanation =
        PerceptText.of(percept)?.let { Explanation.ofFirst(this, it) } ?: Explanation.noPercept(percept, filter)

    /** Returns the matching critical rules. Smoothed rules test [standing], which replaces [received]. Other rules test [received]. */
    internal fun criticalRules(received: PerceptText, standing: PerceptText, hysteresis: Hysteresis?): List<CriticalRule> {
        val index = criticalIndex ?: return emptyList()
        return received.rulesIn(index).mapNotNull { rule ->
            rule.critical?.takeIf { (if (it.smoothed) standing else received).meets(rule, hysteresis) }
        }
    }

    /** Returns true if a percept is dropped for good. It meets exactly the rules in [met]; none of them is critical. */
    internal fun drops(met: List<CompiledRule>): Boolean = if (drops) met.any { it.rate == null } else met.isEmpty()

    internal fun rulesOn(percept: PerceptText): List<CompiledRule> = percept.rulesIn(index)

    internal fun rulesMetBy(percept: PerceptText, hysteresis: Hysteresis?): List<CompiledRule> =
        percept.rulesIn(index).filter { percept.meets(it, hysteresis) }

    /** Returns the first smoothing rule that [percept] meets, or null. */
    internal fun smoothingRule(percept: PerceptText): SmoothingRule? =
        smoothingIndex?.let { index -> percept.rulesIn(index).find { percept.meets(it, null) }?.smoothing }
}

/** Compiles the filter. Make one matcher and use it for every percept. */
fun PerceptionFilter.matcher(): PerceptMatcher = PerceptMatcher(this)
