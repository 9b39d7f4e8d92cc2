package argo.filters.matching

import argo.filters.Condition
import argo.filters.GroundTerm
import argo.filters.Operator
import argo.filters.TermTest

internal class AllowedPercepts(private val conditions: List<Condition>) {
    private val arguments = conditions.filterIsInstance<Condition.Argument>()
        .groupBy({ it.index }, { it.untilTest() ?: it.test }).mapValues { AllowedTerms(it.value) }
    private val annotations = conditions.filterIsInstance<Condition.Annotation>().map { it.name to AllowedTerms(it.tests) }

    /** Returns, in words, conditions on one term that no term can meet together. Returns null if none are found. */
    fun contradiction(): String? {
        val argument = arguments.entries.find { it.value.isEmpty() }
        if (argument != null) return conditions.filter { (it as? Condition.Argument)?.index == argument.key }.joinToString(" and ")
        return conditions.filterIsInstance<Condition.Annotation>().find { AllowedTerms(it.tests).isEmpty() }?.toString()
    }

    /** Returns true if the conditions certainly allow at most one number for the argument at [index]. */
    fun isFixed(index: Int): Boolean = arguments[index]?.isFixed() == true

    /** Returns the only value that the conditions allow for the argument at [index]. Returns null if none is found. */
    fun single(index: Int): GroundTerm? = arguments[index]?.single()

    /** Returns true if the conditions certainly imply [condition]. */
    fun imply(condition: Condition): Boolean = when (condition) {
        is Condition.Argument -> condition in conditions || arguments[condition.index]?.imply(condition.test) == true
        is Condition.Annotation -> annotations.any { (name, terms) -> name == condition.name && condition.tests.all(terms::imply) }
    }
}

private class AllowedTerms(private val tests: List<TermTest>) {
    private val range =
        tests.filterIsInstance<TermTest.Compare>().filter { it.operator.ordering }.map(::NumberRange).reduceOrNull(NumberRange::and)

    /** All terms that meet the tests, if the tests list the allowed values; else null. */
    private val values: Set<GroundTerm>? =
        (tests.mapNotNull(::valuesOf) + listOfNotNull(range?.single()?.let(::setOf))).reduceOrNull { one, other -> one intersect other }
            ?.filter { value -> tests.all { CompiledTest(it).isMetBy(value) } }?.toSet()

    fun isEmpty(): Boolean = values?.isEmpty() ?: (range?.isEmpty() == true)

    fun single(): GroundTerm? = values?.singleOrNull()

    fun isFixed(): Boolean = values != null && values.count { it is GroundTerm.Number } < 2

    fun imply(test: TermTest): Boolean = when {
        test in tests -> true
        values != null -> values.all { CompiledTest(test).isMetBy(it) }
        range == null || test !is TermTest.Compare -> false
        test.operator == Operator.NE -> !range.holds((test.value as? GroundTerm.Number)?.value ?: Double.NaN)
        else -> test.operator.ordering && (range and NumberRange(test)) == range
    }

    private fun valuesOf(test: TermTest): Set<GroundTerm>? = when (test) {
        is TermTest.Compare -> setOf(test.value).takeIf { test.operator == Operator.EQ }
        is TermTest.OneOf -> test.values
        is TermTest.Matches -> null
    }
}

/** Numbers between two limits. An open limit is itself outside of the range. */
private data class NumberRange(val from: Double, val isFromOpen: Boolean, val to: Double, val isToOpen: Boolean) {
    /** The range of numbers that meet [test], which compares by order. */
    constructor(test: TermTest.Compare) : this(test.operator, (test.value as GroundTerm.Number).value)

    private constructor(operator: Operator, limit: Double) : this(
        from = if (operator == Operator.GT || operator == Operator.GE) limit else Double.NEGATIVE_INFINITY,
        isFromOpen = operator == Operator.GT,
        to = if (operator == Operator.LT || operator == Operator.LE) limit else Double.POSITIVE_INFINITY,
        isToOpen = operator == Operator.LT,
    )

    infix fun and(other: NumberRange) = NumberRange(
        maxOf(from, other.from), from >= other.from && isFromOpen || other.from >= from && other.isFromOpen,
        minOf(to, other.to), to <= other.to && isToOpen || other.to <= to && other.isToOpen,
    )

    fun isEmpty(): Boolean = from > to || from == to && (isFromOpen || isToOpen)

    fun single(): GroundTerm? = if (from == to && !isEmpty()) GroundTerm.Number(from) else null

    fun holds(number: Double): Boolean = (number > from || number == from && !isFromOpen) && (number < to || number == to && !isToOpen)
}
