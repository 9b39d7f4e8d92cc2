package argo.filters

/** Finds namespace, negation and functor of the literal that begins in [text] at [start]. Never throws, whatever the text. */
internal class HeadScanner(private val text: CharSequence, start: Int, private val end: Int) {
    private var namespaceStart = start
    private var namespaceEnd = start

    /** Whether `~` stands before the functor. */
    var negated = false
        private set
    var functorStart = start
        private set

    /** The character after the functor; negative if no literal begins here. */
    var functorEnd: Int
        private set

    init {
        functorStart = Syntax.skipBlanks(text, start, end)
        functorEnd = Syntax.atomEnd(text, functorStart, end)
        val next = Syntax.skipBlanks(text, maxOf(functorStart, functorEnd), end)
        val hasNamespace = next + 1 < end && text[next] == ':' && text[next + 1] == ':'
        if (hasNamespace) {
            namespaceStart = functorStart
            namespaceEnd = maxOf(functorStart, functorEnd)
            functorStart = Syntax.skipBlanks(text, next + 2, end)
        }
        negated = functorStart < end && text[functorStart] == '~'
        if (negated) functorStart = Syntax.skipBlanks(text, functorStart + 1, end)
        if (negated || hasNamespace) functorEnd = Syntax.atomEnd(text, functorStart, end)
        if (functorEnd >= 0 && !isWritable()) functorEnd = NONE
    }

    /** The namespace's name, the default one where none is written. */
    val namespace: String
        get() =
            if (namespaceEnd == namespaceStart) Predicate.DEFAULT_NAMESPACE
            else Predicate.namespaceOf(text.substring(namespaceStart, namespaceEnd))

    fun predicate(): Predicate = Predicate(text.substring(functorStart, functorEnd), negated, namespace)

    /** Truth values cannot be negated and belong to no namespace. */
    private fun isWritable() = !Syntax.isTruthValue(text, namespaceStart, namespaceEnd) &&
        (!negated && namespaceEnd == namespaceStart || !Syntax.isTruthValue(text, functorStart, functorEnd))

    private companion object {
        const val NONE = -1
    }
}
