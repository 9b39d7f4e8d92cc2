package argo.filters

/**
 * Finds the parts of a percept in its text without building terms: functor, arguments, annotations.
 *
 * Quotes, brackets and comments are respected. Text that is not a literal's outline (unbalanced brackets, an open string, something after
 * the end, nesting beyond [MAX_DEPTH]) makes [scan] false. Never throws, whatever the text.
 */
internal class PerceptScanner(private val text: CharSequence) {
    private val head = FunctorScanner(text, 0, text.length)
    private var brackets = ByteArray(MAX_DEPTH)

    /** Start and end of each argument, one after the other. */
    val arguments = Bounds()

    /** Start and end of each annotation, one after the other. */
    val annotations = Bounds()

    /** The percept's functor, negation and namespace; valid after a successful [scan]. */
    fun predicate(): Predicate = head.predicate()

    fun scan(): Boolean {
        if (!head.scan()) return false
        var i = blanks(head.functorEnd)
        if (i < text.length && text[i] == '(') i = group(i, ')', arguments)
        if (i in 0 until text.length && text[i] == '[') i = group(i, ']', annotations)
        return i == text.length && isWritable()
    }

    private fun isWritable() =
        arguments.size == 0 && annotations.size == 0 || !Syntax.isTruthValue(text, head.functorStart, head.functorEnd)

    /** Collects the parts between the bracket at [open] and its [close]; the position after it and blanks, or -1. */
    private fun group(open: Int, close: Char, parts: Bounds): Int {
        var start = blanks(open + 1)
        if (close == ']' && start < text.length && text[start] == close) return blanks(start + 1)
        while (true) {
            val end = partEnd(start, close)
            if (end <= start) return -1
            parts.add(start, end)
            if (text[end] == close) return blanks(end + 1)
            start = blanks(end + 1)
        }
    }

    /** The position of the comma or [close] that ends the part from [start], or -1. */
    private fun partEnd(start: Int, close: Char): Int {
        var depth = 0
        var i = start
        while (i < text.length) {
            val c = text[i]
            if (depth == 0 && (c == ',' || c == close)) return i
            when (c) {
                '(', '[', '{' -> {
                    if (depth == MAX_DEPTH) return -1
                    brackets[depth++] = c.code.toByte()
                    i++
                }
                ')', ']', '}' -> {
                    if (depth == 0 || !closes(brackets[--depth], c)) return -1
                    i++
                }
                '"' -> i = Syntax.stringEnd(text, i, text.length)
                '\'' -> i = Syntax.atomEnd(text, i, text.length)
                '/' -> i = maxOf(Syntax.commentEnd(text, i, text.length), i + 1)
                else -> i++
            }
            if (i < 0) return -1
        }
        return -1
    }

    private fun closes(open: Byte, close: Char) = when (open.toInt().toChar()) {
        '(' -> close == ')'
        '[' -> close == ']'
        else -> close == '}'
    }

    private fun blanks(from: Int) = Syntax.skipBlanks(text, from, text.length)

    /** A growing list of regions of the text. */
    class Bounds {
        private var positions = IntArray(8)

        var size = 0
            private set

        fun add(start: Int, end: Int) {
            if (2 * size + 2 > positions.size) positions = positions.copyOf(2 * positions.size)
            positions[2 * size] = start
            positions[2 * size + 1] = end
            size++
        }

        fun start(index: Int): Int = positions[2 * index]

        fun end(index: Int): Int = positions[2 * index + 1]
    }

    private companion object {
        const val MAX_DEPTH = 256
    }
}
