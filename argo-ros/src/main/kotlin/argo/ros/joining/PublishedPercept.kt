package argo.ros.joining

import argo.filters.GroundTerm
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive

/**
 * A percept as a message.
 *
 * @property topic the end of the topic's name, such as `dist/front`
 * @property type a type of `std_msgs`
 */
internal data class PublishedPercept(val topic: String, val type: String, val message: JsonObject)

/**
 * Returns the percept [text] as a message, or null if it is no literal or has variables.
 *
 * The functor and all arguments except the last form the topic's name. The last argument is the value: `dist(front,38)` is 38 on
 * `dist/front`. A percept without arguments has the value `true`.
 */
internal fun publishedOf(text: String): PublishedPercept? {
    val percept = GroundTerm.ofOrNull(text) as? GroundTerm.Structure ?: return null
    val arguments = percept.arguments
    val places = arguments.dropLast(1).takeWhile { it is GroundTerm.Structure && it.arguments.isEmpty() }
    val name = listOf(percept.predicate.toString()) + places.map { "$it" }
    val topic = name.joinToString("/", transform = ::graphName)
    val values = arguments.drop(places.size)
    val value = values.singleOrNull()
    return when {
        values.isEmpty() -> PublishedPercept(topic, BOOL, data(JsonPrimitive(true)))
        value is GroundTerm.Number -> PublishedPercept(topic, NUMBER, data(JsonPrimitive(value.value)))
        value is GroundTerm.Text -> PublishedPercept(topic, STRING, data(JsonPrimitive(value.text)))
        "$value" == "true" || "$value" == "false" -> PublishedPercept(topic, BOOL, data(JsonPrimitive("$value" == "true")))
        values.all { it is GroundTerm.Number } -> PublishedPercept(topic, NUMBERS, numbers(values.map { (it as GroundTerm.Number).value }))
        else -> PublishedPercept(topic, STRING, data(JsonPrimitive(values.joinToString(","))))
    }
}

internal val ABSENT: JsonObject = data(JsonPrimitive(false))

internal const val BOOL = "std_msgs/Bool"
internal const val NUMBER = "std_msgs/Float64"
internal const val NUMBERS = "std_msgs/Float64MultiArray"
internal const val STRING = "std_msgs/String"

internal fun data(value: JsonElement) = JsonObject(mapOf("data" to value))

private fun numbers(values: List<Double>) = JsonObject(
    mapOf(
        "layout" to JsonObject(mapOf("dim" to JsonArray(emptyList()), "data_offset" to JsonPrimitive(0))),
        "data" to JsonArray(values.map { JsonPrimitive(it) }),
    ),
)

/** Returns [text] as a valid part of a ROS name: letters, digits and `_`, with a letter first. */
internal fun graphName(text: String): String {
    val name = text.removeSurrounding("'").map { if (it in 'a'..'z' || it in 'A'..'Z' || it in '0'..'9') it else '_' }.joinToString("")
    return if (name.firstOrNull()?.isLetter() == true) name else "x$name"
}
