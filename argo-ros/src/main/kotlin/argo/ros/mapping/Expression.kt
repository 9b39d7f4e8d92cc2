package argo.ros.mapping

import kotlinx.serialization.json.JsonObject

/** An expression over the fields of a message or the arguments of a command. A [Scope] contains their values. */
internal sealed interface Expression {
    val parts: List<Expression> get() = emptyList()

    /** Returns the value. Returns [Value.None] if a field has no value, or a value of the wrong type. */
    fun valueIn(scope: Scope): Value

    /** A constant. [isQuoted] is true if the constant is an atom in quotes. */
    data class Constant(val value: Value, val isQuoted: Boolean = false) : Expression {
        override fun valueIn(scope: Scope) = value
    }

    data class Field(val place: Place, val path: Path) : Expression {
        override fun valueIn(scope: Scope) = scope.valueOf(path)
    }

    /**
     * All fields of a message except its header, as arguments of a percept. Each argument is a literal with the name and the value of a
     * field.
     */
    data object AllFields : Expression {
        override fun valueIn(scope: Scope): Value {
            val message = (scope.valueOf(emptyList()) as Value.Part).json as JsonObject
            return Value.Part(JsonObject(message - "header")).asTerm()
        }
    }

    data class Calculation(val operator: Char, val left: Expression, val right: Expression) : Expression {
        override val parts get() = listOf(left, right)

        override fun valueIn(scope: Scope): Value {
            val (first, second) = left.valueIn(scope) to right.valueIn(scope)
            val a = first.number() ?: return noNumber(first)
            val b = second.number() ?: return noNumber(second)
            return Value.of(
                when (operator) {
                    '+' -> a + b
                    '-' -> a - b
                    '*' -> a * b
                    else -> a / b
                },
            )
        }

        private fun noNumber(value: Value) =
            value as? Value.None ?: Value.None("$operator calculates with numbers, not with ${value.inWords()}")
    }

    data class Call(val function: Function, val arguments: List<Expression>) : Expression {
        override val parts get() = arguments

        override fun valueIn(scope: Scope): Value {
            val values = arguments.map { it.valueIn(scope) }
            return values.find { it is Value.None } ?: function.of(values)
                ?: Value.None("${function.written} takes ${function.taken}, not ${values.joinToString(" and ") { it.inWords() }}")
        }
    }

    /** A literal. [place] is set for an unquoted literal within another literal, since the author may mean a field or a function. */
    data class Compound(val functor: String, val arguments: List<Expression>, val place: Place? = null) : Expression {
        override val parts get() = arguments

        override fun valueIn(scope: Scope): Value {
            if (arguments.isEmpty()) return Value.Symbol(functor)
            val terms = arguments.mapIndexed { index, argument ->
                when (val term = argument.valueIn(scope).asTerm()) {
                    is Value.Symbol -> if (argument == AllFields) term.text.removeSurrounding("[", "]") else term.text
                    is Value.None -> return Value.None("argument ${index + 1} of $functor: ${term.why}")
                    else -> error("${term.inWords()} is no term")
                }
            }
            return Value.Symbol(if (terms == listOf("")) functor else terms.joinToString(",", "$functor(", ")"))
        }
    }
}

/** Returns the unquoted literals within this expression. */
internal fun Expression.literals(): List<Expression.Compound> =
    listOfNotNull((this as? Expression.Compound)?.takeIf { it.place != null }) + parts.flatMap { it.literals() }

internal fun Expression.fields(): List<Expression.Field> = if (this is Expression.Field) listOf(this) else parts.flatMap { it.fields() }
