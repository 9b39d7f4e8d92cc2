package argo.filters

import argo.filters.PerceptionFilter.Mode

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
    private val index = RuleIndex(filter.rules)
    private val drops = filter.mode == Mode.DROP

    /**
     * Whether the filter drops the percept that [percept] holds from [start] to [end], as it came off the line: `dist(f,123)`.
     *
     * Text that is not a percept is kept, so that whoever reads it can report it. Never throws for positions inside the text. Allocates
     * nothing as long as the percept's functor is a word without namespace and conditions are on arguments that are plain atoms or numbers.
     */
    @JvmOverloads
    fun drops(percept: CharSequence, start: Int = 0, end: Int = percept.length): Boolean {
        var functor = Syntax.skipBlanks(percept, start, end)
        val negated = functor < end && percept[functor] == '~'
        if (negated) functor = Syntax.skipBlanks(percept, functor + 1, end)
        if (functor < end && percept[functor] in 'a'..'z') {
            val wordEnd = Syntax.wordEnd(percept, functor, end)
            if (wordEnd == end || percept[wordEnd] == '(' || percept[wordEnd] == '[') {
                return drops(percept, functor, wordEnd, end, negated, Predicate.DEFAULT_NAMESPACE)
            }
        }
        val head = FunctorScanner(percept, start, end)
        return head.scan() && drops(percept, head.functorStart, head.functorEnd, end, head.negated, head.namespace)
    }

    private fun drops(text: CharSequence, functor: Int, functorEnd: Int, end: Int, negated: Boolean, namespace: String): Boolean {
        val rules = index.find(text, functor, functorEnd)
        if (rules.isEmpty() && drops || Syntax.isReserved(text, functor, functorEnd)) return false
        val tail = Outline.tail(text, functorEnd, end)
        if (tail < 0 || !isWritable(text, functor, functorEnd, end, negated)) return false
        val arity = Outline.arity(tail)
        for (rule in rules) {
            if (rule.rate != null && drops) continue
            if (rule.isFor(negated, namespace, arity) && rule.meets(text, functorEnd, end, tail)) return drops
        }
        return !drops
    }

    /** Why the filter keeps or drops the percept that [percept] is the text of. */
    fun explain(percept: CharSequence): Explanation =
        TextForm.of(percept)?.let { Explanation.of(this, it) } ?: Explanation.noPercept(percept.toString(), filter)

    /** Truth values stand alone. */
    private fun isWritable(text: CharSequence, functor: Int, functorEnd: Int, end: Int, negated: Boolean) =
        !Syntax.isTruthValue(text, functor, functorEnd) || !negated && Syntax.skipBlanks(text, functorEnd, end) == end

    internal fun drops(percept: PerceptForm): Boolean = drops(rulesThatMeet(percept))

    /** Whether a percept that [met] just these rules is dropped for good. */
    internal fun drops(met: List<CompiledRule>): Boolean = if (drops) met.any { it.rate == null } else met.isEmpty()

    internal fun rulesOn(percept: PerceptForm): List<CompiledRule> {
        val predicate = percept.predicate
        return index.find(predicate.functor, 0, predicate.functor.length)
            .filter { it.isFor(predicate.negated, predicate.namespace, percept.arity) }
    }

    internal fun rulesThatMeet(percept: PerceptForm): List<CompiledRule> = rulesOn(percept).filter { it.meets(percept) }
}
