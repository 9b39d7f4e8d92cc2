package argo.exploring

/**
 * Reads an array of JSON whose elements are objects of texts and whole numbers. The library that the filters read JSON with is not on each
 * class path.
 */
internal class FlatJson(private val text: String) {
    private var at = 0

    /** @throws IllegalArgumentException if [text] is something else */
    fun objects(): List<Map<String, Any>> = list('[', ']') { list('{', '}') { member() }.toMap() }.also {
        if (next() != null) throw unreadable("nothing more")
    }

    private fun <T> list(open: Char, close: Char, element: () -> T): List<T> {
        take(open)
        val elements = ArrayList<T>()
        if (next() != close) {
            elements += element()
            while (next() == ',') {
                take(',')
                elements += element()
            }
        }
        take(close)
        return elements
    }

    private fun member(): Pair<String, Any> {
        val name = string()
        take(':')
        return name to if (next() == '"') string() else number()
    }

    private fun number(): Int {
        next()
        val digits = text.drop(at).takeWhile { it == '-' || it.isDigit() }
        at += digits.length
        return digits.toIntOrNull() ?: throw unreadable("a whole number")
    }

    private fun string(): String {
        take('"')
        val read = StringBuilder()
        while (true) {
            when (val char = text.getOrNull(at++) ?: throw unreadable("the end of a text")) {
                '"' -> return "$read"
                '\\' -> read.append(escaped())
                else -> read.append(char)
            }
        }
    }

    private fun escaped(): Char = when (val char = text.getOrNull(at++)) {
        '"', '\\', '/' -> char
        'n' -> '\n'
        't' -> '\t'
        'u' -> {
            at += HEX_DIGITS
            val digits = text.substring(minOf(at - HEX_DIGITS, text.length), minOf(at, text.length))
            digits.toIntOrNull(HEX)?.toChar() ?: throw unreadable("four hexadecimal digits")
        }
        else -> throw unreadable("one of the escapes \\\" \\\\ \\n \\t \\u")
    }

    private fun take(char: Char) {
        if (next() != char) throw unreadable("'$char'")
        at++
    }

    /** Returns the next character that is no space; null: there is none. */
    private fun next(): Char? {
        while (text.getOrNull(at)?.isWhitespace() == true) at++
        return text.getOrNull(at)
    }

    private fun unreadable(expected: String): IllegalArgumentException {
        val before = text.take(at)
        val line = before.count { it == '\n' } + 1
        val column = before.substringAfterLast('\n').length + 1
        return IllegalArgumentException("these are no events in JSON: line $line, column $column: expected $expected")
    }

    private companion object {
        const val HEX = 16
        const val HEX_DIGITS = 4
    }
}

/** Writes [text] as a text of JSON, in quotes. */
internal fun jsonText(text: String): String = text.map { char ->
    when {
        char == '"' || char == '\\' -> "\\$char"
        char < ' ' -> "\\u%04x".format(char.code)
        else -> "$char"
    }
}.joinToString("", "\"", "\"")
