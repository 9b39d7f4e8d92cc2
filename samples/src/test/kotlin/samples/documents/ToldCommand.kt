package samples.documents

/** A command for the reader of [document], in [line]. [words] are its words without quotes and comment, as in a shell. */
class ToldCommand private constructor(val document: String, val line: Int, val text: String) {
    val words: List<String> = words(text)

    override fun toString() = "$document:$line $text"

    companion object {
        /** Returns the commands of a page in order, from blocks, sentences and tables. */
        fun of(document: Document): List<ToldCommand> =
            (document.snippets.flatMap(::fenced) + document.spans.filter { SPOKEN.matches(it.text) }.map(::spoken))
                .filter { it.words.isNotEmpty() }.sortedBy { it.line }

        private fun spoken(span: Snippet) = ToldCommand(span.document, span.line, span.text)

        /** Matches commands in sentences. */
        private val SPOKEN = Regex("""(\./\w+|java|mvn|gradle|make|cc|cd|sudo|ssh|lsusb)( .*)?""")

        private fun fenced(snippet: Snippet): List<ToldCommand> {
            val typed = when (snippet.language) {
                "sh" -> snippet.text.replace("\\\n", " ").lines()
                "console" -> snippet.text.lines().filter { it.startsWith("$ ") }.map { it.removePrefix("$ ") }
                else -> emptyList()
            }
            return typed.map { ToldCommand(snippet.document, snippet.line, it.trim()) }
        }

        private fun words(text: String): List<String> {
            val words = mutableListOf<String>()
            var word: StringBuilder? = null
            var quote: Char? = null
            for (char in text) {
                when {
                    quote == null && word == null && char == '#' -> return words
                    quote == null && char.isWhitespace() -> word = null.also { word?.let { words += "$it" } }
                    char == quote -> quote = null
                    quote == null && char in "'\"" -> { quote = char; word = word ?: StringBuilder() }
                    else -> word = (word ?: StringBuilder()).append(char)
                }
            }
            check(quote == null) { "a quote is not closed in: $text" }
            return words + listOfNotNull(word?.toString())
        }
    }
}
