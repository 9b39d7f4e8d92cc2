package argo.tools.migration

/**
 * A piece of AgentSpeak or of a project file.
 *
 * @property text the token as in the file; a string with its quotes
 * @property line counted from 1
 * @property start the token's offset in the file, in characters
 */
internal data class Token(val kind: Kind, val text: String, val line: Int, val start: Int) {
    enum class Kind { WORD, NUMBER, STRING, SYMBOL }

    val end: Int get() = start + text.length

    fun isSymbol(symbol: Char) = kind == Kind.SYMBOL && text[0] == symbol

    val isVariable: Boolean get() = kind == Kind.WORD && (text[0].isUpperCase() || text[0] == '_')
}

/**
 * Returns the tokens of [text] without its comments. Tolerant: unknown characters are symbols, an open string ends with its line, an open
 * comment with the text.
 */
internal fun tokensOf(text: String): List<Token> {
    val tokens = ArrayList<Token>()
    var line = 1
    for (match in TOKEN.findAll(text)) {
        val kind = KINDS.firstOrNull { match.groups[it.first] != null }?.second
        if (kind != null) tokens += Token(kind, match.value, line, match.range.first)
        line += match.value.count { it == '\n' }
    }
    return tokens
}

private val KINDS = Token.Kind.entries.map { it.name.lowercase() to it }
private val TOKEN = Regex(
    """//[^\n]*|/\*(?:(?!\*/)[\s\S])*+(?:\*/)?|(?<string>"(?:\\.|[^"\\\n])*+"?|'(?:\\.|[^'\\\n])*+'?)""" +
        """|(?<word>[\p{L}_][\p{L}\p{N}_]*)|(?<number>\d+(?:\.\d+)?(?:[eE][+-]?\d+)?)|\s+|(?<symbol>[\s\S])""",
)

/**
 * A name with arguments: `.argo.port(P,[baud(9600)])`, `port(P,on)`.
 *
 * @property name the name with all its dots: `.argo.port`
 * @property line the first line of the call, counted from 1
 * @property arguments the tokens of each
 */
internal data class Call(val name: String, val line: Int, val arguments: List<List<Token>>)

/** Returns all calls in [tokens], including calls in arguments of other calls. */
internal fun callsIn(tokens: List<Token>): List<Call> = tokens.indices.mapNotNull { open ->
    if (!tokens[open].isSymbol('(')) return@mapNotNull null
    val first = nameStart(tokens, open)
    if (first == open) null
    else Call(tokens.subList(first, open).joinToString("") { it.text }, tokens[first].line, arguments(tokens, open))
}

/** Returns the index of the first token of the name in front of [open]: words and dots without blanks between them. */
private fun nameStart(tokens: List<Token>, open: Int): Int {
    var first = open
    while (first > 0) {
        val token = tokens[first - 1]
        val adjacent = first == open || token.end == tokens[first].start
        val expected = if (first == open || tokens[first].isSymbol('.')) token.kind == Token.Kind.WORD else token.isSymbol('.')
        if (!adjacent || !expected) break
        first--
    }
    return first
}

private fun arguments(tokens: List<Token>, open: Int): List<List<Token>> {
    val arguments = arrayListOf(ArrayList<Token>())
    var depth = 0
    for (token in tokens.subList(open + 1, tokens.size)) {
        val symbol = token.text.singleOrNull().takeIf { token.kind == Token.Kind.SYMBOL }
        if (depth == 0 && symbol == ')') break
        if (symbol != null && symbol in "([{") depth++
        if (symbol != null && symbol in ")]}") depth--
        if (depth == 0 && symbol == ',') arguments += ArrayList<Token>() else arguments.last() += token
    }
    return if (arguments.size == 1 && arguments[0].isEmpty()) emptyList() else arguments
}

/** Returns the first bracket that closes none or another kind; else the last bracket that is never closed; null: all are balanced. */
internal fun wrongBracketIn(tokens: List<Token>): Token? {
    val open = ArrayDeque<Token>()
    for (token in tokens.filter { it.kind == Token.Kind.SYMBOL }) {
        if (token.text in CLOSED_BY) open.addLast(token)
        if (token.text in CLOSED_BY.values && (open.isEmpty() || CLOSED_BY[open.removeLast().text] != token.text)) return token
    }
    return open.lastOrNull()
}

/** Returns the first token of the last belief, goal, plan or directive in [tokens], which are not empty. */
internal fun lastStatementIn(tokens: List<Token>): Token {
    var depth = 0
    var first = tokens.first()
    tokens.zipWithNext { token, next ->
        if (token.isSymbol('{')) depth++
        if (token.isSymbol('}')) depth--
        val ends = token.isSymbol('.') && next.start > token.end || token.isSymbol('}') && first.isSymbol('{')
        if (depth == 0 && ends) first = next
    }
    return first
}

private val CLOSED_BY = mapOf("(" to ")", "[" to "]", "{" to "}")
