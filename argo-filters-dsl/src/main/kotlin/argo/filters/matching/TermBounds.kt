package argo.filters.matching

import argo.filters.Syntax

/**
 * Finds where terms begin and end in a percept's text. Understands quotes, brackets and comments. Text nested deeper than [MAX_DEPTH] is
 * no percept. The functions build no terms, allocate nothing and never throw.
 */
internal object TermBounds {
    const val NONE = -1

    /** The result of [tail] if there is no percept. */
    const val NO_TAIL = -1L
    private const val MAX_DEPTH = 256

    /** Returns the end of the functor at [start] if it is an unreserved word, followed by arguments or nothing. Else returns [NONE]. */
    fun plainFunctorEnd(text: CharSequence, start: Int, end: Int): Int {
        if (start >= end || text[start] !in 'a'..'z') return NONE
        val wordEnd = Syntax.wordEnd(text, start, end)
        val isPlain = (wordEnd == end || text[wordEnd] == '(') && !Syntax.isReserved(text, start, wordEnd)
        return if (isPlain) wordEnd else NONE
    }

    /** Returns [tail] for the functor from [start] to [functorEnd], which may be [NONE]. A truth value must have an empty tail. */
    fun tailOf(text: CharSequence, start: Int, functorEnd: Int, end: Int): Long {
        if (functorEnd < 0) return NO_TAIL
        val tail = tail(text, functorEnd, end)
        return if (tail == end.toLong() || !Syntax.isTruthValue(text, start, functorEnd)) tail else NO_TAIL
    }

    /**
     * Returns the arity and the start of the annotations after a functor that ends at [functorEnd]. [arity] and [annotations] unpack the
     * result. Returns [NO_TAIL] if the text up to [end] is no percept.
     */
    fun tail(text: CharSequence, functorEnd: Int, end: Int): Long {
        var arity = 0
        var i = Syntax.skipBlanks(text, functorEnd, end)
        if (i < end && text[i] == '(') {
            do {
                i = partEnd(text, Syntax.skipBlanks(text, i + 1, end), end, ')')
                if (i < 0) return NO_TAIL
                arity++
            } while (text[i] == ',')
            i = Syntax.skipBlanks(text, i + 1, end)
        }
        val annotations = i
        if (i < end && text[i] == '[') i = annotationsEnd(text, i, end)
        return if (i == end) arity.toLong() shl Int.SIZE_BITS or annotations.toLong() else NO_TAIL
    }

    fun arity(tail: Long): Int = (tail shr Int.SIZE_BITS).toInt()

    /** Returns the index of the bracket that opens the annotations, or the end of the text. */
    fun annotations(tail: Long): Int = tail.toInt()

    /** Returns the start of the argument at [index], without blanks. The functor ends at [functorEnd]. The argument must exist. */
    fun argument(text: CharSequence, functorEnd: Int, end: Int, index: Int): Int {
        var start = Syntax.skipBlanks(text, Syntax.skipBlanks(text, functorEnd, end) + 1, end)
        repeat(index) { start = Syntax.skipBlanks(text, partEnd(text, start, end, ')') + 1, end) }
        return start
    }

    /** Returns the index of the comma or [close] that ends the part at [start]. Returns [NONE] if there is none or if the part is empty. */
    fun partEnd(text: CharSequence, start: Int, end: Int, close: Char): Int {
        var i = start
        while (i in 0 until end) {
            val c = text[i]
            if (c == ',' || c == close) return if (i > start) i else NONE
            i = next(text, i, end, 0)
        }
        return NONE
    }

    private fun annotationsEnd(text: CharSequence, open: Int, end: Int): Int {
        val first = Syntax.skipBlanks(text, open + 1, end)
        var i = if (first < end && text[first] == ']') first else open
        while (text[i] != ']') {
            i = partEnd(text, Syntax.skipBlanks(text, i + 1, end), end, ']')
            if (i < 0) return NONE
        }
        return Syntax.skipBlanks(text, i + 1, end)
    }

    /** Returns the position after the character, string, comment or bracketed group at [i], or [NONE]. */
    private fun next(text: CharSequence, i: Int, end: Int, depth: Int): Int = when (text[i]) {
        '(' -> groupEnd(text, i + 1, end, ')', depth + 1)
        '[' -> groupEnd(text, i + 1, end, ']', depth + 1)
        '{' -> groupEnd(text, i + 1, end, '}', depth + 1)
        ')', ']', '}' -> NONE
        '"' -> Syntax.stringEnd(text, i, end)
        '\'' -> Syntax.quotedAtomEnd(text, i, end)
        '/' -> maxOf(Syntax.commentEnd(text, i, end), i + 1)
        else -> i + 1
    }

    private fun groupEnd(text: CharSequence, start: Int, end: Int, close: Char, depth: Int): Int {
        if (depth > MAX_DEPTH) return NONE
        var i = start
        while (i in 0 until end) {
            if (text[i] == close) return i + 1
            i = next(text, i, end, depth)
        }
        return NONE
    }
}
