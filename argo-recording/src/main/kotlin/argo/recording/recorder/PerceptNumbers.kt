package argo.recording.recorder

import argo.filters.GroundTerm
import argo.recording.PerceivedSnapshot
import argo.recording.storage.Encoded
import argo.recording.storage.RecordChannel

/**
 * Makes messages of the numbers in percepts, for programs that plot: `dist(front,38)` of the agent `driver` is `{"value":38}` in the topic
 * `/driver/percept/dist/front`, when it changes. For the thread that stores records.
 *
 * @param channel returns the channel of a topic for a schema with a name
 * @param warn takes a sentence if there are more than [MAX_CHANNELS] topics
 */
internal class PerceptNumbers(
    private val agent: String,
    private val channel: (topic: String, schemaName: String, jsonSchema: String) -> RecordChannel,
    private val warn: (String) -> Unit,
) {
    private class Course(val channel: RecordChannel, var last: String? = null)

    private val courses = HashMap<String, Course>()
    private var hasWarned = false

    /** Returns a message for each changed number in [snapshots], whose times are ahead by [offsetNs]. */
    fun of(snapshots: List<PerceivedSnapshot>, offsetNs: Long): List<Encoded> = snapshots.flatMap { snapshot ->
        snapshot.texts.mapNotNull { changed(it, snapshot.namespace, snapshot.receivedNs + offsetNs) }
    }

    private fun changed(percept: String, namespace: String?, timeNs: Long): Encoded? {
        val literal = GroundTerm.ofOrNull(percept) as? GroundTerm.Structure ?: return null
        val numbers = literal.arguments.filterIsInstance<GroundTerm.Number>().filter { it.value.isFinite() }.ifEmpty { return null }
        val words = literal.arguments.filter { it !is GroundTerm.Number }
        val functor = literal.predicate.functor
        val topic = (listOfNotNull(agent, "percept", namespace, functor) + words.map { nameOf("$it") }).joinToString("/", "/")
        val course = courses[topic] ?: newCourse(topic, numbers.size) ?: return null
        val json = namesOf(numbers.size).zip(numbers).joinToString(",", "{", "}") { (name, number) -> "\"$name\":$number" }
        if (json == course.last) return null
        course.last = json
        return Encoded(course.channel, timeNs, json.encodeToByteArray())
    }

    private fun newCourse(topic: String, numbers: Int): Course? {
        if (courses.size < MAX_CHANNELS) {
            val fields = namesOf(numbers).joinToString(",") { "\"$it\":{\"type\":\"number\"}" }
            val schema = "{\"type\":\"object\",\"properties\":{$fields}}"
            return Course(channel(topic, "argo.Numbers$numbers", schema)).also { courses[topic] = it }
        }
        if (!hasWarned) warn("more than $MAX_CHANNELS percepts of agent $agent have numbers; the others have no topic of their own")
        hasWarned = true
        return null
    }

    private fun namesOf(numbers: Int) = if (numbers == 1) listOf("value") else (1..numbers).map { "value$it" }

    private fun nameOf(text: String) = text.replace(NO_NAME, "_")

    private companion object {
        const val MAX_CHANNELS = 1_000
        val NO_NAME = Regex("\\W")
    }
}
