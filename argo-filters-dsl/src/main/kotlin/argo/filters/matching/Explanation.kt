package argo.filters.matching

import argo.filters.Condition
import argo.filters.GroundTerm
import argo.filters.Operator
import argo.filters.PerceptionFilter
import argo.filters.PerceptionFilter.Mode
import argo.filters.Rule
import argo.filters.SmoothingRule
import argo.filters.TermTest

/**
 * Explains why a filter keeps, drops, replaces or holds back a percept.
 *
 * @property rule the deciding rule, or null if no rule applies to the percept
 * @property reason the reason in words, such as `it matches rule 3: distance where argument 0 is not front`
 */
class Explanation internal constructor(val percept: String, val outcome: Outcome, val rule: Rule?, val reason: String) {

    /** The filter's decision about a percept. */
    enum class Outcome(internal val words: String) {
        KEPT("is kept"),
        DROPPED("is dropped"),

        /** The percept is delivered later. Until then, the agent perceives the last percept of its kind that was let through. */
        HELD_BACK("is held back"),

        /**
         * A smoothing rule replaces the percept by another percept of its sensor. The filter then keeps, drops or holds back the other
         * percept.
         */
        REPLACED("is replaced"),
    }

    /**
     * Returns text such as
     * `distance(right,30) is dropped by filter frontDistance: it matches rule 3: distance where argument 0 is not front`.
     */
    override fun toString(): String = "$percept ${outcome.words}$reason"

    internal companion object {
        fun noFilter(percept: String) = Explanation(percept, Outcome.KEPT, null, ": there is no filter")

        fun noPercept(percept: String, filter: PerceptionFilter) =
            kept(percept, null, filter, "its text is not a percept, and filters leave that to the parser")

        private fun kept(percept: String, rule: Rule?, filter: PerceptionFilter, reason: String) =
            Explanation(percept, Outcome.KEPT, rule, " by filter ${filter.name}: $reason")

        /** Explains what happens to [percept], which may replace [received]. Critical rules that are not smoothed test [received]. */
        fun of(matcher: PerceptMatcher, received: PerceptText, percept: PerceptText, hysteresis: Hysteresis?): Explanation {
            val critical = matcher.criticalRules(received, percept, hysteresis).firstOrNull()
            if (critical != null) {
                val number = matcher.filter.critical.indexOfFirst { it === critical } + 1
                return kept("$percept", critical.rule, matcher.filter, "it matches critical rule $number: $critical")
            }
            val met = matcher.rulesMetBy(percept, hysteresis)
            val rule = met.firstOrNull { matcher.filter.mode == Mode.KEEP || it.rate == null }
            val outcome = if (matcher.drops(met)) Outcome.DROPPED else Outcome.KEPT
            val reason = if (rule == null) notMet(matcher, percept, met, hysteresis) else met(matcher, rule)
            return Explanation("$percept", outcome, rule?.rule, " by filter ${matcher.filter.name}: $reason")
        }

        /** Explains what happens to [percept] if it is the first of its sensor. */
        fun ofFirst(matcher: PerceptMatcher, percept: PerceptText): Explanation {
            val fate = of(matcher, percept, percept, null)
            val smoothing = matcher.smoothingRule(percept) ?: return fate
            val reason = "${fate.reason}; ${by(smoothing, matcher)} another percept of its sensor may stand for it"
            return Explanation(fate.percept, fate.outcome, fate.rule, reason)
        }

        /**
         * Explains that [rule] replaces [received] by another percept, for this [reason]. [of] is the explanation for the other percept.
         */
        fun replaced(matcher: PerceptMatcher, received: PerceptText, rule: CompiledRule, reason: String, of: Explanation): Explanation {
            val why = " by filter ${matcher.filter.name}: ${by(rule.smoothing, matcher)} $reason; $of"
            return Explanation("$received", Outcome.REPLACED, rule.rule, why)
        }

        private fun by(smoothing: SmoothingRule?, matcher: PerceptMatcher) =
            "by smoothing rule ${matcher.filter.smoothing.indexOfFirst { it === smoothing } + 1} ($smoothing)"

        fun heldBack(matcher: PerceptMatcher, percept: PerceptText, hold: Hold<*>, nowMs: Long): Explanation {
            val time = " for another ${hold.dueMs - nowMs} ms by filter ${matcher.filter.name}"
            val reason = "$time: ${met(matcher, hold.rule)}; ${hold.last.percept} stands for it"
            return Explanation("$percept", Outcome.HELD_BACK, hold.rule.rule, reason)
        }

        private fun met(matcher: PerceptMatcher, rule: CompiledRule) = "it matches ${numbered(matcher, rule)}: ${rule.rule}"

        private fun notMet(matcher: PerceptMatcher, percept: PerceptText, met: List<CompiledRule>, hysteresis: Hysteresis?): String {
            val rules = matcher.rulesOn(percept)
            val arguments = if (percept.arity == 1) "1 argument" else "${percept.arity} arguments"
            if (rules.isEmpty()) return "it has no rule on ${percept.predicate()} with $arguments"
            return rules.joinToString("; ") { rule ->
                val number = numbered(matcher, rule)
                if (rule in met) "$number holds nothing back now"
                else "it does not match $number: ${found(percept, percept.failing(rule, hysteresis))}"
            }
        }

        private fun found(percept: PerceptText, condition: Condition): String {
            if (condition is Condition.Annotation) return unmet(condition)
            val (index, test) = condition as Condition.Argument
            val argument = percept.argument(index) ?: return "there is no argument $index"
            return "argument $index is $argument" + if (GroundTerm.ofOrNull(argument) == null) ", which is no value" else expected(test)
        }

        private fun unmet(condition: Condition.Annotation): String =
            if (condition.tests.isEmpty()) "there is no annotation ${condition.name}"
            else condition.tests.joinToString(" and ", "no annotation ${condition.name} ")

        private fun expected(test: TermTest): String = when (test) {
            is TermTest.Matches -> ", which does not match ${test.pattern}"
            is TermTest.OneOf -> ", not one of ${test.values.joinToString()}"
            is TermTest.Compare -> if (test.operator == Operator.NE) "" else ", not ${"$test".removePrefix("is ")}"
        }

        private fun numbered(matcher: PerceptMatcher, rule: CompiledRule) =
            "rule ${matcher.filter.rules.indexOfFirst { it === rule.rule } + 1}"
    }
}
