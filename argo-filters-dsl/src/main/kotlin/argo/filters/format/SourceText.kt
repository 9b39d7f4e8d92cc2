package argo.filters.format

import argo.filters.FilterException
import argo.filters.Problem
import java.nio.ByteBuffer
import java.nio.CharBuffer
import java.nio.charset.Charset
import java.nio.charset.CodingErrorAction

/** A position in a text. Lines and columns are counted from 1, columns in characters. */
internal data class Position(val line: Int, val column: Int) : Comparable<Position> {
    override fun compareTo(other: Position): Int = compareValuesBy(this, other, Position::line, Position::column)
}

/** A text with the positions of its lines. A line ends with LF, CR or both. */
internal class SourceText(val text: String) {
    private val lineStarts: IntArray = intArrayOf(0) +
        text.indices.filter { text[it] == '\n' || text[it] == '\r' && text.getOrNull(it + 1) != '\n' }.map { it + 1 }

    val end: Position
        get() = position(text.length)

    fun offset(line: Int, column: Int): Int = (lineStarts[minOf(line, lineStarts.size) - 1] + column - 1).coerceIn(0, text.length)

    fun position(offset: Int): Position {
        val found = lineStarts.binarySearch(offset)
        val line = if (found >= 0) found else -found - 2
        return Position(line + 1, offset - lineStarts[line] + 1)
    }
}

/**
 * Decodes [bytes] from [charset], and removes a byte-order mark.
 *
 * @throws FilterException if some bytes are not in the charset; the exception has their position in [source]
 */
internal fun decodeStrictly(bytes: ByteArray, charset: Charset, source: String): String {
    val chars = CharBuffer.allocate(bytes.size + 1)
    val decoder = charset.newDecoder().onMalformedInput(CodingErrorAction.REPORT).onUnmappableCharacter(CodingErrorAction.REPORT)
    val result = decoder.decode(ByteBuffer.wrap(bytes), chars, true)
    val text = chars.flip().toString().removePrefix("\uFEFF")
    if (!result.isError) return text
    val at = SourceText(text).end
    throw FilterException(listOf(Problem(source, at.line, at.column, "a byte that is not $charset, which the document's encoding is")))
}
