package argo.ros.mapping

import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.JsonObject

/** An expression over the fields of a message or the arguments of a command. A [Scope] contains their values. */
internal sealed interface Expression {
    /** Returns the value; [Value.None] if a field has none, or if it does not suit the calculation. */
    fun valueIn(scope: Scope): Value

    data class Constant(val value: Value) : Expression {
        override fun valueIn(scope: Scope) = value
    }

    /** A field, or a parameter: [path] consists of names, and of indices from 0. */
    data class Field(val place: Place, val path: List<String>) : Expression {
        override fun valueIn(scope: Scope) = scope.valueOf(path)
    }

    data class Calculation(val operator: Char, val left: Expression, val right: Expression) : Expression {
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

    data class Call(val function: Function, val argument: Expression) : Expression {
        override fun valueIn(scope: Scope): Value {
            val value = argument.valueIn(scope)
            return value as? Value.None ?: function.of(value)
                ?: Value.None("${function.name.lowercase()} takes ${function.taken}, not ${value.inWords()}")
        }
    }

    data class Compound(val functor: String, val arguments: List<Expression>) : Expression {
        override fun valueIn(scope: Scope): Value {
            if (arguments.isEmpty()) return Value.Symbol(functor)
            val terms = arguments.mapIndexed { index, argument ->
                when (val term = argument.valueIn(scope).asTerm()) {
                    is Value.Symbol -> term.text
                    is Value.None -> return Value.None("argument ${index + 1} of $functor: ${term.why}")
                    else -> error("${term.inWords()} is no term")
                }
            }
            return Value.Symbol(terms.joinToString(",", "$functor(", ")"))
        }
    }
}

internal fun Expression.fields(): List<Expression.Field> = when (this) {
    is Expression.Constant -> emptyList()
    is Expression.Field -> listOf(this)
    is Expression.Calculation -> left.fields() + right.fields()
    is Expression.Call -> argument.fields()
    is Expression.Compound -> arguments.flatMap { it.fields() }
}

/** Writes [path] in the syntax of mappings: `poses[0].x`. */
internal fun written(path: List<String>): String =
    path.reduceOrNull { before, step -> if (step[0].isDigit()) "$before[$step]" else "$before.$step" }.orEmpty()

internal fun interface Scope {
    /** Returns the value at [path]; [Value.None] if there is none. */
    fun valueOf(path: List<String>): Value
}

/** The fields of a message. [bytes] are the paths of the fields that are bytes; bridges write these as text in base64. */
internal class MessageScope(private val message: JsonElement, private val bytes: Set<List<String>> = emptySet()) : Scope {
    override fun valueOf(path: List<String>): Value {
        var at = message
        for ((index, name) in path.withIndex()) {
            val inner = when (at) {
                is JsonObject -> at[name]
                is JsonArray -> name.toIntOrNull()?.let(at::getOrNull)
                else -> null
            } ?: return Value.None(missing(at, path.take(index), name))
            at = if (bytes.isEmpty() || path.subList(0, index + 1) !in bytes) inner else bytesOf(inner) ?: return TOO_MANY_BYTES
        }
        return when (val value = Value.of(at)) {
            is Value.None -> Value.None("${written(path)}: ${value.why}")
            else -> value
        }
    }

    private fun missing(at: JsonElement, path: List<String>, name: String): String {
        val place = if (path.isEmpty()) "the message" else written(path)
        return when (at) {
            is JsonObject -> "$place has no field $name; it has ${at.keys.joinToString(", ")}"
            is JsonArray -> "the list $place has no item $name"
            JsonNull -> "$place is null, so that it has no $name"
            else -> "$place is no message, so that it has no field $name"
        }
    }

    private companion object {
        val TOO_MANY_BYTES = Value.None("its bytes are no list: they are more than $MAX_ITEMS, or not in base64")
    }
}

internal data class Comparison(val left: Expression, val operator: String, val right: Expression) {
    /** Returns [Value.TRUE] if the comparison holds, [Value.FALSE] if not, [Value.None] if a value is missing or cannot be compared. */
    fun valueIn(scope: Scope): Value {
        val (a, b) = left.valueIn(scope) to right.valueIn(scope)
        if (a is Value.None) return a
        if (b is Value.None) return b
        val (number, other) = a.number() to b.number()
        val (text, otherText) = a.plainText() to b.plainText()
        val isMet = when {
            number != null && other != null -> meets(number.compareTo(other))
            text == null || otherText == null -> return incomparable(a, b)
            operator == "==" || operator == "!=" -> (text == otherText) == (operator == "==")
            else -> return incomparable(a, b)
        }
        return if (isMet) Value.TRUE else Value.FALSE
    }

    private fun meets(order: Int) = when (operator) {
        "==" -> order == 0
        "!=" -> order != 0
        "<" -> order < 0
        "<=" -> order <= 0
        ">" -> order > 0
        else -> order >= 0
    }

    private fun incomparable(a: Value, b: Value) = Value.None("$operator cannot compare ${a.inWords()} with ${b.inWords()}")

    companion object {
        val OPERATORS = listOf("<=", ">=", "==", "!=", "<", ">")
    }
}

/** The functions of mappings. [of] returns the function's value; null: the function does not accept the argument. */
internal enum class Function(val taken: String, val of: (Value) -> Value?) {
    ROUND("a number", { value -> value.number()?.let { Value.of(Math.rint(it)) } }),
    ABS("a number", { value -> value.number()?.let { Value.of(Math.abs(it)) } }),
    MIN("a list with numbers", { value -> value.numbers().minOrNull()?.let(Value::of) }),
    MAX("a list with numbers", { value -> value.numbers().maxOrNull()?.let(Value::of) }),
    COUNT("a list", { value -> ((value as? Value.Part)?.json as? JsonArray)?.let { Value.of(it.size.toDouble()) } }),

    /** The heading of a quaternion in rad, counter-clockwise from the x axis. */
    YAW("a quaternion with the numbers x, y, z and w", ::yawOf);

    companion object {
        fun of(name: String): Function? = entries.find { it.name.lowercase() == name }
    }
}

private fun Value.numbers(): List<Double> =
    ((this as? Value.Part)?.json as? JsonArray)?.mapNotNull { Value.of(it).number() }.orEmpty()

private fun yawOf(quaternion: Value): Value? {
    val scope = (quaternion as? Value.Part)?.json?.let(::MessageScope) ?: return null
    val (x, y, z, w) = listOf("x", "y", "z", "w").map { scope.valueOf(listOf(it)).number() ?: return null }
    return Value.of(Math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z)))
}
