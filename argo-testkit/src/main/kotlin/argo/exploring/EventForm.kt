package argo.exploring

import java.io.StringReader
import javax.json.Json
import javax.json.JsonException
import javax.json.JsonNumber
import javax.json.JsonObject
import javax.json.JsonString
import javax.json.JsonValue
import javax.json.stream.JsonParser
import kotlin.time.Duration
import kotlin.time.Duration.Companion.milliseconds

/**
 * A [WorldEvent] as kind and fields. An event as kind and fields is easily turned into Kotlin code, JSON and simpler events. The [fields]
 * have the order of the constructor. Each is a [Duration], an [Int] or a [String].
 */
internal class EventForm(val kind: String, val fields: List<Pair<String, Any>>) {
    val kotlin: String get() = "$kind(${fields.joinToString { (_, value) -> kotlinOf(value) }})"

    /** The event as a JSON object, with times in ms. */
    val json: String
        get() = (listOf("event" to kind) + fields).joinToString(",", "{", "}") { (name, value) ->
            if (value is Duration) "\"${name}_ms\":${value.inWholeMilliseconds}"
            else "\"$name\":${if (value is Int) "$value" else Json.createValue("$value")}"
        }

    fun with(index: Int, value: Any) =
        EventForm(kind, fields.mapIndexed { i, field -> if (i == index) field.first to value else field }).event()

    /** @throws IllegalArgumentException if there is no event of this kind with these fields */
    fun event(): WorldEvent {
        fun time(name: String) = field(name) as? Duration ?: throw wrong("\"${name}_ms\" is a whole number of ms")
        fun text(name: String) = field(name) as? String ?: throw wrong("\"$name\" is a text")
        fun count(name: String) = field(name) as? Int ?: throw wrong("\"$name\" is a whole number")
        return when (kind) {
            "Reads" -> Reads(time("at"), text("board"), text("sensor"), text("percept"))
            "Flickers" -> Flickers(
                time("at"), text("board"), text("sensor"), text("percept"), text("other"), time("every"), time("lasts"),
            )
            "Unplugged" -> Unplugged(time("at"), text("board"), time("lasts"))
            "Hangs" -> Hangs(time("at"), text("board"), time("lasts"))
            "IgnoresRequests" -> IgnoresRequests(time("at"), text("board"), time("lasts"))
            "AnswersLate" -> AnswersLate(time("at"), text("board"), time("by"), time("lasts"))
            "Restarts" -> Restarts(time("at"), text("board"), time("booting"))
            "Garbles" -> Garbles(time("at"), text("board"), count("oneIn"), time("lasts"))
            "Floods" -> Floods(time("at"), text("board"), count("messages"))
            "Hears" -> Hears(time("at"), text("agent"), text("sender"), text("performative"), text("content"))
            "MessagesLate" -> MessagesLate(time("at"), text("agent"), time("by"), time("lasts"))
            else -> throw IllegalArgumentException("there is no event $kind; there are ${KINDS.joinToString()}")
        }
    }

    fun field(name: String): Any? = fields.find { it.first == name }?.second

    private fun wrong(expected: String) = IllegalArgumentException("an event $kind has other fields: $expected, in $json")
}

internal val KINDS = listOf(
    "Reads", "Flickers", "Unplugged", "Hangs", "IgnoresRequests", "AnswersLate", "Restarts", "Garbles", "Floods", "Hears", "MessagesLate",
)

internal val WorldEvent.form: EventForm
    get() = EventForm(
        javaClass.simpleName,
        listOf("at" to at) + when (this) {
            is Reads -> listOf("board" to board, "sensor" to sensor, "percept" to percept)
            is Flickers ->
                listOf("board" to board, "sensor" to sensor, "percept" to percept, "other" to other, "every" to every, "lasts" to lasts)
            is Unplugged -> listOf("board" to board, "lasts" to lasts)
            is Hangs -> listOf("board" to board, "lasts" to lasts)
            is IgnoresRequests -> listOf("board" to board, "lasts" to lasts)
            is AnswersLate -> listOf("board" to board, "by" to by, "lasts" to lasts)
            is Restarts -> listOf("board" to board, "booting" to booting)
            is Garbles -> listOf("board" to board, "oneIn" to oneIn, "lasts" to lasts)
            is Floods -> listOf("board" to board, "messages" to messages)
            is Hears -> listOf("agent" to agent, "sender" to sender, "performative" to performative, "content" to content)
            is MessagesLate -> listOf("agent" to agent, "by" to by, "lasts" to lasts)
        },
    )

internal fun kotlinOf(value: Any): String = when (value) {
    is Duration -> "${value.inWholeMilliseconds}.milliseconds"
    is String -> "\"${value.replace("\\", "\\\\").replace("\"", "\\\"").replace("$", "\\$")}\""
    else -> "$value"
}

/** Writes the events as a JSON array with one object on each line. */
fun jsonOf(events: List<WorldEvent>): String = events.joinToString(",\n  ", "[\n  ", "\n]\n") { it.form.json }

/**
 * Reads the events that [jsonOf] wrote as [json].
 *
 * @throws IllegalArgumentException if [json] cannot be read as events
 */
fun eventsOf(json: String): List<WorldEvent> = arrayIn(json).map { (it as? JsonObject ?: throw noEvents("$it is no object")).event() }

/** Uses Jason's JSON library. `argo.jar` contains the JSON library of the filters under other names. */
private fun arrayIn(json: String): List<JsonValue> = try {
    Json.createParser(StringReader(json)).use { parser ->
        if (parser.next() != JsonParser.Event.START_ARRAY) throw noEvents("it is no array")
        parser.array.also { parser.hasNext() } // hasNext fails on text behind the array
    }
} catch (unreadable: JsonException) {
    throw noEvents("${unreadable.message}")
}

private fun noEvents(reason: String) = IllegalArgumentException("these are no events in JSON: $reason")

private fun JsonObject.event(): WorldEvent {
    val kind = (get("event") as? JsonString)?.string
        ?: throw IllegalArgumentException("an event has a field \"event\", its kind: ${KINDS.joinToString()}")
    val fields = minus("event").map { (name, value) ->
        val whole = (value as? JsonNumber)?.takeIf { it.isIntegral }?.bigIntegerValue()?.takeIf { it.bitLength() < Int.SIZE_BITS }?.toInt()
        when {
            value is JsonString -> name to value.string
            whole == null -> throw noEvents("\"$name\" is a text or a whole number, not $value")
            name.endsWith("_ms") -> name.removeSuffix("_ms") to whole.milliseconds
            else -> name to whole
        }
    }
    return EventForm(kind, fields).event()
}
