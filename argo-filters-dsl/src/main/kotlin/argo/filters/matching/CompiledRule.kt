package argo.filters.matching

import argo.filters.Condition
import argo.filters.CriticalRule
import argo.filters.Predicate
import argo.filters.Rate
import argo.filters.Rule
import argo.filters.Syntax
import argo.filters.Value
import argo.filters.ValueReader

/**
 * A rule in the form in which it is applied.
 *
 * @property critical the critical rule that it is of, or null
 */
internal class CompiledRule(val rule: Rule, val critical: CriticalRule? = null) {
    private val negated = rule.predicate.negated
    private val namespace = rule.predicate.namespace
    private val arity = rule.arity ?: ANY
    val conditions: Array<CompiledCondition> = rule.conditions.map(::CompiledCondition).toTypedArray()
    val rate: Rate? = rule.rate

    /** Whether a percept of the rule's functor is in its predicate and has its arity. */
    fun isFor(negated: Boolean, namespace: String, arity: Int): Boolean =
        negated == this.negated && (this.arity == ANY || arity == this.arity) && namespace == this.namespace

    fun meets(percept: PerceptForm): Boolean = conditions.all(percept::meets)

    /** As the other form, for the percept in [text] whose functor ends at [functorEnd] and whose outline goes on with [tail]. */
    fun meets(text: CharSequence, functorEnd: Int, end: Int, tail: Long): Boolean {
        for (condition in conditions) if (!condition.holds(text, functorEnd, end, tail)) return false
        return true
    }

    private companion object {
        const val ANY = -1
    }
}

/** A condition in the form in which it is applied: on the argument at [argument], or on the annotations called [annotation]. */
internal class CompiledCondition(val condition: Condition) {
    val argument: Int = (condition as? Condition.Argument)?.index ?: -1
    val annotation: Predicate? = (condition as? Condition.Annotation)?.name
    private val tests: Array<CompiledTest> = when (condition) {
        is Condition.Argument -> listOf(condition.test)
        is Condition.Annotation -> condition.tests
    }.map(::CompiledTest).toTypedArray()

    /** Whether it holds for the percept in [text] whose functor ends at [functorEnd] and whose outline goes on with [tail]. */
    fun holds(text: CharSequence, functorEnd: Int, end: Int, tail: Long): Boolean = when {
        argument >= Outline.arity(tail) -> false
        argument >= 0 -> meets(text, Outline.argument(text, functorEnd, end, argument), end)
        else -> anyAnnotationMeets(text, Outline.annotations(tail), end)
    }

    private fun meets(text: CharSequence, start: Int, end: Int): Boolean {
        val partEnd = Outline.partEnd(text, start, end, ')')
        for (test in tests) if (!test.meets(text, start, partEnd)) return false
        return true
    }

    private fun anyAnnotationMeets(text: CharSequence, open: Int, end: Int): Boolean {
        if (open == end) return false
        var start = Syntax.skipBlanks(text, open + 1, end)
        while (start < end && text[start] != ']') {
            val partEnd = Outline.partEnd(text, start, end, ']')
            if (meetsAnnotation(ValueReader(text, start, partEnd).readWhole())) return true
            start = Syntax.skipBlanks(text, if (text[partEnd] == ',') partEnd + 1 else partEnd, end)
        }
        return false
    }

    /** Whether [value], null where there is none, meets all tests. */
    fun meets(value: Value?): Boolean {
        for (test in tests) if (!test.meets(value)) return false
        return true
    }

    /** Whether [value] is an annotation that this condition is on, and meets it. */
    fun meetsAnnotation(value: Value?): Boolean =
        value is Value.Structure && value.predicate == annotation && meets(value.arguments.firstOrNull())
}
