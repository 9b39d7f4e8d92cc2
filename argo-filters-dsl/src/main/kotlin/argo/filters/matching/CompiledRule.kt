package argo.filters.matching

import argo.filters.Condition
import argo.filters.CriticalRule
import argo.filters.Operator
import argo.filters.Predicate
import argo.filters.Rate
import argo.filters.Rule
import argo.filters.Syntax
import argo.filters.Test
import argo.filters.Value
import argo.filters.ValueReader

/**
 * A rule in the form in which it is applied.
 *
 * @property critical the critical rule that it is of, or null
 */
internal class CompiledRule(val rule: Rule, val critical: CriticalRule? = null) {
    private val predicate = rule.predicate
    private val arity = rule.arity ?: ANY
    private val compiled = rule.conditions.map { if (it is Condition.Argument) ArgumentCondition(it) else AnnotationCondition(it as Condition.Annotation) }.toTypedArray()
    val rate: Rate? = rule.rate

    /** Whether [percept], whose functor is the rule's, is in its predicate and has its arity. */
    fun isFor(percept: PerceptText): Boolean = (arity == ANY || percept.arity == arity) && percept.isOf(predicate)

    /** Whether [percept], whose functor is the rule's, meets the rule. */
    fun isMetBy(percept: PerceptText): Boolean {
        if (!isFor(percept)) return false
        for (condition in compiled) if (!condition.isMetBy(percept)) return false
        return true
    }

    /** The first condition that [percept] does not meet. */
    fun failing(percept: PerceptText): Condition = rule.conditions[compiled.indexOfFirst { !it.isMetBy(percept) }]

    private companion object {
        const val ANY = -1
    }
}

/** A condition in the form in which it is applied. */
private sealed interface CompiledCondition {
    fun isMetBy(percept: PerceptText): Boolean
}

private class ArgumentCondition(private val condition: Condition.Argument) : CompiledCondition {
    private val test = CompiledTest(condition.test)

    override fun isMetBy(percept: PerceptText) = percept.argumentMeets(condition.index, test)
}

private class AnnotationCondition(private val condition: Condition.Annotation) : CompiledCondition {
    private val tests = condition.tests.map(::CompiledTest)

    override fun isMetBy(percept: PerceptText) = percept.anyAnnotationMeets { annotation ->
        annotation is Value.Structure && annotation.predicate == condition.name && tests.all { it.isMetBy(annotation.arguments.firstOrNull()) }
    }
}

/** A test of a term in its text; only what is neither a plain atom nor a plain number is read into a [Value] first. */
internal class CompiledTest(private val test: Test) {
    private val operator = (test as? Test.Compare)?.operator ?: Operator.EQ
    private val values: Set<Value> = when (test) {
        is Test.Compare -> setOf(test.value)
        is Test.OneOf -> test.values
        is Test.Matches -> emptySet()
    }
    private val atoms: Array<String> = values.mapNotNull(::plainAtom).toTypedArray()
    private val numbers: DoubleArray = values.filterIsInstance<Value.Number>().map(Value.Number::value).toDoubleArray()

    /** Whether the term that [text] holds from [start], where it is not blank, to [end] meets the test. Never throws. */
    fun isMetBy(text: CharSequence, start: Int, end: Int): Boolean {
        if (test is Test.Matches) return isMetBy(ValueReader(text, start, end).readWhole())
        if (text[start] in 'a'..'z') {
            val wordEnd = Syntax.wordEnd(text, start, end)
            if (Syntax.skipBlanks(text, wordEnd, end) == end && !Syntax.isReserved(text, start, wordEnd)) {
                return decides(isAnAtom(text, start, wordEnd), Double.NaN)
            }
        }
        val number = DecimalReader.plain(text, start, end)
        return if (number.isNaN()) isMetBy(ValueReader(text, start, end).readWhole()) else decides(isANumber(number), number)
    }

    /** Whether [value] meets the test; null stands for a term that is not ground and plain. */
    fun isMetBy(value: Value?): Boolean = when {
        value == null -> false
        test is Test.Matches -> test.matches(value.toString())
        else -> decides(value in values, (value as? Value.Number)?.value ?: Double.NaN)
    }

    /** Whether a term meets the test that [isEqual] to one of the values or not, and is [number]: NaN, which has no order, if it is none. */
    private fun decides(isEqual: Boolean, number: Double): Boolean = when (operator) {
        Operator.EQ -> isEqual
        Operator.NE -> !isEqual
        Operator.GT -> number > numbers[0]
        Operator.GE -> number >= numbers[0]
        Operator.LT -> number < numbers[0]
        Operator.LE -> number <= numbers[0]
    }

    private fun isAnAtom(text: CharSequence, start: Int, end: Int): Boolean {
        for (atom in atoms) if (atom.length == end - start && Syntax.isAt(text, start, atom)) return true
        return false
    }

    private fun isANumber(number: Double): Boolean {
        for (wanted in numbers) if (wanted == number) return true
        return false
    }

    /** The word of an atom without quotes, negation, namespace, arguments and annotations. */
    private fun plainAtom(value: Value): String? =
        (value as? Value.Structure)?.predicate?.functor?.takeIf { value == Value.Structure(Predicate(it)) && it[0] != '\'' }
}
