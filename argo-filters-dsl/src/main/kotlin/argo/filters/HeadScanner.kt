package argo.filters

/** Finds namespace, negation and functor of the literal that begins in [text] at [start]. Never throws. */
internal class HeadScanner(private val text: CharSequence, start: Int, end: Int) {
    private val first = Syntax.skipBlanks(text, start, end)
    private val firstEnd = maxOf(first, Syntax.atomEnd(text, first, end))
    private val separator = Syntax.skipBlanks(text, firstEnd, end)
    private val hasSeparator = separator + 1 < end && text[separator] == ':' && text[separator + 1] == ':'
    private val namespaceEnd = if (hasSeparator) firstEnd else first
    private val literal = if (hasSeparator) Syntax.skipBlanks(text, separator + 2, end) else first

    val negated: Boolean = literal < end && text[literal] == '~'

    val functorStart: Int = if (negated) Syntax.skipBlanks(text, literal + 1, end) else literal

    /** The index behind the functor; negative if no literal begins here. */
    val functorEnd: Int = Syntax.atomEnd(text, functorStart, end).let { if (it >= 0 && isWritable(it)) it else -1 }

    /** The namespace; the default one if the text names none. */
    val namespace: String
        get() = if (namespaceEnd == first) Predicate.DEFAULT_NAMESPACE else Predicate.namespaceOf(text.substring(first, namespaceEnd))

    fun predicate(): Predicate = Predicate(text.substring(functorStart, functorEnd), negated, namespace)

    /** Truth values cannot be negated and belong to no namespace. */
    private fun isWritable(functorEnd: Int) = !Syntax.isTruthValue(text, first, namespaceEnd) &&
        (!negated && namespaceEnd == first || !Syntax.isTruthValue(text, functorStart, functorEnd))
}
