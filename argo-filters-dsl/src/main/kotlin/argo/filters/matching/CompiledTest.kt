package argo.filters.matching

import argo.filters.Operator
import argo.filters.Predicate
import argo.filters.Syntax
import argo.filters.Test
import argo.filters.Value
import argo.filters.ValueReader

/** A test that is done in the text of a term; only what is neither a plain atom nor a plain number is read into a [Value] first. */
internal class CompiledTest(private val test: Test) {
    private val values: List<Value> = when (test) {
        is Test.Compare -> listOf(test.value)
        is Test.OneOf -> test.values.toList()
        is Test.Matches -> emptyList()
    }
    private val atoms: Array<String> = values.mapNotNull(::plainAtom).toTypedArray()
    private val numbers: DoubleArray = values.filterIsInstance<Value.Number>().map(Value.Number::value).toDoubleArray()

    /** Whether the term that [text] holds from [start], where it is not blank, to [end] meets the test. Never throws. */
    fun meets(text: CharSequence, start: Int, end: Int): Boolean {
        val first = text[start]
        if (first in 'a'..'z') {
            val wordEnd = Syntax.wordEnd(text, start, end)
            val isPlain = Syntax.skipBlanks(text, wordEnd, end) == end && !Syntax.isReserved(text, start, wordEnd)
            if (isPlain && test !is Test.Matches) return atomMeets(text, start, wordEnd)
        } else if (first <= '9' && test !is Test.Matches) {
            val number = NumberText.plain(text, start, end)
            if (!number.isNaN()) return numberMeets(number)
        }
        return meets(ValueReader(text, start, end).readWhole())
    }

    /** Whether [value] meets the test; null stands for a term that is not ground and plain. */
    fun meets(value: Value?): Boolean = value != null && when (test) {
        is Test.Matches -> test.matches(value.toString())
        is Test.OneOf -> value in test.values
        is Test.Compare -> when {
            test.operator == Operator.EQ -> value == test.value
            test.operator == Operator.NE -> value != test.value
            else -> value is Value.Number && numberMeets(value.value)
        }
    }

    private fun atomMeets(text: CharSequence, start: Int, end: Int): Boolean = when (test) {
        is Test.Compare -> when (test.operator) {
            Operator.EQ -> isAnAtom(text, start, end)
            Operator.NE -> !isAnAtom(text, start, end)
            else -> false
        }
        else -> isAnAtom(text, start, end)
    }

    private fun isAnAtom(text: CharSequence, start: Int, end: Int): Boolean {
        for (atom in atoms) if (atom.length == end - start && Syntax.isAt(text, start, atom)) return true
        return false
    }

    private fun numberMeets(number: Double): Boolean = when (test) {
        is Test.Compare -> when (test.operator) {
            Operator.EQ -> isANumber(number)
            Operator.NE -> !isANumber(number)
            Operator.GT -> number > numbers[0]
            Operator.GE -> number >= numbers[0]
            Operator.LT -> number < numbers[0]
            Operator.LE -> number <= numbers[0]
        }
        else -> isANumber(number)
    }

    private fun isANumber(number: Double): Boolean {
        for (wanted in numbers) if (wanted == number) return true
        return false
    }

    /** The word of an atom without quotes, negation, namespace, arguments and annotations. */
    private fun plainAtom(value: Value): String? {
        val structure = value as? Value.Structure ?: return null
        val word = structure.predicate.functor
        return word.takeIf { structure == Value.Structure(Predicate(word)) && it[0] != '\'' }
    }
}
