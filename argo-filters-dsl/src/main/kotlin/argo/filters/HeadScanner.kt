package argo.filters

/** Finds the namespace, the negation and the functor of the literal at [start] in [text]. Never throws. */
internal class HeadScanner(private val text: CharSequence, start: Int, end: Int) {
    private val first = Syntax.skipBlanks(text, start, end)
    private val firstEnd = maxOf(first, Syntax.atomEnd(text, first, end))
    private val separator = Syntax.skipBlanks(text, firstEnd, end)
    private val hasSeparator = separator + 1 < end && text[separator] == ':' && text[separator + 1] == ':'
    private val namespaceEnd = if (hasSeparator) firstEnd else first
    private val literal = if (hasSeparator) Syntax.skipBlanks(text, separator + 2, end) else first

    val negated: Boolean = literal < end && text[literal] == '~'

    val functorStart: Int = if (negated) Syntax.skipBlanks(text, literal + 1, end) else literal

    /** The index after the functor. Negative if no literal begins at the start. */
    val functorEnd: Int = Syntax.atomEnd(text, functorStart, end).let { if (it >= 0 && isWritable(it)) it else -1 }

    /** The namespace, or the default namespace if the text names none. */
    val namespace: String
        get() = if (namespaceEnd == first) Predicate.DEFAULT_NAMESPACE else Predicate.namespaceOf(text.substring(first, namespaceEnd))

    fun predicate(): Predicate = Predicate(text.substring(functorStart, functorEnd), negated, namespace)

    /** Truth values cannot be negated and belong to no namespace. */
    private fun isWritable(functorEnd: Int) = !Syntax.isTruthValue(text, first, namespaceEnd) &&
        (!negated && namespaceEnd == first || !Syntax.isTruthValue(text, functorStart, functorEnd))
}
