package argo.ros.mapping

/** The mapping has an error at [place]. */
internal class Refusal(val place: Place, message: String) : Exception(message)

/** Reads the text of a rule from left to right. [start] is the place of [text] in its file. */
internal class Cursor(private val text: String, private val start: Place) {
    private var at = 0

    init {
        skipBlanks()
    }

    val place: Place get() = Place(start.line, start.column + at)

    val isAtEnd: Boolean get() = at == text.length

    val found: String get() = if (isAtEnd) "the end of the line" else "'${text.substring(at).substringBefore(' ').take(MAX_QUOTED)}'"

    /** Skips [symbol] if it is next. If [symbol] is a word, the next word must equal it. */
    fun take(symbol: String): Boolean {
        val isThere = text.startsWith(symbol, at) && !(symbol.last().isWordPart() && text.getOrNull(at + symbol.length).isWordPart())
        if (isThere) advance(symbol.length)
        return isThere
    }

    fun takeOneOf(symbols: List<String>): String? = symbols.find(::take)

    fun take(pattern: Regex): String? = pattern.matchAt(text, at)?.value?.also { advance(it.length) }

    fun expect(symbol: String, where: String) {
        if (!take(symbol)) throw refusal("expected '$symbol' $where, but found $found")
    }

    fun expect(pattern: Regex, what: String): String = take(pattern) ?: throw refusal("expected $what, but found $found")

    fun refusal(message: String) = Refusal(place, message)

    private fun advance(by: Int) {
        at += by
        skipBlanks()
    }

    private fun skipBlanks() {
        while (at < text.length && text[at] == ' ') at++
    }

    private fun Char?.isWordPart() = this != null && (isLetterOrDigit() || this == '_')

    private companion object {
        const val MAX_QUOTED = 40
    }
}
