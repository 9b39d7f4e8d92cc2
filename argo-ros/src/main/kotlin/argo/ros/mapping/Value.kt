package argo.ros.mapping

import argo.filters.GroundTerm
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.doubleOrNull
import java.math.BigDecimal

internal sealed interface Value {
    data class Number(val value: Double) : Value

    /** Text in a message. The agent gets it as a string. */
    data class Text(val value: String) : Value

    /** An atom or another literal, as written. Booleans of messages are `true` and `false`. */
    data class Symbol(val text: String) : Value

    data class Part(val json: JsonElement) : Value

    /** The value is missing; [why] tells the reason. */
    data class None(val why: String) : Value

    companion object {
        val TRUE = Symbol("true")
        val FALSE = Symbol("false")

        /** Returns the value of [number], or [None] if it is NaN or infinite. Robots send these numbers for missing measurements. */
        fun of(number: Double): Value =
            if (number.isFinite()) Number(number) else None("a number is infinite, or the result of no calculation")

        /** Returns the value of a field. Bridges write NaN and infinite numbers as `null`. */
        fun of(json: JsonElement): Value = when (json) {
            JsonNull -> None("it is null; bridges write so for a number that is infinite or NaN")
            is JsonPrimitive -> when {
                json.isString -> Text(json.content)
                json.content == "true" || json.content == "false" -> Symbol(json.content)
                else -> ofNumber(json)
            }
            else -> Part(json)
        }

        private fun ofNumber(json: JsonPrimitive): Value {
            val number = json.doubleOrNull?.takeIf { it.isFinite() } ?: return None("it is ${json.content}")
            val isWhole = Math.abs(number) >= EXACT && json.content.none { it in ".eE" }
            return if (isWhole && BigDecimal(json.content).compareTo(BigDecimal(number)) != 0) Part(json) else Number(number)
        }
    }
}

/** The greatest length of a list in an argument. Jason compares lists recursively, and 2,000 items overflow its stack. */
internal const val MAX_ITEMS = 1_000

/** 2 to the power of 53, from which on a double cannot hold every whole number. Jason's numbers are doubles. */
private const val EXACT = 9007199254740992.0

/** The largest integer of ROS. Larger whole numbers are written with a fraction. */
private const val MAX_INTEGER = 18446744073709551615.0

/** Returns this value as an argument of a percept, or [Value.None] with the reason if that is impossible. */
internal fun Value.asTerm(): Value = when (this) {
    is Value.Number -> Value.Symbol("${GroundTerm.Number(value)}")
    is Value.Text -> Value.Symbol("${GroundTerm.Text(value)}")
    is Value.Symbol, is Value.None -> this
    is Value.Part -> when (json) {
        is JsonObject -> fieldsOf(json)
        is JsonArray -> listOf(json)
        is JsonPrimitive -> Value.None("$json is an integer that Jason's numbers cannot hold exactly; calculate with it, as FIELD / 1000")
    }
}

private fun listOf(array: JsonArray): Value {
    if (array.size > MAX_ITEMS) {
        return Value.None("it has ${array.size} items, and a list has $MAX_ITEMS at most; take items of it, or min, max or len")
    }
    return terms(array.map { it to "" })
}

/** Returns the fields of [message] as a list of literals. Each literal has the name and the value of a field. */
private fun fieldsOf(message: JsonObject): Value = terms(message.map { (name, value) -> value to functorOf(name) })

/** Returns [items] as a list. Each item becomes the argument of its functor. An empty functor leaves the item as it is. */
private fun terms(items: List<Pair<JsonElement, String>>): Value {
    val terms = items.map { (item, functor) ->
        val value = Value.of(item)
        val term = if (value is Value.None) NOT_MEASURED else value.asTerm()
        if (term !is Value.Symbol) return term
        if (functor == UNREADABLE) return Value.None("it has a field whose name no agent can read")
        if (value is Value.Text && value.value.length > MAX_TEXT) {
            return Value.None("a text in it has ${value.value.length} characters, and in lists and messages a text has $MAX_TEXT at most")
        }
        if (functor.isEmpty()) term.text else "$functor(${term.text})"
    }
    return Value.Symbol(terms.joinToString(",", "[", "]"))
}

private fun functorOf(name: String) = when {
    GroundTerm.ofOrNull("$name(0)") is GroundTerm.Structure -> name
    name.isEmpty() || name.any { it == '\'' || it == '\\' || it.isISOControl() } -> UNREADABLE
    else -> "'$name'"
}

private const val UNREADABLE = "\u0000"

/** The greatest length of a text within a list or a message. A text that a rule names directly may be longer. */
private const val MAX_TEXT = 10_000

/** Replaces a list item or field that is infinite or NaN, so that the other items keep their positions. */
private val NOT_MEASURED = Value.Symbol("null")

/** Returns this value as a double, or null if it is no number. */
internal fun Value.number(): Double? = when (this) {
    is Value.Number -> value
    is Value.Part -> (json as? JsonPrimitive)?.doubleOrNull
    else -> null
}

/** Returns the text of a string or an atom, without quotes, or null for other values. */
internal fun Value.plainText(): String? = when (this) {
    is Value.Text -> value
    is Value.Symbol -> text.removeSurrounding("'")
    else -> null
}

internal fun Value.inWords(): String = when (this) {
    is Value.Number -> "the number ${GroundTerm.Number(value)}"
    is Value.Text -> "the text \"${value.take(SHOWN)}\""
    is Value.Symbol -> "the atom ${text.take(SHOWN)}"
    is Value.None -> "nothing ($why)"
    is Value.Part -> when (json) {
        is JsonArray -> if (json.isEmpty()) "an empty list" else "a list"
        is JsonObject -> "a message"
        is JsonPrimitive -> "the number $json"
    }
}

private const val SHOWN = 40

/** Returns this value as JSON to send. Whole numbers have no fraction, since the field may be an integer. */
internal fun Value.asJson(): JsonElement = when (this) {
    is Value.Number -> when {
        value != Math.rint(value) || Math.abs(value) > MAX_INTEGER -> JsonPrimitive(value)
        else -> JsonPrimitive(BigDecimal(value).toBigInteger())
    }
    is Value.Symbol -> if (text == "true" || text == "false") JsonPrimitive(text == "true") else JsonPrimitive(text.removeSurrounding("'"))
    is Value.Text -> JsonPrimitive(value)
    is Value.Part -> json
    is Value.None -> JsonNull
}
