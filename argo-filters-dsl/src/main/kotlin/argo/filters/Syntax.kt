package argo.filters

/** The syntax of Jason's terms, for ASCII text. */
internal object Syntax {
    const val FUNCTOR_IN_WORDS =
        "it starts with a lower-case letter and goes on with letters, digits and _, or stands in single quotes"

    val TRUTH_VALUES = setOf("true", "false")

    fun isAtom(text: String): Boolean = text.isNotEmpty() && atomEnd(text, 0, text.length) == text.length

    /** The reserved words by length. A name is compared only with words of its own length. */
    private val RESERVED = listOf("if", "not", "div", "mod", "for", "else", "elif", "while").let { words ->
        Array(words.maxOf(String::length) + 1) { length -> words.filter { it.length == length }.toTypedArray() }
    }

    /** Returns true if the word is a keyword of Jason, not an atom. */
    fun isReserved(text: CharSequence, start: Int, end: Int): Boolean =
        end - start < RESERVED.size && RESERVED[end - start].any { isAt(text, start, end, it) }

    fun isTruthValue(text: CharSequence, start: Int, end: Int): Boolean =
        isAt(text, start, end, "true") || isAt(text, start, end, "false")

    fun wordEnd(text: CharSequence, start: Int, end: Int): Int = first(text, start, end) { !isWordCharacter(it) }

    private inline fun first(text: CharSequence, start: Int, end: Int, wanted: (Char) -> Boolean): Int {
        var i = start
        while (i < end && !wanted(text[i])) i++
        return i
    }

    /** Returns the end of the atom that starts at [start], or -1. */
    fun atomEnd(text: CharSequence, start: Int, end: Int): Int {
        if (start >= end) return -1
        if (text[start] == '\'') return quotedAtomEnd(text, start, end)
        var i = when {
            text[start] in 'a'..'z' -> start + 1
            isDottedWord(text, start, end) -> start + 2
            else -> return -1
        }
        while (i < end) {
            i += when {
                isWordCharacter(text[i]) -> 1
                isDottedWord(text, i, end) -> 2
                else -> break
            }
        }
        return if (isReserved(text, start, i)) -1 else i
    }

    fun quotedAtomEnd(text: CharSequence, start: Int, end: Int): Int {
        val quote = first(text, start + 1, end) { it == '\'' }
        return if (quote < end) quote + 1 else -1
    }

    private fun isDottedWord(text: CharSequence, i: Int, end: Int) =
        text[i] == '.' && i + 1 < end && isWordCharacter(text[i + 1])

    fun isWordCharacter(c: Char): Boolean = c in 'a'..'z' || c in 'A'..'Z' || c in '0'..'9' || c == '_'

    /** Returns true if the atom contains a dot. In Jason, an atom with a dot names an internal action or an arithmetic function. */
    fun isDotted(text: CharSequence, start: Int, end: Int): Boolean =
        text[start] != '\'' && (start until end).any { text[it] == '.' }

    fun numberEnd(text: CharSequence, start: Int, end: Int): Int {
        val whole = digitsEnd(text, start, end)
        var i = whole
        if (i < end && text[i] == '.') {
            val fraction = digitsEnd(text, i + 1, end)
            if (fraction > i + 1) i = fraction
        }
        if (i == start) return -1
        return exponentEnd(text, i, end)
    }

    private fun exponentEnd(text: CharSequence, start: Int, end: Int): Int {
        if (start >= end || (text[start] != 'e' && text[start] != 'E')) return start
        val sign = start + 1
        val digits = if (sign < end && (text[sign] == '+' || text[sign] == '-')) sign + 1 else sign
        val exponent = digitsEnd(text, digits, end)
        return if (exponent > digits) exponent else start
    }

    private fun digitsEnd(text: CharSequence, start: Int, end: Int) = first(text, start, end) { it !in '0'..'9' }

    /**
     * Returns the end of the string in double quotes that starts at [start]. Returns -1 if no quote closes it or if it is no
     * [GroundTerm.Text].
     */
    fun stringEnd(text: CharSequence, start: Int, end: Int): Int {
        var i = start + 1
        while (i < end) {
            when (text[i]) {
                '"' -> return i + 1
                '\n', '\r' -> return -1
                '\\' -> {
                    if (i + 1 >= end || text[i + 1] !in ESCAPED && !StringText.isUnicode(text, i, end)) return -1
                    i += 2 // the digits after \u are skipped like letters
                }
                else -> i++
            }
        }
        return -1
    }

    private const val ESCAPED = "ntbrf\\'\"01234567"

    /** Returns the position of the first character after white space and comments. */
    fun skipBlanks(text: CharSequence, start: Int, end: Int): Int {
        var i = start
        while (i < end) {
            val c = text[i]
            i = when {
                c == ' ' || c == '\t' || c == '\n' || c == '\r' -> i + 1
                c == '/' -> commentEnd(text, i, end).also { if (it == i) return i }
                else -> return i
            }
        }
        return i
    }

    fun commentEnd(text: CharSequence, start: Int, end: Int): Int {
        if (start + 1 >= end) return start
        return when (text[start + 1]) {
            '/' -> first(text, start + 2, end) { it == '\n' || it == '\r' }
            '*' -> {
                for (i in start + 2 until end - 1) if (text[i] == '*' && text[i + 1] == '/') return i + 2
                start
            }
            else -> start
        }
    }

    fun isAt(text: CharSequence, start: Int, end: Int, word: String): Boolean {
        if (word.length != end - start) return false
        for (i in word.indices) if (text[start + i] != word[i]) return false
        return true
    }
}
