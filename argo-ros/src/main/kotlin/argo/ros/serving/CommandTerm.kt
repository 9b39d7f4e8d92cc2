package argo.ros.serving

import argo.filters.GroundTerm
import argo.ros.bridge.part
import javino.wire.BoardAction
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.doubleOrNull

/** A request is refused; [message] is for the client. */
internal class RefusedRequest(message: String) : Exception(message)

/**
 * Makes the command for the action [name] of a participant, with the arguments in [request]: an array; an object with the array
 * `arguments`, the field `data` or no field; or another object, whose values are the arguments in their order. A Twist gives two numbers.
 *
 * @param actions the participant's actions; null: they are not known
 * @throws RefusedRequest if that is no command, or not among [actions]
 */
internal fun commandOf(name: String, request: JsonElement?, actions: List<BoardAction>?): String {
    val functor = name.replace("/", "::")
    val arguments = argumentsIn(request).map(::termOf)
    val text = if (arguments.isEmpty()) functor else arguments.joinToString(",", "$functor(", ")")
    val command = GroundTerm.ofOrNull(text) as? GroundTerm.Structure ?: throw RefusedRequest("$text is no command")
    val plain = command.predicate.functor
    val fitting = actions?.filter { it.name == plain } ?: return text
    if (fitting.isEmpty()) throw RefusedRequest("there is no action $plain; there are ${actions.joinToString { it.name }}")
    if (fitting.none { it.arguments == BoardAction.ANY || it.arguments == arguments.size }) {
        throw RefusedRequest("$plain has ${fitting.joinToString(" or ") { "${it.arguments}" }} arguments, not ${arguments.size}")
    }
    return text
}

private fun argumentsIn(request: JsonElement?): List<JsonElement> = when (request) {
    null, JsonNull -> emptyList()
    is JsonArray -> request
    is JsonPrimitive -> listOf(request)
    is JsonObject -> (request["arguments"] ?: request["data"])?.let(::argumentsIn) ?: twistIn(request) ?: request.values.toList()
}

/** Returns [value] as a term; a client's text that is no term becomes a string. */
private fun termOf(value: JsonElement): String = when (value) {
    is JsonArray -> value.joinToString(",", "[", "]", transform = ::termOf)
    is JsonObject -> throw RefusedRequest("an argument is a number, a text, true, false or an array of these, not $value")
    JsonNull -> throw RefusedRequest("an argument is missing: it is null")
    is JsonPrimitive -> when {
        value.isString -> GroundTerm.ofOrNull(value.content)?.toString() ?: stringOf(value.content)
        value.content == "true" || value.content == "false" -> value.content
        else -> value.doubleOrNull?.takeIf { it.isFinite() }?.let { "${GroundTerm.Number(it)}" }
            ?: throw RefusedRequest("${value.content} is no number that an action can have")
    }
}

private fun stringOf(text: String): String = try {
    "${GroundTerm.Text(text)}"
} catch (_: IllegalArgumentException) {
    throw RefusedRequest("the text $text cannot be an argument, because of its backslashes")
}

private fun twistIn(message: JsonObject): List<JsonElement>? {
    val forward = message.part("linear")?.get("x") ?: return null
    val turn = message.part("angular")?.get("z") ?: return null
    return listOf(forward, turn)
}

/** Reads the command in [written], the text of a request to `act`. */
internal fun writtenCommand(written: String?): String {
    val text = written?.trim().orEmpty()
    if (GroundTerm.ofOrNull(text) is GroundTerm.Structure) return text
    throw RefusedRequest("'$text' is no command; one is a literal, as \"speed(120)\"")
}
