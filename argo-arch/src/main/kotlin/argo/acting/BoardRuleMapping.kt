package argo.acting

import argo.filters.Condition.Argument
import argo.filters.CriticalRule
import argo.filters.GroundTerm
import argo.filters.Operator
import argo.filters.Predicate
import argo.filters.TermTest
import javino.wire.BoardRule
import javino.wire.BoardRule.Condition
import java.math.BigDecimal

/**
 * Returns the board rule that decides like [critical]; null: there is none. A board compares texts and decimal numbers. So both rules
 * decide alike for percepts as boards write them: without namespaces, comments, variables and expressions, with numbers of at most 15
 * digits without an exponent, and with the same number of arguments for each functor.
 */
internal fun boardRuleOf(critical: CriticalRule): BoardRule? {
    val rule = critical.rule
    if (critical.smoothed || rule.arity != null || !isPlain(rule.predicate)) return null
    val conditions = rule.conditions.map { (it as? Argument)?.let(::conditionOf) ?: return null }
    if (!conditions.all { it.isExact(conditions) && it.namesSensor(conditions) }) return null
    return BoardRule("${rule.predicate}", conditions, critical.reflex).takeIf { it.isSendable }
}

private fun conditionOf(condition: Argument): Condition? {
    val test = condition.test as? TermTest.Compare ?: return null
    val value = valueOf(test.value) ?: return null
    val place = (condition.index + 1).takeIf { it <= Condition.MAX_PLACE } ?: return null
    val until = condition.until?.let { decimalOf(it) ?: return null }
    return Condition(place, operatorOf(test.operator), value, until)
}

/**
 * Returns true if a board decides this condition exactly like a filter. For a missing argument a filter's `NE` is false and a board's is
 * true. So another condition must require this argument or a later one.
 */
private fun Condition.isExact(all: List<Condition>) =
    operator() != BoardRule.Operator.DIFFERENT || all.any { it.operator() != BoardRule.Operator.DIFFERENT && it.place() >= place() }

/**
 * Returns true if the condition has one limit, or if all other conditions only say for which sensor it is. A filter remembers for each
 * sensor and condition that a second limit counts, and a board remembers it for the rule. So each argument in front must have one value,
 * and no other argument may be asked for. Percepts are taken to have no argument behind it that tells sensors apart.
 */
private fun Condition.namesSensor(all: List<Condition>): Boolean {
    if (until() == null) return true
    val others = all.filter { it !== this }
    return others.all { it.operator() == BoardRule.Operator.EQUAL } && others.map { it.place() }.toSet() == (1 until place()).toSet()
}

private fun operatorOf(operator: Operator): BoardRule.Operator = when (operator) {
    Operator.EQ -> BoardRule.Operator.EQUAL
    Operator.NE -> BoardRule.Operator.DIFFERENT
    Operator.LT -> BoardRule.Operator.LESS
    Operator.LE -> BoardRule.Operator.AT_MOST
    Operator.GT -> BoardRule.Operator.GREATER
    Operator.GE -> BoardRule.Operator.AT_LEAST
}

private fun valueOf(value: GroundTerm): String? = when (value) {
    is GroundTerm.Number -> decimalOf(value.value)
    is GroundTerm.Structure -> value.predicate.functor.takeIf { value == GroundTerm.Structure(Predicate(it)) && PRINTABLE.matches(it) }
    is GroundTerm.Text, is GroundTerm.Sequence -> null
}

/** Returns [value] as a decimal; null: it has too many digits, so decimals and doubles may compare differently. */
private fun decimalOf(value: Double): String? =
    if (value.isInfinite()) null
    else BigDecimal(value.toString()).stripTrailingZeros().takeIf { it.precision() <= EXACT_DIGITS }?.toPlainString()

private const val EXACT_DIGITS = 15
private val PRINTABLE = Regex("[ -~]+")
