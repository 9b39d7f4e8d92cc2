package argo.filters

/** Finds namespace, negation and functor of a literal in a region of text. Never throws, whatever the text. */
internal class FunctorScanner(private val text: CharSequence, private val start: Int, private val end: Int) {
    private var namespaceStart = start
    private var namespaceEnd = start

    /** Whether `~` stands before the functor. */
    var negated = false
        private set
    var functorStart = start
        private set
    var functorEnd = start
        private set

    /** The namespace's name, the default one where none is written. */
    val namespace: String
        get() = Predicate.namespaceOf(text.substring(namespaceStart, namespaceEnd))

    fun scan(): Boolean {
        var i = Syntax.skipBlanks(text, start, end)
        val word = Syntax.atomEnd(text, i, end)
        val afterWord = Syntax.skipBlanks(text, if (word < 0) i else word, end)
        if (isNamespaceSeparator(afterWord)) {
            namespaceStart = i
            namespaceEnd = if (word < 0) i else word
            i = Syntax.skipBlanks(text, afterWord + 2, end)
        }
        if (i < end && text[i] == '~') {
            negated = true
            i = Syntax.skipBlanks(text, i + 1, end)
        }
        functorStart = i
        functorEnd = Syntax.atomEnd(text, i, end)
        return functorEnd >= 0 && isWritable()
    }

    fun predicate(): Predicate = Predicate(text.substring(functorStart, functorEnd), negated, namespace)

    /** Truth values cannot be negated and belong to no namespace. */
    private fun isWritable(): Boolean {
        if (Syntax.isTruthValue(text, namespaceStart, namespaceEnd)) return false
        val bare = !negated && namespaceEnd == namespaceStart
        return bare || !Syntax.isTruthValue(text, functorStart, functorEnd)
    }

    private fun isNamespaceSeparator(i: Int) = i + 1 < end && text[i] == ':' && text[i + 1] == ':'
}
