package argo.ros.mapping

/**
 * An expression with the value [Value.TRUE], [Value.FALSE] or [Value.None]. The value is [Value.None] if a needed value is missing or has
 * the wrong type.
 */
internal sealed interface Condition : Expression {
    data class Comparison(val left: Expression, val operator: String, val right: Expression) : Condition {
        override val parts get() = listOf(left, right)

        override fun valueIn(scope: Scope): Value {
            val (a, b) = left.valueIn(scope) to right.valueIn(scope)
            if (a is Value.None) return a
            if (b is Value.None) return b
            val (number, other) = a.number() to b.number()
            val (text, otherText) = a.plainText() to b.plainText()
            return when {
                number != null && other != null -> truth(meets(number.compareTo(other)))
                text == null || otherText == null -> incomparable(a, b)
                isTextForTruth(a, right) || isTextForTruth(b, left) -> Value.None("${incomparable(a, b).why}; write \"true\" or \"false\"")
                isOtherThanTruth(a, right, otherText) || isOtherThanTruth(b, left, text) -> incomparable(a, b)
                operator == "==" || operator == "!=" -> truth((text == otherText) == (operator == "=="))
                else -> incomparable(a, b)
            }
        }

        /** Returns true if [value] is a boolean and the [text] of [constant] is none, as in `data == 'True'`. */
        private fun isOtherThanTruth(value: Value, constant: Expression, text: String) =
            (value == Value.TRUE || value == Value.FALSE) && constant is Expression.Constant && text != "true" && text != "false"

        /** Returns true if [value] is a text and [constant] is `true` or `false` without quotes. */
        private fun isTextForTruth(value: Value, constant: Expression) = value is Value.Text && constant is Expression.Constant &&
            !constant.isQuoted && (constant.value == Value.TRUE || constant.value == Value.FALSE)

        private fun meets(order: Int) = when (operator) {
            "==" -> order == 0
            "!=" -> order != 0
            "<" -> order < 0
            "<=" -> order <= 0
            ">" -> order > 0
            else -> order >= 0
        }

        private fun incomparable(a: Value, b: Value) = Value.None("$operator cannot compare ${a.inWords()} with ${b.inWords()}")
    }

    data class Not(val operand: Expression) : Condition {
        override val parts get() = listOf(operand)

        override fun valueIn(scope: Scope): Value = when (val value = operand.truthIn(scope)) {
            Value.TRUE -> Value.FALSE
            Value.FALSE -> Value.TRUE
            else -> value
        }
    }

    /**
     * Several conditions. One condition with the value [decisive] decides the result. [decisive] is [Value.FALSE] for `and`, and
     * [Value.TRUE] for `or`.
     */
    data class Several(val decisive: Value, val operands: List<Expression>) : Condition {
        override val parts get() = operands

        override fun valueIn(scope: Scope): Value {
            val values = operands.map { it.truthIn(scope) }
            return values.find { it == decisive } ?: values.find { it is Value.None } ?: truth(decisive == Value.FALSE)
        }
    }

    companion object {
        /** All operators. Longer operators come first, since `<=` is not to be read as `<`. */
        val OPERATORS = listOf("<=", ">=", "==", "!=", "<", ">")
    }
}

private fun truth(isTrue: Boolean) = if (isTrue) Value.TRUE else Value.FALSE

internal fun Expression.truthIn(scope: Scope): Value = valueIn(scope).let { value ->
    if (value == Value.TRUE || value == Value.FALSE || value is Value.None) value
    else Value.None("a condition is true or false, and not ${value.inWords()}")
}
