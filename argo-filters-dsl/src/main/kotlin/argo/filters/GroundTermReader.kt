package argo.filters

/**
 * Reads one ground term in the text from [start] to [end], with the result of Jason's parser. Returns null for any other text, such as a
 * variable, an expression or a plan. Also returns null for terms nested deeper than [MAX_DEPTH]. Never throws.
 */
internal class GroundTermReader(text: CharSequence, start: Int, end: Int) : TermCursor(text, start, end) {

    /** Returns the term. Returns null if other text follows the term. */
    fun readWhole(): GroundTerm? = term(0)?.takeIf { blanks() == end }

    private fun term(depth: Int): GroundTerm? {
        if (depth > MAX_DEPTH || blanks() >= end) return null
        return when (text[at]) {
            '"' -> quoted()?.let(GroundTerm::Text)
            '[' -> list(depth)?.let(GroundTerm::Sequence)
            '(' -> parenthesised(depth)
            '+', '-' -> signed(depth)
            in '0'..'9', '.' -> number()
            else -> structure(depth)
        }
    }

    private fun parenthesised(depth: Int): GroundTerm? {
        at++
        return term(depth + 1)?.takeIf { take(')') }
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

    private fun number(): GroundTerm? = double()?.let(GroundTerm::Number)

    private fun list(depth: Int): List<GroundTerm>? {
        at++
        if (take(']')) return emptyList()
        val items = items { term(depth + 1) } ?: return null
        if (take('|')) {
            if (depth >= MAX_DEPTH || !isNext('[')) return null
            items += list(depth + 1) ?: return null
        }
        return items.takeIf { take(']') }
    }

    private fun structure(depth: Int): GroundTerm? {
        val predicate = predicate() ?: return null
        if (predicate.functor in Syntax.TRUTH_VALUES) return GroundTerm.Structure(predicate)
        val arguments = if (take('(')) items { term(depth + 1) }?.takeIf { take(')') } ?: return null else emptyList()
        val annotations = if (isNext('[')) list(depth) ?: return null else emptyList()
        return GroundTerm.Structure(predicate, arguments, annotations.toSet())
    }

    private fun predicate(): Predicate? {
        val head = HeadScanner(text, at, end)
        if (head.functorEnd < 0 || Syntax.isDotted(text, head.functorStart, head.functorEnd)) return null
        at = head.functorEnd
        return head.predicate()
    }

    override fun blanks(): Int = Syntax.skipBlanks(text, at, end).also { at = it }

    companion object {
        /** Boards do not nest terms deeper. The limit protects the stack from hostile text. */
        const val MAX_DEPTH = 64
    }
}
