package argo.filters.format

import argo.filters.FilterException
import argo.filters.Problem
import kotlinx.serialization.SerializationException
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonPrimitive

/** A value of a JSON document that knows where it stands. */
internal sealed interface JsonNode {
    val position: Position

    /** What the value is, for messages. */
    val words: String

    class Object(override val position: Position, val members: List<Member>) : JsonNode {
        override val words = "an object"
    }

    class Member(val name: String, val position: Position, val value: JsonNode)

    class Array(override val position: Position, val items: List<JsonNode>) : JsonNode {
        override val words = "an array"
    }

    /** @property isText whether it stands in quotes */
    class Scalar(override val position: Position, val content: String, val isText: Boolean) : JsonNode {
        override val words = if (isText) "'$content'" else content
    }
}

/**
 * Reads a JSON document into values that know where they stand.
 *
 * The library says whether the text is JSON and decodes names and scalars. Its own trees have no positions and keep but the last of
 * two members of one name, so the text is taken apart here.
 */
internal class JsonTreeReader(private val text: SourceText, private val source: String) {
    private val json = text.text
    private var at = 0

    /** @throws FilterException if the text is not JSON */
    fun read(): JsonNode {
        try {
            Json.parseToJsonElement(json)
        } catch (e: SerializationException) {
            refuse(OFFSET.find(e.message.orEmpty())?.groupValues?.get(1)?.toIntOrNull() ?: json.length, e.message.orEmpty().lineSequence().first())
        }
        return value(0)
    }

    private fun value(depth: Int): JsonNode {
        if (depth > MAX_DEPTH) refuse(at, "values nested deeper than filters are")
        val start = text.position(blanks())
        return when (json[at]) {
            '{' -> JsonNode.Object(start, group('}') { member(depth) })
            '[' -> JsonNode.Array(start, group(']') { value(depth + 1) })
            else -> scalar()
        }
    }

    private fun member(depth: Int): JsonNode.Member {
        val start = text.position(blanks())
        val name = scalar().content
        blanks()
        at++
        return JsonNode.Member(name, start, value(depth + 1))
    }

    private fun <T> group(close: Char, item: () -> T): List<T> {
        val items = ArrayList<T>()
        do {
            at++
            blanks()
            if (json[at] != close) items += item()
            blanks()
        } while (json[at] != close)
        at++
        return items
    }

    private fun scalar(): JsonNode.Scalar {
        val start = at
        at = if (json[start] == '"') stringEnd(start) else bareEnd(start)
        val written = json.substring(start, at)
        if (written[0] != '"' && !BARE.matches(written)) refuse(start, "'$written' needs quotes")
        val control = written.indexOfFirst { it < ' ' }
        if (control >= 0) refuse(start + control, "text holds the control character U+%04X, which JSON writes as an escape".format(written[control].code))
        val primitive = Json.parseToJsonElement(written) as JsonPrimitive
        return JsonNode.Scalar(text.position(start), primitive.content, primitive.isString)
    }

    private fun stringEnd(start: Int): Int {
        var i = start + 1
        while (json[i] != '"') i += if (json[i] == '\\') 2 else 1
        return i + 1
    }

    private fun bareEnd(start: Int): Int {
        var i = start
        while (i < json.length && json[i] !in ",]}: \t\r\n") i++
        return i
    }

    private fun blanks(): Int {
        while (at < json.length && json[at].isWhitespace()) at++
        return at
    }

    private fun refuse(offset: Int, message: String): Nothing {
        val position = text.position(offset.coerceIn(0, json.length))
        throw FilterException(listOf(Problem(source, position.line, position.column, "the text is not JSON of a filter: $message")))
    }

    private companion object {
        const val MAX_DEPTH = 32
        val OFFSET = Regex("""offset (\d+)""")
        val BARE = Regex("""true|false|null|-?(0|[1-9]\d*)(\.\d+)?([eE][+-]?\d+)?""")
    }
}
