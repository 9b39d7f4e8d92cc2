package argo.filters.matching

/**
 * Splits one Javino message into its percepts, in order. A `;` outside of strings, quoted atoms and brackets separates percepts. Trims
 * percepts and leaves out empty ones.
 *
 * A percept with unmatched brackets or quotes ends at its next `;` of any kind. The following percepts are then not lost.
 */
fun perceptsOf(message: String): List<String> {
    val percepts = ArrayList<String>()
    var start = 0
    while (start < message.length) {
        val end = balancedEnd(message, start) ?: message.indexOf(';', start).takeIf { it >= 0 } ?: message.length
        message.substring(start, end).trim().let { if (it.isNotEmpty()) percepts += it }
        start = end + 1
    }
    return percepts
}

/** Splits [percept] at every `;`, even in strings and brackets. This is the second attempt for a percept that Jason cannot read. */
fun piecesOf(percept: String): List<String> = percept.split(';').map { it.trim() }.filter { it.isNotEmpty() }

internal fun isBalanced(text: String): Boolean = balancedEnd(text, 0) != null

/** Returns the end of the percept that begins at [start], or null if its brackets or quotes do not match. */
private fun balancedEnd(text: String, start: Int): Int? {
    val open = ArrayDeque<Char>()
    var i = start
    while (i < text.length) {
        when (val c = text[i]) {
            '"', '\'' -> i = endOfQuoted(text, i) ?: return null
            '(', '[', '{' -> open.addLast(c)
            ')', ']', '}' -> if (open.removeLastOrNull() != OPENING[c]) return null
            ';' -> if (open.isEmpty()) return i
        }
        i++
    }
    return if (open.isEmpty()) text.length else null
}

private val OPENING = mapOf(')' to '(', ']' to '[', '}' to '{')

/** Returns the index of the quote that closes the quote at [opening], or null. Only strings have escapes. */
private fun endOfQuoted(text: String, opening: Int): Int? {
    val quote = text[opening]
    var i = opening + 1
    while (i < text.length && text[i] != quote) i += if (text[i] == '\\' && quote == '"') 2 else 1
    return i.takeIf { it < text.length }
}
