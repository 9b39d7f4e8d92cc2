package argo.filters.matching

import argo.filters.CriticalRule
import argo.filters.FunctorScanner
import argo.filters.PerceptionFilter
import argo.filters.PerceptionFilter.Mode
import argo.filters.Predicate
import argo.filters.Rate
import argo.filters.Syntax

/**
 * Decides over percepts by a filter's rules.
 *
 * Immutable; any thread may use it. For percepts that are Jason literals there are extensions of the same names in this package.
 * Rules with a [Rate] need to know the time and what came before, which a [FilterSession] does; a matcher takes each percept for the first
 * of its kind, which no rate holds back.
 */
class PerceptMatcher internal constructor(
    /** What the matcher was compiled from. */
    val filter: PerceptionFilter,
) {
    private val index = RuleIndex(filter.rules.map { CompiledRule(it) })
    private val criticalIndex = if (filter.critical.isEmpty()) null else RuleIndex(filter.critical.map { CompiledRule(it.rule, it) })
    private val drops = filter.mode == Mode.DROP

    /**
     * Whether the filter drops the percept that [percept] holds from [start] to [end], as it came off the line: `dist(f,123)`.
     *
     * Text that is not a percept is kept, so that whoever reads it can report it. Never throws for positions inside the text. Allocates
     * nothing as long as the percept's functor is a word without namespace and conditions are on arguments that are plain atoms or numbers.
     */
    @JvmOverloads
    fun drops(percept: CharSequence, start: Int = 0, end: Int = percept.length): Boolean =
        scan(percept, start, end, false) { functor, functorEnd, negated, namespace -> drops(percept, functor, functorEnd, end, negated, namespace) }

    /**
     * The critical rules that the percept meets which [percept] is the text of, in the order of the filter. Never throws. Allocates nothing
     * for a percept that meets none, as far as [drops] does not.
     */
    fun criticalRules(percept: CharSequence): List<CriticalRule> {
        val index = criticalIndex ?: return emptyList()
        val end = percept.length
        return scan(percept, 0, end, emptyList()) { functor, functorEnd, negated, namespace ->
            val rules = index.find(percept, functor, functorEnd)
            val tail = if (rules.isEmpty()) Outline.NONE.toLong() else tail(percept, functor, functorEnd, end, negated)
            if (tail < 0) emptyList() else met(rules, percept, functorEnd, end, tail, negated, namespace)
        }
    }

    private fun met(rules: Array<CompiledRule>, text: CharSequence, functorEnd: Int, end: Int, tail: Long, negated: Boolean, namespace: String): List<CriticalRule> {
        if (!meetsAny(rules, text, functorEnd, end, tail, negated, namespace)) return emptyList()
        return rules.filter { it.isFor(negated, namespace, Outline.arity(tail)) && it.meets(text, functorEnd, end, tail) }.mapNotNull { it.critical }
    }

    /** Finds the head of a percept and does with it what [found] says; [none] if there is none. */
    private inline fun <T> scan(percept: CharSequence, start: Int, end: Int, none: T, found: (functor: Int, functorEnd: Int, negated: Boolean, namespace: String) -> T): T {
        var functor = Syntax.skipBlanks(percept, start, end)
        val negated = functor < end && percept[functor] == '~'
        if (negated) functor = Syntax.skipBlanks(percept, functor + 1, end)
        if (functor < end && percept[functor] in 'a'..'z') {
            val wordEnd = Syntax.wordEnd(percept, functor, end)
            if (wordEnd == end || percept[wordEnd] == '(' || percept[wordEnd] == '[') {
                return found(functor, wordEnd, negated, Predicate.DEFAULT_NAMESPACE)
            }
        }
        val head = FunctorScanner(percept, start, end)
        return if (head.scan()) found(head.functorStart, head.functorEnd, head.negated, head.namespace) else none
    }

    private fun drops(text: CharSequence, functor: Int, functorEnd: Int, end: Int, negated: Boolean, namespace: String): Boolean {
        val rules = index.find(text, functor, functorEnd)
        if (rules.isEmpty() && drops) return false
        val tail = tail(text, functor, functorEnd, end, negated)
        if (tail < 0 || meetsTimeless(rules, text, functorEnd, end, tail, negated, namespace) != drops) return false
        return criticalIndex == null || !meetsAny(criticalIndex.find(text, functor, functorEnd), text, functorEnd, end, tail, negated, namespace)
    }

    /** Whether the percept meets one of [rules] that decides by itself; in a filter that drops, those with rates do not. */
    private fun meetsTimeless(rules: Array<CompiledRule>, text: CharSequence, functorEnd: Int, end: Int, tail: Long, negated: Boolean, namespace: String): Boolean {
        val arity = Outline.arity(tail)
        for (rule in rules) {
            if (rule.rate != null && drops) continue
            if (rule.isFor(negated, namespace, arity) && rule.meets(text, functorEnd, end, tail)) return true
        }
        return false
    }

    private fun meetsAny(rules: Array<CompiledRule>, text: CharSequence, functorEnd: Int, end: Int, tail: Long, negated: Boolean, namespace: String): Boolean {
        val arity = Outline.arity(tail)
        for (rule in rules) if (rule.isFor(negated, namespace, arity) && rule.meets(text, functorEnd, end, tail)) return true
        return false
    }

    /** What follows the functor, see [Outline.tail]; negative if the text is no percept. */
    private fun tail(text: CharSequence, functor: Int, functorEnd: Int, end: Int, negated: Boolean): Long {
        if (Syntax.isReserved(text, functor, functorEnd)) return Outline.NONE.toLong()
        val tail = Outline.tail(text, functorEnd, end)
        return if (isWritable(text, functor, functorEnd, end, negated)) tail else Outline.NONE.toLong()
    }

    /** Why the filter keeps or drops the percept that [percept] is the text of. */
    fun explain(percept: CharSequence): Explanation =
        TextForm.of(percept)?.let { Explanation.of(this, it) } ?: Explanation.noPercept(percept.toString(), filter)

    /** Truth values stand alone. */
    private fun isWritable(text: CharSequence, functor: Int, functorEnd: Int, end: Int, negated: Boolean) =
        !Syntax.isTruthValue(text, functor, functorEnd) || !negated && Syntax.skipBlanks(text, functorEnd, end) == end

    internal fun drops(percept: PerceptForm): Boolean = drops(rulesThatMeet(percept)) && criticalRules(percept).isEmpty()

    internal fun criticalRules(percept: PerceptForm): List<CriticalRule> {
        val index = criticalIndex ?: return emptyList()
        return rulesOn(percept, index).filter { it.meets(percept) }.mapNotNull { it.critical }
    }

    /** Whether a percept that [met] just these rules, and no critical one, is dropped for good. */
    internal fun drops(met: List<CompiledRule>): Boolean = if (drops) met.any { it.rate == null } else met.isEmpty()

    internal fun rulesOn(percept: PerceptForm): List<CompiledRule> = rulesOn(percept, index)

    private fun rulesOn(percept: PerceptForm, index: RuleIndex): List<CompiledRule> {
        val predicate = percept.predicate
        return index.find(predicate.functor, 0, predicate.functor.length)
            .filter { it.isFor(predicate.negated, predicate.namespace, percept.arity) }
    }

    internal fun rulesThatMeet(percept: PerceptForm): List<CompiledRule> = rulesOn(percept).filter { it.meets(percept) }
}

/** Compiles the filter. The matcher is to be made once and used for every percept. */
fun PerceptionFilter.matcher(): PerceptMatcher = PerceptMatcher(this)
