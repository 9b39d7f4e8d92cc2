package argo.recording.recorder

import argo.filters.GroundTerm
import argo.recording.PerceivedSnapshot
import argo.recording.storage.Encoded
import argo.recording.storage.RecordChannel
import java.util.concurrent.TimeUnit

/**
 * Makes messages of the numbers in percepts, for programs that plot. If the number in `dist(front,38)` of the agent `driver` changes, this
 * class puts the message `{"value":38}` into the topic `/driver/percept/dist/front`. If the number changes several times within [LEAST_NS],
 * only the last change counts. For the thread that stores records.
 *
 * @param channel returns the channel for a topic and its schema
 * @param warn takes a sentence if there are more than [MAX_CHANNELS] topics
 */
internal class PerceptNumbers(
    private val agent: String,
    private val channel: (topic: String, schemaName: String, jsonSchema: String) -> RecordChannel,
    private val warn: (String) -> Unit,
) {
    private class Course(val channel: RecordChannel) {
        var text = "" // the newest numbers
        var storedNs: Long? = null // the time of the newest message
    }

    private val courses = HashMap<String, Course>()
    private val indexed = HashSet<String>() // topics that several percepts of one message share; their first numbers distinguish them
    private val held = LinkedHashMap<Course, Encoded>() // changes that wait, since they came soon after others
    private var hasWarned = false

    /** Notes the changed numbers in [snapshots], with [offsetNs] added to their times. Returns the messages that are due at [nowNs]. */
    fun of(snapshots: List<PerceivedSnapshot>, offsetNs: Long, nowNs: Long): List<Encoded> {
        for (snapshot in snapshots) note(snapshot.texts.mapNotNull { numbersIn(it, snapshot.namespace) }, snapshot.receivedNs + offsetNs)
        val due = held.filterKeys { course -> course.storedNs?.let { nowNs - it >= LEAST_NS } != false }
        held -= due.keys
        due.forEach { (course, message) -> course.storedNs = message.timeNs }
        return due.values.toList()
    }

    private fun numbersIn(percept: String, namespace: String?): Pair<String, List<GroundTerm.Number>>? {
        val literal = GroundTerm.ofOrNull(percept) as? GroundTerm.Structure ?: return null
        val numbers = literal.arguments.filterIsInstance<GroundTerm.Number>().filter { it.value.isFinite() }.ifEmpty { return null }
        val words = literal.arguments.filter { it !is GroundTerm.Number }
        return topicOf(listOfNotNull(agent, "percept", namespace, literal.predicate.functor) + words) to numbers
    }

    private fun topicOf(names: List<Any>) = names.joinToString("/", "/") { "$it".replace(NO_NAME, "_") }

    private fun note(percepts: List<Pair<String, List<GroundTerm.Number>>>, timeNs: Long) {
        indexed += percepts.groupingBy { it.first }.eachCount().filterValues { it > 1 }.keys
        for ((topic, numbers) in percepts) {
            if (topic in indexed) note(topic + topicOf(numbers.dropLast(1)).removeSuffix("/"), numbers.takeLast(1), timeNs)
            else note(topic, numbers, timeNs)
        }
    }

    private fun note(topic: String, numbers: List<GroundTerm.Number>, timeNs: Long) {
        val course = courseOf(topic, numbers.size) ?: return
        val json = namesOf(numbers.size).zip(numbers).joinToString(",", "{", "}") { (name, number) -> "\"$name\":$number" }
        if (json == course.text) return
        course.text = json
        held[course] = Encoded(course.channel, timeNs, json.encodeToByteArray())
    }

    private fun courseOf(topic: String, numbers: Int): Course? = courses[topic] ?: when {
        courses.size < MAX_CHANNELS -> Course(channel(topic, "argo.Numbers$numbers", schemaOf(numbers))).also { courses[topic] = it }
        hasWarned -> null
        else -> {
            hasWarned = true
            warn("more than $MAX_CHANNELS percepts of agent $agent have numbers; the others have no topic of their own")
            null
        }
    }

    private fun schemaOf(numbers: Int): String {
        val fields = namesOf(numbers).joinToString(",") { "\"$it\":{\"type\":\"number\"}" }
        return """{"type":"object","description":"$MEANING","properties":{$fields}}"""
    }

    private fun namesOf(numbers: Int) = if (numbers == 1) listOf("value") else (1..numbers).map { "value$it" }

    private companion object {
        const val MAX_CHANNELS = 1_000
        const val MEANING = "numbers of a percept, when they change, ten times a second at most"
        val LEAST_NS = TimeUnit.MILLISECONDS.toNanos(100)
        val NO_NAME = Regex("\\W")
    }
}
