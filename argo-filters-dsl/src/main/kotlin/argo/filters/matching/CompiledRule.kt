package argo.filters.matching

import argo.filters.Condition
import argo.filters.CriticalRule
import argo.filters.DecimalReader
import argo.filters.GroundTerm
import argo.filters.GroundTermReader
import argo.filters.HeadScanner
import argo.filters.Operator
import argo.filters.Predicate
import argo.filters.Rate
import argo.filters.Rule
import argo.filters.SmoothingRule
import argo.filters.Syntax
import argo.filters.TermTest

/**
 * A rule in a form that is fast to apply.
 *
 * @property critical the critical rule with these conditions, or null
 * @property smoothing the smoothing rule with these conditions, or null
 */
internal class CompiledRule(val rule: Rule, val critical: CriticalRule? = null, val smoothing: SmoothingRule? = null) {
    private val predicate = rule.predicate
    private val isPlain = !predicate.negated && predicate.namespace == Predicate.DEFAULT_NAMESPACE
    private val arity = rule.arity ?: ANY
    private val compiled = rule.conditions.map(::CompiledCondition).toTypedArray()
    val rate: Rate? = rule.rate

    /** True if a condition has two limits. */
    val hasHysteresis: Boolean = compiled.any { it.hasTwoLimits }

    /**
     * Returns true if the rule is for percepts with this [tail] and [head]. [head] is null if there is neither a namespace nor a
     * negation.
     */
    fun isFor(tail: Long, head: HeadScanner?): Boolean {
        if (arity != ANY && TermBounds.arity(tail) != arity) return false
        if (head == null) return isPlain
        return head.negated == predicate.negated && head.namespace == predicate.namespace
    }

    /**
     * Returns true if the percept in [text] meets all conditions. The percept's functor ends at [functorEnd], and [tail] follows.
     * [hysteresis] knows which conditions with two limits held for the last message, and records which hold now. Null: none held.
     */
    fun areMet(text: CharSequence, functorEnd: Int, end: Int, tail: Long, hysteresis: Hysteresis?): Boolean =
        if (hasHysteresis) compiled.count { it.isMet(text, functorEnd, end, tail, hysteresis) } == compiled.size // each one is recorded
        else compiled.all { it.isMet(text, functorEnd, end, tail, hysteresis) }

    /** Returns the first condition that the percept does not meet. [areMet] describes the parameters. */
    fun failing(text: CharSequence, functorEnd: Int, end: Int, tail: Long, hysteresis: Hysteresis?): Condition =
        rule.conditions[compiled.indexOfFirst { !it.isMet(text, functorEnd, end, tail, hysteresis) }]

    private companion object {
        const val ANY = -1
    }
}

/** A condition on an argument or on annotations, in a form that is fast to apply. */
private class CompiledCondition(condition: Condition) {
    private val argument = (condition as? Condition.Argument)?.index ?: -1
    private val until = (condition as? Condition.Argument)?.untilTest()?.let(::CompiledTest)

    /** True if the condition has two limits. */
    val hasTwoLimits: Boolean get() = until != null
    private val annotation = (condition as? Condition.Annotation)?.name
    private val tests = when (condition) {
        is Condition.Argument -> listOf(condition.test)
        is Condition.Annotation -> condition.tests
    }.map(::CompiledTest).toTypedArray()

    /** Returns true if the percept in [text] meets the condition. The percept's functor ends at [functorEnd], and [tail] follows. */
    fun isMet(text: CharSequence, functorEnd: Int, end: Int, tail: Long, hysteresis: Hysteresis?): Boolean {
        if (argument < 0) return anyAnnotationMeets(text, TermBounds.annotations(tail), end)
        if (argument >= TermBounds.arity(tail)) return false
        val start = TermBounds.argument(text, functorEnd, end, argument)
        val argumentEnd = TermBounds.partEnd(text, start, end, ')')
        val isMet = tests[0].isMetBy(text, start, argumentEnd)
        if (until == null || hysteresis == null) return isMet
        if (!isMet && (hysteresis.isEmpty || !until.isMetBy(text, start, argumentEnd))) return false
        return hysteresis.holds(this, text, functorEnd, start, argumentEnd, TermBounds.annotations(tail), isMet)
    }

    private fun anyAnnotationMeets(text: CharSequence, open: Int, end: Int): Boolean {
        var i = open
        while (i < end && text[i] != ']') {
            val start = Syntax.skipBlanks(text, i + 1, end)
            if (text[start] == ']') return false
            i = TermBounds.partEnd(text, start, end, ']')
            if (isMetByAnnotation(GroundTermReader(text, start, i).readWhole())) return true
        }
        return false
    }

    private fun isMetByAnnotation(annotation: GroundTerm?) =
        annotation is GroundTerm.Structure && annotation.predicate == this.annotation &&
            tests.all { it.isMetBy(annotation.arguments.firstOrNull()) }
}

/** A test of a term in its text. Compares plain atoms and numbers in place. Reads other terms into a [GroundTerm] first. */
internal class CompiledTest(private val test: TermTest) {
    private val operator = (test as? TermTest.Compare)?.operator ?: Operator.EQ
    private val values: Set<GroundTerm> = when (test) {
        is TermTest.Compare -> setOf(test.value)
        is TermTest.OneOf -> test.values
        is TermTest.Matches -> emptySet()
    }
    private val atoms: Array<String> = values.mapNotNull(::plainAtom).toTypedArray()
    private val numbers: DoubleArray = values.filterIsInstance<GroundTerm.Number>().map(GroundTerm.Number::value).toDoubleArray()

    /**
     * Returns true if the term in [text] from [start] to [end] meets the test. The character at [start] must not be a blank. Never
     * throws.
     */
    fun isMetBy(text: CharSequence, start: Int, end: Int): Boolean {
        if (test is TermTest.Matches) return isMetBy(GroundTermReader(text, start, end).readWhole())
        if (text[start] in 'a'..'z') {
            val wordEnd = Syntax.wordEnd(text, start, end)
            if (Syntax.skipBlanks(text, wordEnd, end) == end && !Syntax.isReserved(text, start, wordEnd)) {
                return decides(atoms.any { Syntax.isAt(text, start, wordEnd, it) }, Double.NaN)
            }
        }
        val number = DecimalReader.plain(text, start, end)
        if (number.isNaN()) return isMetBy(GroundTermReader(text, start, end).readWhole())
        return decides(numbers.any { it == number }, number)
    }

    /** Returns true if [value] meets the test. Null stands for a term that is no value, such as a variable. */
    fun isMetBy(value: GroundTerm?): Boolean = when {
        value == null -> false
        test is TermTest.Matches -> test.matches(value.toString())
        else -> decides(value in values, (value as? GroundTerm.Number)?.value ?: Double.NaN)
    }

    /**
     * Decides whether a term meets the test.
     *
     * @param isEqual whether the term equals one of the test's values
     * @param number the term's number, or NaN
     */
    private fun decides(isEqual: Boolean, number: Double): Boolean = when (operator) {
        Operator.EQ -> isEqual
        Operator.NE -> !isEqual
        Operator.GT -> number > numbers[0]
        Operator.GE -> number >= numbers[0]
        Operator.LT -> number < numbers[0]
        Operator.LE -> number <= numbers[0]
    }

    /** Returns the name of [value] if it is an atom without quotes, negation, namespace and annotations, else null. */
    private fun plainAtom(value: GroundTerm): String? =
        (value as? GroundTerm.Structure)?.predicate?.functor?.takeIf { value == GroundTerm.Structure(Predicate(it)) && it[0] != '\'' }
}
