package argo.ros.joining

import argo.filters.foreignText
import argo.filters.matching.perceptsOf
import javino.link.SendOptions
import javino.wire.BoardAction
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive

/** A board or an agent that takes part in a graph. Safe for use by several threads. No function waits. */
internal interface Participant {
    /** The prefix of the participant's topic and service names, without the leading slash. */
    val name: String

    /** The participant's actions, or null if they are not known. */
    val actions: List<BoardAction>?

    /** Sends [command] and calls [done] once with its outcome, on any thread. */
    fun act(command: String, options: SendOptions, done: (Outcome) -> Unit)
}

/**
 * The outcome of a command.
 *
 * @param error the name of the error, such as `act_failed`, or null if the command was carried out
 * @param message the reason of the failure, for the user
 */
internal data class Outcome(val error: String?, val message: String) {
    val response get() = JsonObject(
        mapOf("success" to JsonPrimitive(error == null), "message" to JsonPrimitive(if (error == null) "" else inWords)),
    )

    val inWords get() = "$error: $message"

    companion object {
        val DONE = Outcome(null, "")

        const val REFUSED = "act_refused"
    }
}

/**
 * Publishes a participant's percepts. Not safe for use by several threads at once.
 *
 * @param base the participant's name, and the board's namespace if any: `/uno`
 * @param warn takes reports of percepts without a topic, each text once
 */
internal class PerceptPublisher(private val base: String, private val topics: Topics, private val warn: (String) -> Unit) {
    private var plain = emptySet<String>()

    /** Publishes the board's message [text]: each percept on its topic, and the whole message on `percepts`. */
    fun publish(text: String) = publish(perceptsOf(text))

    /** Publishes a message that has been split into its [percepts]. */
    fun publish(percepts: List<String>) {
        val messages = percepts.mapNotNull { percept -> publishedOf(percept) ?: null.also { leftOut(percept) } }
            .groupBy { it.topic to it.type }
        val now = messages.keys.filter { it.second == BOOL }.map { it.first }.toSet()
        (plain - now).forEach { topics.publish("$base/$it", BOOL, listOf(ABSENT)) }
        plain = now
        messages.forEach { (key, its) -> topics.publish("$base/${key.first}", key.second, its.map { it.message }) }
        topics.publish("$base/$ALL", STRING, listOf(data(JsonPrimitive(percepts.joinToString("") { "$it;" }))))
    }

    private fun leftOut(percept: String) =
        warn("${foreignText(percept)} is no literal without variables, and is published on $base/$ALL only")

    private companion object {
        const val ALL = "percepts"
    }
}
