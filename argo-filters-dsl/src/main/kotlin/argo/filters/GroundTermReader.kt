package argo.filters

/**
 * Reads one ground term out of a region of text, as Jason's parser would.
 *
 * Whatever is not an atom, number, string, structure or list of such (variables, expressions, plans, malformed text) gives null,
 * and so does anything nested deeper than [MAX_DEPTH]. Never throws, whatever the text.
 */
internal class GroundTermReader(private val text: CharSequence, start: Int, private val end: Int) {
    private var at = start

    /** The term that fills the whole region, blanks around it aside. */
    fun readWhole(): GroundTerm? {
        val value = term(0) ?: return null
        return value.takeIf { blanks() == end }
    }

    private fun term(depth: Int): GroundTerm? {
        if (depth > MAX_DEPTH || blanks() >= end) return null
        return when (text[at]) {
            '"' -> string()
            '[' -> list(depth)?.let(GroundTerm::Sequence)
            '(' -> parenthesised(depth)
            '+', '-' -> signed(depth)
            in '0'..'9' -> number()
            '.' -> number()
            else -> structure(depth)
        }
    }

    private fun parenthesised(depth: Int): GroundTerm? {
        at++
        val value = term(depth + 1)
        return value.takeIf { take(')') }
    }

    private fun signed(depth: Int): GroundTerm? {
        val minus = text[at++] == '-'
        val value = when {
            blanks() >= end -> null
            text[at] == '(' -> parenthesised(depth)
            else -> number()
        } as? GroundTerm.Number ?: return null
        return if (minus) GroundTerm.Number(-value.value) else value
    }

    private fun number(): GroundTerm? {
        val numberEnd = Syntax.numberEnd(text, at, end)
        if (numberEnd < 0) return null
        val value = text.substring(at, numberEnd).toDouble()
        at = numberEnd
        return GroundTerm.Number(value)
    }

    private fun string(): GroundTerm? {
        val stringEnd = Syntax.stringEnd(text, at, end)
        if (stringEnd < 0) return null
        val value = GroundTerm.Text.unescape(text.substring(at + 1, stringEnd - 1))
        at = stringEnd
        return GroundTerm.Text(value)
    }

    private fun list(depth: Int): List<GroundTerm>? {
        at++
        val items = ArrayList<GroundTerm>()
        if (take(']')) return items
        do items += term(depth + 1) ?: return null while (take(','))
        if (take('|')) {
            if (depth >= MAX_DEPTH || blanks() >= end || text[at] != '[') return null
            items += list(depth + 1) ?: return null
        }
        return items.takeIf { take(']') }
    }

    private fun structure(depth: Int): GroundTerm? {
        val predicate = predicate() ?: return null
        if (predicate.functor in Syntax.TRUTH_VALUES) return GroundTerm.Structure(predicate)
        val arguments = if (take('(')) terms(depth, ')') ?: return null else emptyList()
        val annotations = if (blanks() < end && text[at] == '[') list(depth) ?: return null else emptyList()
        return GroundTerm.Structure(predicate, arguments, annotations.toSet())
    }

    private fun terms(depth: Int, close: Char): List<GroundTerm>? {
        val terms = ArrayList<GroundTerm>()
        do terms += term(depth + 1) ?: return null while (take(','))
        return terms.takeIf { take(close) }
    }

    private fun predicate(): Predicate? {
        val head = HeadScanner(text, at, end)
        if (head.functorEnd < 0 || Syntax.isDotted(text, head.functorStart, head.functorEnd)) return null
        at = head.functorEnd
        return head.predicate()
    }

    private fun blanks(): Int = Syntax.skipBlanks(text, at, end).also { at = it }

    private fun take(expected: Char): Boolean {
        if (blanks() >= end || text[at] != expected) return false
        at++
        return true
    }

    companion object {
        /** Deeper terms than any board sends; keeps hostile text from using up the stack. */
        const val MAX_DEPTH = 64
    }
}
