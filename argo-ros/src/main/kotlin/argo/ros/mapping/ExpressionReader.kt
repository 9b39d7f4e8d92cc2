package argo.ros.mapping

import argo.filters.GroundTerm
import java.math.BigDecimal

/** Reads expressions. [nameOf] decides what a bare name in the arguments of a literal means. */
internal class ExpressionReader(
    private val cursor: Cursor,
    private val nameOf: (String, Place) -> Expression = { name, place -> Expression.Field(place, listOf(Step.Name(name))) },
) {
    /** The unquoted atoms that were read, with their places. */
    val atoms = ArrayList<Pair<Expression, Place>>()

    /** Reads an expression. A bare name is a field or a parameter. In the arguments of a literal, [nameOf] decides. */
    fun read(isArgument: Boolean = false): Expression = several("or", Value.TRUE, isArgument) { one ->
        several("and", Value.FALSE, one, ::negation)
    }

    fun readCondition(): Expression {
        val place = cursor.place
        return decidable(read(), place)
    }

    fun readLiteral(): Expression.Compound {
        val place = cursor.place
        val functor = cursor.expect(NAME, "the literal that a percept is, as dist(f, range)")
        if (GroundTerm.ofOrNull("$functor(0)") !is GroundTerm.Structure) {
            throw Refusal(place, "'$functor' is no functor: it starts with a lower-case letter and is no word of AgentSpeak")
        }
        return Expression.Compound(functor, if (cursor.take("(")) arguments(isLiteral = true) else emptyList())
    }

    private fun arguments(isLiteral: Boolean): List<Expression> {
        val arguments = ArrayList<Expression>()
        do arguments += read(isLiteral) while (cursor.take(","))
        cursor.expect(")", "behind the arguments")
        return arguments
    }

    private fun several(word: String, decisive: Value, isArgument: Boolean, one: (Boolean) -> Expression): Expression {
        val place = cursor.place
        val first = one(isArgument)
        if (!cursor.take(word)) return first
        val operands = arrayListOf(decidable(first, place))
        do operands += cursor.place.let { decidable(one(false), it) } while (cursor.take(word))
        return Condition.Several(decisive, operands)
    }

    private fun negation(isArgument: Boolean): Expression =
        if (cursor.take("not")) Condition.Not(cursor.place.let { decidable(negation(false), it) }) else comparison(isArgument)

    private fun comparison(isArgument: Boolean): Expression {
        val left = sum(isArgument)
        val place = cursor.place
        val operator = cursor.takeOneOf(Condition.OPERATORS) ?: return left
        val right = sum(false)
        if (left is Expression.Constant && right is Expression.Constant) {
            throw Refusal(place, "$operator compares two constants, and no field; the name of a field has no quotes")
        }
        return Condition.Comparison(usable(left, place), operator, usable(right, place))
    }

    private fun sum(isArgument: Boolean): Expression = calculation(listOf("+", "-"), isArgument) { one ->
        calculation(listOf("*", "/"), one, ::factor)
    }

    private fun calculation(operators: List<String>, isArgument: Boolean, one: (Boolean) -> Expression): Expression {
        var left = one(isArgument)
        while (true) {
            val operator = cursor.takeOneOf(operators) ?: return left
            left = Expression.Calculation(operator.single(), calculable(left), calculable(one(false)))
        }
    }

    /** Returns [expression] if it can be true or false, and refuses others. */
    private fun decidable(expression: Expression, place: Place): Expression {
        val isMeant = expression is Condition || expression is Expression.Field ||
            expression is Expression.Constant && (expression.value == Value.TRUE || expression.value == Value.FALSE)
        if (isMeant) return usable(expression, place)
        throw Refusal(place, "a condition compares values by ${Condition.OPERATORS.joinToString(" ")}, or is a field that is true or false")
    }

    private fun calculable(expression: Expression): Expression = when {
        expression is Condition -> throw cursor.refusal("only numbers and fields can be calculated with, and no conditions")
        expression !is Expression.Constant || expression.value is Value.Number -> usable(expression, cursor.place)
        else -> throw cursor.refusal("only numbers and fields can be calculated with, and ${expression.value.inWords()} is neither")
    }

    private fun usable(expression: Expression, place: Place): Expression {
        if (expression !is Expression.Compound) return expression
        throw Refusal(place, "${expression.functor} is no function; ${functions()}")
    }

    private fun factor(isArgument: Boolean): Expression {
        if (cursor.take("-")) return Expression.Calculation('-', ZERO, calculable(factor(false)))
        if (cursor.take("(")) return read().also { cursor.expect(")", "to close the bracket") }
        val place = cursor.place
        cursor.take(NUMBER)?.let { return Expression.Constant(numberOf(it, place)) }
        cursor.take(STRING)?.let { return Expression.Constant(Value.Text(unescaped(it, place))) }
        cursor.take(QUOTED)?.let { quoted ->
            val atom = plain(quoted)
            return if (cursor.take("(")) Expression.Compound(atom, arguments(isLiteral = true))
            else Expression.Constant(Value.Symbol(atom), isQuoted = true)
        }
        val name = cursor.expect(NAME, "a number, a field, an atom or a string")
        if (name == "true" || name == "false") return Expression.Constant(Value.Symbol(name))
        if (cursor.take("(")) return called(name, place)
        val path = listOf(Step.Name(name)) + steps()
        if (path.size > 1 || !isArgument) return Expression.Field(place, path)
        return nameOf(name, place).also { if (it is Expression.Constant) atoms += it to place }
    }

    private fun functions() = "there are ${Function.entries.joinToString(", ") { it.written }}"

    private fun numberOf(text: String, place: Place): Value.Number {
        val number = text.toDouble()
        val isExact = number.isFinite() && (text.any { it in ".eE" } || BigDecimal(text).compareTo(BigDecimal(number)) == 0)
        if (!isExact) throw Refusal(place, "$text is a number that cannot be kept exactly, as all up to 2^53 can")
        return Value.Number(number)
    }

    /** Returns the text in [quoted]. A backslash escapes a quote or a backslash. */
    private fun unescaped(quoted: String, place: Place): String = ESCAPE.replace(quoted.substring(1, quoted.length - 1)) { escape ->
        escape.groupValues[1].takeIf { it == "\"" || it == "\\" }
            ?: throw Refusal(place, "behind \\ in a string there is \" or \\, and not '${escape.groupValues[1]}'")
    }

    private fun called(name: String, place: Place): Expression {
        val function = Function.of(name)
        if (function != null) return Expression.Call(function, argumentsOf(function))
        if (name in Function.FOREIGN || Function.meant(name) != null) {
            val meant = Function.meant(name)?.let { "is ${it.written} meant? A" } ?: "${functions()}; a"
            throw Refusal(place, "$name is no function; $meant literal would be written '$name'(…)")
        }
        return Expression.Compound(name, arguments(isLiteral = true), place)
    }

    private fun argumentsOf(function: Function): List<Expression> {
        val first = read()
        if (function.takesSeveral) {
            val others = generateSequence { if (cursor.take(",")) read() else null }.toList()
            return (listOf(first) + others).also { cursor.expect(")", "behind the arguments of ${function.written}") }
        }
        cursor.expect(")", "behind the one argument of ${function.written}")
        return listOf(first)
    }

    private fun steps(): Path {
        val steps = ArrayList<Step>()
        while (true) {
            when {
                cursor.take(".") -> steps += Step.Name(cursor.expect(NAME, "the name of a field behind '.'"))
                cursor.take("[") -> steps += item()
                else -> return steps
            }
        }
    }

    private fun item(): Step {
        val place = cursor.place
        val from = cursor.take(INDEX)?.let { indexOf(it, place) }
        if (from != null && cursor.take("]")) return Step.Item(from)
        cursor.expect(":", "in the numbers of items, as in [0], [-1] or [0:90]")
        val to = cursor.take(INDEX)?.let { indexOf(it, place) }
        cursor.expect("]", "behind the numbers of items")
        if (from == to && from != null) {
            throw Refusal(place, "the sector [$from:$to] has no items; the second number is that of the first one behind it")
        }
        return Step.Sector(from, to)
    }

    private fun indexOf(text: String, place: Place): Int =
        text.toIntOrNull() ?: throw Refusal(place, "$text is no number of an item")

    companion object {
        val NAME = Regex("[A-Za-z_][A-Za-z0-9_]*")
        val NUMBER = Regex("[0-9]+(\\.[0-9]+)?([eE][-+]?[0-9]+)?")
        private val INDEX = Regex("-?[0-9]+")
        private val STRING = Regex("\"([^\"\\\\]|\\\\.)*\"")
        private val ESCAPE = Regex("\\\\(.)")
        private val QUOTED = Regex("'[^'\\\\]+'")
        private val ZERO = Expression.Constant(Value.Number(0.0))

        /** Returns the atom [quoted], without its quotes if they are not needed. */
        private fun plain(quoted: String): String =
            quoted.removeSurrounding("'").takeIf { Regex("[a-z][A-Za-z0-9_]*").matches(it) && GroundTerm.ofOrNull(it) != null } ?: quoted
    }
}
