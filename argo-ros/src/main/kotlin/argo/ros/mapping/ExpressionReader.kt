package argo.ros.mapping

import argo.filters.GroundTerm
import java.math.BigDecimal

/** Reads expressions. [nameOf] returns the meaning of a bare name that is an argument of a literal. */
internal class ExpressionReader(private val cursor: Cursor, private val nameOf: (String, Place) -> Expression) {
    /** Reads an expression. A bare name is a field or a parameter; for an argument of a literal, [nameOf] decides. */
    fun read(isArgument: Boolean = false): Expression {
        var left = product(isArgument)
        while (true) {
            val operator = cursor.takeOneOf(listOf("+", "-")) ?: return left
            left = Expression.Calculation(operator.single(), calculable(left), calculable(product(false)))
        }
    }

    /** Reads a literal, `stop` or `dist(f, range*100)`. */
    fun readLiteral(): Expression.Compound {
        val place = cursor.place
        val functor = cursor.expect(NAME, "the literal that a percept is, as dist(f, range)")
        if (GroundTerm.ofOrNull("$functor(0)") !is GroundTerm.Structure) {
            throw Refusal(place, "'$functor' is no functor: it starts with a lower-case letter and is no word of AgentSpeak")
        }
        return Expression.Compound(functor, if (cursor.take("(")) arguments() else emptyList())
    }

    private fun arguments(): List<Expression> {
        val arguments = ArrayList<Expression>()
        do arguments += read(isArgument = true) while (cursor.take(","))
        cursor.expect(")", "behind the arguments")
        return arguments
    }

    /** Returns [expression] if it suits a calculation; refuses an atom or a string. */
    private fun calculable(expression: Expression): Expression =
        if (expression is Expression.Constant && expression.value !is Value.Number) {
            throw cursor.refusal("only numbers and fields can be calculated with, and ${expression.value.inWords()} is neither")
        } else {
            expression
        }

    private fun product(isArgument: Boolean): Expression {
        var left = factor(isArgument)
        while (true) {
            val operator = cursor.takeOneOf(listOf("*", "/")) ?: return left
            left = Expression.Calculation(operator.single(), calculable(left), calculable(factor(false)))
        }
    }

    private fun factor(isArgument: Boolean): Expression {
        if (cursor.take("-")) return Expression.Calculation('-', ZERO, calculable(factor(false)))
        if (cursor.take("(")) return read().also { cursor.expect(")", "to close the bracket") }
        val numberPlace = cursor.place
        cursor.take(NUMBER)?.let { return Expression.Constant(numberOf(it, numberPlace)) }
        cursor.take(STRING)?.let { return Expression.Constant(Value.Text(it.substring(1, it.length - 1))) }
        cursor.take(QUOTED)?.let { return Expression.Constant(Value.Symbol(plain(it))) }
        val place = cursor.place
        val name = cursor.expect(NAME, "a number, a field, an atom or a string")
        if (cursor.take("(")) return called(name)
        val path = listOf(name) + steps()
        return if (path.size == 1 && isArgument) nameOf(name, place) else Expression.Field(place, path)
    }

    private fun numberOf(text: String, place: Place): Value.Number {
        val number = text.toDouble()
        val isExact = number.isFinite() && (text.any { it in ".eE" } || BigDecimal(text).compareTo(BigDecimal(number)) == 0)
        if (!isExact) throw Refusal(place, "$text is a number that cannot be kept exactly, as all up to 2^53 can")
        return Value.Number(number)
    }

    private fun called(name: String): Expression {
        val function = Function.of(name) ?: return Expression.Compound(name, arguments())
        return Expression.Call(function, read()).also { cursor.expect(")", "behind the one argument of $name") }
    }

    private fun steps(): List<String> {
        val steps = ArrayList<String>()
        while (true) {
            when {
                cursor.take(".") -> steps += cursor.expect(NAME, "the name of a field behind '.'")
                cursor.take("[") -> {
                    steps += cursor.expect(INDEX, "the number of an item, from 0")
                    cursor.expect("]", "behind the number of an item")
                }
                else -> return steps
            }
        }
    }

    companion object {
        val NAME = Regex("[A-Za-z_][A-Za-z0-9_]*")
        val NUMBER = Regex("[0-9]+(\\.[0-9]+)?([eE][-+]?[0-9]+)?")
        val INDEX = Regex("[0-9]+")
        private val STRING = Regex("\"[^\"\\\\]*\"")
        private val QUOTED = Regex("'[^'\\\\]+'")
        private val ZERO = Expression.Constant(Value.Number(0.0))

        /** Returns the atom [quoted] without its quotes if it needs none. */
        private fun plain(quoted: String): String =
            quoted.removeSurrounding("'").takeIf { Regex("[a-z][A-Za-z0-9_]*").matches(it) && GroundTerm.ofOrNull(it) != null } ?: quoted
    }
}
