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
 * Returns the rule for a board that decides like [critical]; null if there is none. A board compares texts and decimal numbers, so both
 * rules decide alike only for percepts as boards write them. The percepts of boards have no namespaces, comments, variables or expressions.
 * Numbers in these percepts have at most 15 digits and no exponent. A functor always has one number of arguments.
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
 * Returns true if a board decides this condition like a filter. If the argument is missing, `NE` is false in a filter but true on a board.
 * A condition with `NE` is exact only if another condition requires its argument or a later one.
 */
private fun Condition.isExact(all: List<Condition>) =
    operator() != BoardRule.Operator.DIFFERENT || all.any { it.operator() != BoardRule.Operator.DIFFERENT && it.place() >= place() }

/**
 * Returns true if this condition has one limit, or if the other conditions select one sensor. A filter remembers for each sensor whether
 * the second limit applies; a board remembers it once for the whole rule. Each argument before this one must have one required value, and
 * no later argument may have a condition. Later arguments are assumed not to tell sensors apart.
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

/** Returns [value] as a decimal; null if it is infinite, or has so many digits that decimals and doubles may compare differently. */
private fun decimalOf(value: Double): String? =
    if (value.isInfinite()) null
    else BigDecimal(value.toString()).stripTrailingZeros().takeIf { it.precision() <= EXACT_DIGITS }?.toPlainString()

private const val EXACT_DIGITS = 15
private val PRINTABLE = Regex("[ -~]+")
