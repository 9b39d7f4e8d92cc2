package argo.check.syntax

/**
 * A place in a text.
 *
 * @property line counted from 1
 * @property column counted from 1, in UTF-16 units
 */
data class Position(val line: Int, val column: Int) : Comparable<Position> {
    override fun compareTo(other: Position): Int = compareValuesBy(this, other, Position::line, Position::column)

    override fun toString(): String = "$line:$column"
}

/** The part of a text from offset [start] up to offset [end]. The character at [end] is outside. Offsets count UTF-16 units from 0. */
data class Span(val start: Int, val end: Int) {
    val length: Int get() = end - start

    /** Returns true if [offset] is inside this span or at one of its ends. */
    fun touches(offset: Int): Boolean = offset in start..end

    /** Returns the shortest span that contains both spans. */
    operator fun plus(other: Span): Span = Span(minOf(start, other.start), maxOf(end, other.end))
}

/** The lines of [text]; each ends with `\n`, `\r\n` or `\r`. */
class Lines(private val text: String) {
    private val starts: List<Int> = buildList {
        add(0)
        text.forEachIndexed { at, character ->
            if (character == '\n' || character == '\r' && text.getOrNull(at + 1) != '\n') add(at + 1)
        }
    }

    internal val end: Span get() = Span(text.length, text.length)

    /** The number of lines; an empty text has one line. */
    val count: Int get() = starts.size

    /** Returns the position of [offset]. If [offset] is behind the text, returns the position of the end. */
    fun position(offset: Int): Position {
        val at = offset.coerceIn(0, text.length)
        val line = starts.binarySearch(at).let { if (it >= 0) it else -it - 2 }
        return Position(line + 1, at - starts[line] + 1)
    }

    /** Returns the offset of [position]. If [position] is behind the end of its line or text, returns the offset of that end. */
    fun offset(position: Position): Int {
        if (position.line < 1) return 0
        if (position.line > count) return text.length
        val end = starts.getOrNull(position.line)?.let { it - 1 } ?: text.length
        return (starts[position.line - 1] + position.column - 1).coerceIn(starts[position.line - 1], end)
    }

    /** Returns the text of [line] without its line end. Lines count from 1. If there is no such line, the text is empty. */
    fun text(line: Int): String {
        val start = starts.getOrNull(line - 1) ?: return ""
        return text.substring(start, starts.getOrNull(line) ?: text.length).trimEnd('\n', '\r')
    }
}
