package argo.filters.matching

import argo.filters.CriticalRule
import argo.filters.HeadScanner
import argo.filters.PerceptionFilter
import argo.filters.PerceptionFilter.Mode

/**
 * Decides over percepts by a filter's rules. Immutable; any thread may use it.
 *
 * Rules with a [rate][argo.filters.Rate] depend on time and on earlier percepts, which only a [FilterSession] knows. A matcher treats each
 * percept as the first of its kind, which no rate holds back.
 */
class PerceptMatcher internal constructor(
    /** The filter of this matcher. */
    val filter: PerceptionFilter,
) {
    private val index = RuleIndex(filter.rules.map { CompiledRule(it) })
    private val criticalIndex = if (filter.critical.isEmpty()) null else RuleIndex(filter.critical.map { CompiledRule(it.rule, it) })
    private val drops = filter.mode == Mode.DROP

    /**
     * Returns true if the filter drops the percept in [percept] from [start] to [end], in the text of the line: `dist(f,123)`.
     *
     * Text that is no percept is kept, so that its reader can report it. Never throws for positions inside the text. Allocates nothing for
     * a percept without a namespace if all conditions are on arguments that are plain atoms or numbers.
     */
    @JvmOverloads
    fun drops(percept: CharSequence, start: Int = 0, end: Int = percept.length): Boolean =
        scan(percept, start, end, false) { functor, functorEnd, tail, head ->
            isMet(index, drops, percept, functor, functorEnd, end, tail, head) == drops &&
                (criticalIndex == null || !isMet(criticalIndex, false, percept, functor, functorEnd, end, tail, head))
        }

    /** Returns true if the percept meets a rule of [index]. If [timeless], only rules without a rate count. */
    private fun isMet(
        index: RuleIndex, timeless: Boolean, text: CharSequence, functor: Int, functorEnd: Int, end: Int, tail: Long, head: HeadScanner?,
    ): Boolean {
        for (rule in index.find(text, functor, functorEnd)) {
            if (timeless && rule.rate != null) continue
            if (rule.isFor(tail, head) && rule.areMet(text, functorEnd, end, tail)) return true
        }
        return false
    }

    /** Returns the critical rules that the text [percept] meets, in the order of the filter. Never throws. */
    fun criticalRules(percept: String): List<CriticalRule> = PerceptText.of(percept)?.let(::criticalRules).orEmpty()

    /** Explains why the filter keeps or drops the text [percept]. */
    fun explain(percept: String): Explanation =
        PerceptText.of(percept)?.let { Explanation.of(this, it) } ?: Explanation.noPercept(percept, filter)

    internal fun criticalRules(percept: PerceptText): List<CriticalRule> {
        val index = criticalIndex ?: return emptyList()
        return percept.rulesIn(index).filter(percept::meets).mapNotNull { it.critical }
    }

    /** Returns true if a percept that [met] exactly these rules, none of them critical, is dropped for good. */
    internal fun drops(met: List<CompiledRule>): Boolean = if (drops) met.any { it.rate == null } else met.isEmpty()

    internal fun rulesOn(percept: PerceptText): List<CompiledRule> = percept.rulesIn(index)

    internal fun rulesMetBy(percept: PerceptText): List<CompiledRule> = percept.rulesIn(index).filter(percept::meets)
}

/** Compiles the filter. Make the matcher once and use it for every percept. */
fun PerceptionFilter.matcher(): PerceptMatcher = PerceptMatcher(this)
