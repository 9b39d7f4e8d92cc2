package argo.filters.format

import argo.filters.FilterException
import argo.filters.Problem
import com.fasterxml.jackson.core.JsonFactory
import com.fasterxml.jackson.core.JsonLocation
import com.fasterxml.jackson.core.JsonProcessingException
import com.fasterxml.jackson.core.JsonToken
import com.fasterxml.jackson.core.StreamReadConstraints

/** Reads a JSON document into values with their positions, and two members of one name as two. */
internal class JsonTreeReader(text: String, private val source: String) {
    private val parser = FACTORY.createParser(text)

    /** @throws FilterException if the text is not JSON */
    fun read(): FilterNode = try {
        if (parser.nextToken() == null) refuse(parser.currentLocation(), "it is empty")
        val root = value()
        if (parser.nextToken() != null) refuse(parser.currentTokenLocation(), "something follows its end")
        root
    } catch (e: JsonProcessingException) {
        refuse(e.location ?: parser.currentLocation(), e.originalMessage)
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
        val FACTORY: JsonFactory =
            JsonFactory.builder().streamReadConstraints(StreamReadConstraints.builder().maxNestingDepth(MAX_DEPTH).build()).build()
    }
}
