package argo.tools.command

import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive

/** Makes a JSON object with [members]. Null, booleans, numbers, JSON and lists keep their type. Other values become text. */
internal fun jsonOf(vararg members: Pair<String, Any?>): JsonObject =
    JsonObject(members.associate { (name, value) -> name to element(value) })

internal fun jsonArrayOf(values: List<Any?>): JsonArray = JsonArray(values.map(::element))

private fun element(value: Any?): JsonElement = when (value) {
    null -> JsonNull
    is JsonElement -> value
    is Boolean -> JsonPrimitive(value)
    is Number -> JsonPrimitive(value)
    is List<*> -> jsonArrayOf(value)
    else -> JsonPrimitive("$value")
}
