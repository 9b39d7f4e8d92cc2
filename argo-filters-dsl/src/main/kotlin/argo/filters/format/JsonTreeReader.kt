package argo.filters.format

import argo.filters.FilterException
import argo.filters.Problem
import com.fasterxml.jackson.core.JsonFactory
import com.fasterxml.jackson.core.JsonLocation
import com.fasterxml.jackson.core.JsonProcessingException
import com.fasterxml.jackson.core.JsonToken
import com.fasterxml.jackson.core.StreamReadConstraints
import com.fasterxml.jackson.core.exc.StreamConstraintsException
import com.fasterxml.jackson.core.io.ContentReference
import com.fasterxml.jackson.core.io.JsonEOFException

/** Reads a JSON document into values with their positions. Keeps repeated members separate. */
internal class JsonTreeReader(text: String, private val source: String) {
    private val parser = FACTORY.createParser(text)

    /** @throws FilterException if the text is not JSON */
    fun read(): FilterNode = try {
        if (parser.nextToken() == null) refuse(parser.currentLocation(), "it is empty")
        val root = value()
        if (parser.nextToken() != null) refuse(parser.currentTokenLocation(), "something follows its end")
        root
    } catch (e: JsonProcessingException) {
        refuse(e.location ?: parser.currentLocation(), words(e))
    }

    /** Describes the fault in the terms of JSON. The parser's own message mentions classes, settings and readers. */
    private fun words(e: JsonProcessingException): String {
        val found = e.originalMessage
        return when {
            e is StreamConstraintsException && DEPTH in found -> "it has arrays and objects nested more than $MAX_DEPTH deep"
            e is StreamConstraintsException -> "it holds a number or a name that is too long"
            "ALLOW_COMMENTS" in found -> "it has a comment, and JSON has none; leave it out"
            "ALLOW_NON_NUMERIC" in found -> "NaN and infinity are no numbers of JSON"
            e is JsonEOFException -> "it ends$surroundings"
            CLOSE in found -> "'${if (parser.parsingContext.inArray()) '}' else ']'}' stands$surroundings"
            else -> EXPECTED.entries.find { it.key in found }?.let { "expected ${it.value}$surroundings" }
                ?: found.substringBefore(": was expecting")
        }
    }

    private val surroundings: String
        get() = parser.parsingContext.let { within ->
            if (within.inRoot()) return ""
            val start = within.startLocation(ContentReference.unknown())
            " in the ${if (within.inArray()) "array" else "object"} that begins in line ${start.lineNr}, column ${start.columnNr}"
        }

    private fun value(): FilterNode {
        val at = position(parser.currentTokenLocation())
        return when (val token = parser.currentToken()) {
            JsonToken.START_OBJECT -> FilterNode.Object(at, until(JsonToken.END_OBJECT, ::member))
            JsonToken.START_ARRAY -> FilterNode.Array(at, until(JsonToken.END_ARRAY, ::value))
            else -> (token == JsonToken.VALUE_STRING).let { FilterNode.Scalar(at, parser.text, isText = it, isBare = !it) }
        }
    }

    private fun member(): FilterNode.Member {
        val at = position(parser.currentTokenLocation())
        val name = parser.text
        parser.nextToken()
        return FilterNode.Member(name, at, value())
    }

    private fun <T> until(end: JsonToken, item: () -> T): List<T> = buildList {
        while (parser.nextToken() != end) add(item())
    }

    private fun position(location: JsonLocation) = Position(location.lineNr, location.columnNr)

    private fun refuse(at: JsonLocation, message: String): Nothing =
        throw FilterException(listOf(Problem(source, at.lineNr, at.columnNr, "the text is not JSON of a filter: $message")))

    private companion object {
        const val MAX_DEPTH = 32
        const val DEPTH = "nesting depth"
        const val CLOSE = "close marker"

        /** Beginnings of the parser's messages. Each has the missing part of the document. */
        val EXPECTED = mapOf(
            "to start field name" to "a name in double quotes",
            "expecting a colon" to "a colon between a name and its value",
            "expecting comma" to "a comma, or the end,",
            "expected a value" to "a value",
            "expected a valid value" to "a value",
        )
        val FACTORY: JsonFactory =
            JsonFactory.builder().streamReadConstraints(StreamReadConstraints.builder().maxNestingDepth(MAX_DEPTH).build()).build()
    }
}
