package argo.ros.joining

import argo.filters.GroundTerm
import argo.ros.bridge.part
import argo.ros.bridge.text
import javino.wire.BoardAction
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.doubleOrNull

/** A request is refused; [message] gives its sender the reason. */
internal class RefusedRequest(message: String) : Exception(message)

/**
 * Returns the command for the action [name] with the arguments in [request]. The arguments are in the field `arguments` or `data`, or are
 * two numbers of a Twist. Without these fields there are no arguments.
 *
 * @param actions the participant's actions, or null if they are not known
 * @throws RefusedRequest if the result is no command, or no command of [actions]
 */
internal fun commandOf(name: String, request: JsonObject, actions: List<BoardAction>?): String {
    val arguments = argumentsIn(request).map(::termOf)
    val text = if (arguments.isEmpty()) name else arguments.joinToString(",", "$name(", ")")
    if (GroundTerm.ofOrNull(text) !is GroundTerm.Structure) throw RefusedRequest("$text is no command")
    val fitting = actions?.filter { it.name == name } ?: return text
    if (fitting.isEmpty()) throw RefusedRequest("there is no action $name; there are ${actions.joinToString { it.name }}")
    if (fitting.none { it.arguments == BoardAction.ANY || it.arguments == arguments.size }) {
        throw RefusedRequest("$name has ${fitting.joinToString(" or ") { "${it.arguments}" }} arguments, not ${arguments.size}")
    }
    return text
}

private fun argumentsIn(request: JsonObject): List<JsonElement> {
    val given = request["arguments"] ?: request["data"] ?: return twistIn(request).orEmpty()
    return given as? JsonArray ?: listOf(given)
}

/** Returns [value] as a term. If it is no term, returns it as a string. */
private fun termOf(value: JsonElement): String = when (value) {
    is JsonArray -> value.joinToString(",", "[", "]", transform = ::termOf)
    is JsonObject -> throw RefusedRequest("an argument is a number, a text, true, false or an array of these, not $value")
    JsonNull -> throw RefusedRequest("an argument is null; bridges write so for a number that is infinite or NaN")
    is JsonPrimitive -> when {
        value.isString -> GroundTerm.ofOrNull(value.content)?.toString() ?: "${GroundTerm.Text(value.content)}"
        value.content == "true" || value.content == "false" -> value.content
        else -> value.doubleOrNull?.takeIf { it.isFinite() }?.let { "${GroundTerm.Number(it)}" }
            ?: throw RefusedRequest("${value.content} is no number that an action can have")
    }
}

private fun twistIn(message: JsonObject): List<JsonElement>? {
    val forward = message.part("linear")?.get("x") ?: return null
    val turn = message.part("angular")?.get("z") ?: return null
    return listOf(forward, turn)
}

/**
 * Returns the command in the field `command` or `data` of [request].
 *
 * @throws RefusedRequest if the field has no command
 */
internal fun writtenCommand(request: JsonObject): String {
    val text = (request.text("command") ?: request.text("data")).orEmpty().trim()
    if (GroundTerm.ofOrNull(text) is GroundTerm.Structure) return text
    throw RefusedRequest("'$text' is no command; one is a literal, as \"speed(120)\"")
}
