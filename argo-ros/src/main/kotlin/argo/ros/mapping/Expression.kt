package argo.ros.mapping

import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonObject

/** An expression over the fields of a message, or over the arguments of a command. Values are looked up by a [Scope]. */
internal sealed interface Expression {
    /** The value; null: a field has none, or of another kind than is calculated with. */
    fun valueIn(scope: Scope): Value?

    /** A number, an atom or a string that is written as such. */
    data class Constant(val value: Value) : Expression {
        override fun valueIn(scope: Scope) = value
    }

    /** A field, or a parameter: [path] has names, and numbers of items from 0. */
    data class Field(val place: Place, val path: List<String>) : Expression {
        override fun valueIn(scope: Scope) = scope.valueOf(path)
    }

    /** A calculation with two numbers. */
    data class Calculation(val operator: Char, val left: Expression, val right: Expression) : Expression {
        override fun valueIn(scope: Scope): Value? {
            val a = left.numberIn(scope) ?: return null
            val b = right.numberIn(scope) ?: return null
            return Value.of(
                when (operator) {
                    '+' -> a + b
                    '-' -> a - b
                    '*' -> a * b
                    else -> a / b
                },
            )
        }
    }

    /** A function of [Function]. */
    data class Call(val function: Function, val argument: Expression) : Expression {
        override fun valueIn(scope: Scope) = argument.valueIn(scope)?.let(function.of)
    }

    /** A literal: a functor and arguments. */
    data class Compound(val functor: String, val arguments: List<Expression>) : Expression {
        override fun valueIn(scope: Scope) = textIn(scope)?.let(Value::Symbol)

        /** The literal as text; null: an argument has no value. */
        fun textIn(scope: Scope): String? {
            if (arguments.isEmpty()) return functor
            val terms = arguments.map { it.valueIn(scope)?.asTerm() ?: return null }
            return terms.joinToString(",", "$functor(", ")")
        }
    }
}

internal fun Expression.numberIn(scope: Scope): Double? = (valueIn(scope) as? Value.Number)?.value

/** All fields that are in this. */
internal fun Expression.fields(): List<Expression.Field> = when (this) {
    is Expression.Constant -> emptyList()
    is Expression.Field -> listOf(this)
    is Expression.Calculation -> left.fields() + right.fields()
    is Expression.Call -> argument.fields()
    is Expression.Compound -> arguments.flatMap { it.fields() }
}

/** Where the values of an expression come from. */
internal fun interface Scope {
    /** The value at [path]; null: there is none. */
    fun valueOf(path: List<String>): Value?
}

/** The fields of a message. */
internal class MessageScope(private val message: JsonElement) : Scope {
    override fun valueOf(path: List<String>): Value? = path.fold(message as JsonElement?) { at, name ->
        when (at) {
            is JsonObject -> at[name]
            is JsonArray -> name.toIntOrNull()?.let(at::getOrNull)
            else -> null
        }
    }?.let(Value::of)
}

/** A condition of a rule. It does not hold where a value is missing. */
internal data class Comparison(val left: Expression, val operator: String, val right: Expression) {
    /** Whether it holds. */
    fun holdsIn(scope: Scope): Boolean {
        val a = left.valueIn(scope) ?: return false
        val b = right.valueIn(scope) ?: return false
        if (operator == "==" || operator == "!=") return (a == b) == (operator == "==")
        val order = if (a is Value.Number && b is Value.Number) a.value.compareTo(b.value) else return false
        return when (operator) {
            "<" -> order < 0
            "<=" -> order <= 0
            ">" -> order > 0
            else -> order >= 0
        }
    }

    companion object {
        /** All operators, the longer ones first. */
        val OPERATORS = listOf("<=", ">=", "==", "!=", "<", ">")
    }
}

/** The functions that a mapping may use. */
internal enum class Function(val of: (Value) -> Value?) {
    ROUND({ value -> (value as? Value.Number)?.let { Value.of(Math.rint(it.value)) } }),
    ABS({ value -> (value as? Value.Number)?.let { Value.of(Math.abs(it.value)) } }),
    MIN({ value -> value.numbers().minOrNull()?.let(Value::of) }),
    MAX({ value -> value.numbers().maxOrNull()?.let(Value::of) }),
    COUNT({ value -> ((value as? Value.Part)?.json as? JsonArray)?.let { Value.of(it.size.toDouble()) } }),

    /** The heading of a quaternion in rad, counter-clockwise from the x axis. */
    YAW(::yawOf);

    companion object {
        /** The function that is written [name]; null: there is none. */
        fun of(name: String): Function? = entries.find { it.name.lowercase() == name }
    }
}

/** The numbers in an array; what is no number was not measured. */
private fun Value.numbers(): List<Double> =
    ((this as? Value.Part)?.json as? JsonArray)?.mapNotNull { (Value.of(it) as? Value.Number)?.value }.orEmpty()

private fun yawOf(quaternion: Value): Value? {
    val scope = (quaternion as? Value.Part)?.json?.let(::MessageScope) ?: return null
    val (x, y, z, w) = listOf("x", "y", "z", "w").map { (scope.valueOf(listOf(it)) as? Value.Number)?.value ?: return null }
    return Value.of(Math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z)))
}
