package argo.ros.bridge

import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.buildJsonObject
import kotlinx.serialization.json.contentOrNull
import kotlinx.serialization.json.put

/** Writes the operation [op] of the rosbridge protocol with the [fields] that are not null. */
internal fun operation(op: String, vararg fields: Pair<String, Any?>): String = buildJsonObject {
    put("op", op)
    for ((name, value) in fields) {
        when (value) {
            null -> Unit
            is JsonElement -> put(name, value)
            is Number -> put(name, value)
            is Boolean -> put(name, value)
            else -> put(name, "$value")
        }
    }
}.toString()

internal fun operationIn(text: String): JsonObject? = try {
    Json.parseToJsonElement(text) as? JsonObject
} catch (_: IllegalArgumentException) { // malformed JSON
    null
} catch (_: StackOverflowError) { // thousands of nested brackets
    null
}

internal fun JsonObject.text(name: String): String? = (this[name] as? JsonPrimitive)?.takeIf { it !is JsonNull }?.contentOrNull

internal fun JsonObject.part(name: String): JsonObject? = this[name] as? JsonObject

internal fun JsonObject.flag(name: String): Boolean? = text(name)?.toBooleanStrictOrNull()

/**
 * Reads a ROS 1 time (`secs`, `nsecs`) or a ROS 2 time (`sec`, `nanosec`), in ns. Returns null for other objects and for zero. In ROS, zero
 * means that the time is unknown.
 */
internal fun JsonObject.rosNanos(): Long? {
    val seconds = (text("secs") ?: text("sec"))?.toLongOrNull() ?: return null
    val nanos = (text("nsecs") ?: text("nanosec"))?.toLongOrNull() ?: return null
    if (seconds !in 0..MAX_SECONDS || nanos !in 0 until NANOS_PER_SECOND) return null
    return (seconds * NANOS_PER_SECOND + nanos).takeIf { it != 0L }
}

private const val NANOS_PER_SECOND = 1_000_000_000L

/** Up to this limit, a time in s fits into a [Long] as ns. */
private const val MAX_SECONDS = 9_000_000_000L
