package argo.ros.serving

import argo.filters.matching.perceptsOf
import javino.SendOptions
import javino.wire.BoardAction
import kotlinx.serialization.json.JsonPrimitive

/** A board or an agent that takes part in the graph. Any thread may call; no function waits. */
internal interface Participant {
    /** The name below which its topics, services and actions are, without the slash. */
    val name: String

    /** The actions that it has; null: they are not known, and every command is taken. */
    val actions: List<BoardAction>?

    /** Sends [command] and calls [done] once with its outcome, on any thread. */
    fun act(command: String, options: SendOptions, done: (Outcome) -> Unit)
}

/**
 * The outcome of a command.
 *
 * @property error the atom of the failure, as `act_failed`; null: it was carried out
 * @property message the reason of the failure, for a person
 */
internal data class Outcome(val error: String?, val message: String) {
    companion object {
        val DONE = Outcome(null, "")
    }
}

/**
 * Publishes a participant's percepts. For one thread at a time.
 *
 * @param base the name of the participant, and of the board's namespace if it has one: `/uno`
 */
internal class PerceptPublisher(private val base: String, private val topics: Topics) {
    private var plain = emptySet<String>()

    /** Publishes the board's message [text]: each percept on its topic, and the whole message on `percepts`. */
    fun publish(text: String) = publish(perceptsOf(text))

    /** As the other [publish], with the percepts one by one. */
    fun publish(percepts: List<String>) {
        val samples = percepts.mapNotNull(::sampleOf)
        val now = samples.filter { it.type == BOOL }.map { it.topic }.toSet()
        (plain - now).forEach { topics.publish("$base/$it", BOOL, ABSENT) }
        plain = now
        samples.forEach { topics.publish("$base/${it.topic}", it.type, it.message) }
        topics.publish("$base/$ALL", STRING, data(JsonPrimitive(percepts.joinToString("") { "$it;" })))
    }

    private companion object {
        const val ALL = "percepts"
    }
}
