package argo.ros.mapping

import argo.filters.GroundTerm
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.doubleOrNull

/** What an expression has for a value. */
internal sealed interface Value {
    /** A number; neither infinite nor no number. */
    data class Number(val value: Double) : Value

    /** Text in a message, a string to the agent. */
    data class Text(val value: String) : Value

    /** An atom, or a literal, as it is written. `true` and `false` are booleans in a message. */
    data class Symbol(val text: String) : Value

    /** A part of a message that is none of these. */
    data class Part(val json: JsonElement) : Value

    companion object {
        /** The number, unless it is none or infinite: then a robot has not measured. */
        fun of(number: Double): Value? = number.takeIf { it.isFinite() }?.let(::Number)

        /** The value of a field; null: it has none, which is also how a bridge writes what is no number. */
        fun of(json: JsonElement): Value? = when (json) {
            JsonNull -> null
            is JsonPrimitive -> when {
                json.isString -> Text(json.content)
                json.content == "true" || json.content == "false" -> Symbol(json.content)
                else -> json.doubleOrNull?.let(::of)
            }
            else -> Part(json)
        }
    }
}

/** The longest list that an argument is made of. */
private const val MAX_ITEMS = 100

/** This as an argument of a percept; null: an agent cannot have it. */
internal fun Value.asTerm(): String? = when (this) {
    is Value.Number -> "${GroundTerm.Number(value)}"
    is Value.Symbol -> text
    is Value.Text -> try {
        "${GroundTerm.Text(value)}"
    } catch (_: IllegalArgumentException) {
        null // Jason cannot write each string
    }
    is Value.Part -> (json as? JsonArray)?.takeIf { it.size <= MAX_ITEMS }?.map { Value.of(it)?.asTerm() }
        ?.takeIf { null !in it }?.joinToString(",", "[", "]")
}

/** This in a message that is sent. Whole numbers are written without a fraction, since a field may be an integer. */
internal fun Value.asJson(): JsonElement = when (this) {
    is Value.Number -> if (value == Math.rint(value) && Math.abs(value) < EXACT) JsonPrimitive(value.toLong()) else JsonPrimitive(value)
    is Value.Symbol -> if (text == "true" || text == "false") JsonPrimitive(text == "true") else JsonPrimitive(text.removeSurrounding("'"))
    is Value.Text -> JsonPrimitive(value)
    is Value.Part -> json
}

private const val EXACT = 9007199254740992.0
