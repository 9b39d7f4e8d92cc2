package argo.check.syntax

/**
 * Reads tokens one after the other. After an [error][fail], the cursor reports the end of the text until [restart]. All readers then
 * return.
 */
internal class Cursor(private val tokens: List<Token>, private val lines: Lines, private val report: (SyntaxError) -> Unit) {
    private val end = Token(TokenKind.UNKNOWN, "", lines.end)
    private var depth = 0

    var at: Int = 0
        private set

    var isLost: Boolean = false
        private set

    val current: Token get() = peek(0)

    val isAtEnd: Boolean get() = at >= tokens.size

    fun peek(ahead: Int): Token = if (isLost) end else tokens.getOrNull(at + ahead) ?: end

    /** The offset of the next token; after an error, the offset of the wrong token. */
    val start: Int get() = (tokens.getOrNull(at) ?: end).span.start

    fun since(start: Int): Span = Span(start, if (at == 0) start else maxOf(start, tokens[at - 1].span.end))

    fun next(): Token = current.also { if (!isLost && !isAtEnd) at++ }

    fun isAt(symbol: String): Boolean = current.isSymbol(symbol)

    fun take(symbol: String): Boolean = isAt(symbol).also { if (it) at++ }

    /** Moves past [symbol], or reports that it is missing. [what] names the symbol in the message. */
    fun expect(symbol: String, what: String = symbol) {
        if (!take(symbol)) expected(what)
    }

    /** Returns the result of [read] between the symbols [open] and [close]. [what] names [close] in the message. */
    inline fun <T> between(open: String, close: String, what: String, read: () -> T): T {
        expect(open)
        return read().also { expect(close, what) }
    }

    fun expected(what: String) {
        val found = tokens.getOrNull(at)
        when {
            found == null -> fail("the text ends where $what should be", lastToken())
            isFirstInLine(at) && at > 0 && what.startsWith(FULL_STOP) ->
                fail("a full stop is missing behind ${tokens[at - 1]}", tokens[at - 1].span)
            else -> fail("here should be $what, not ${found.text}", found.span)
        }
    }

    fun fail(message: String, span: Span) {
        if (!isLost) report(SyntaxError(span, message))
        isLost = true
    }

    private fun lastToken() = tokens.lastOrNull()?.span ?: end.span

    /** Returns the result of [read]. If the nesting is too deep for the stack, calls [tooDeep] instead of [read]. */
    inline fun <T> nested(tooDeep: (Span) -> T, read: () -> T): T {
        if (depth >= MAX_DEPTH) {
            fail("this is nested more than $MAX_DEPTH deep", current.span)
            return tooDeep(Span(start, start))
        }
        depth++
        return read().also { depth-- }
    }

    /**
     * Moves to the probable start of the next component: behind a full stop, or to a line that begins like a component. Looks for such a
     * line from the token [from] on, which is before the error. Tokens are therefore read at most twice.
     */
    fun restart(from: Int) {
        isLost = false
        if (at == from && !isAtEnd) at++
        val before = (at downTo from + 1).firstOrNull { it < tokens.size && isBeginning(it) }
        if (before != null) {
            at = before
            return
        }
        while (at < tokens.size && !isBeginning(at)) if (tokens[at++].isSymbol(".")) return
    }

    private fun isBeginning(index: Int): Boolean {
        val token = tokens[index]
        val follower = tokens.getOrNull(index + 1)
        return when {
            !isFirstInLine(index) -> false
            token.text == "@" || token.text == "{" && (follower?.text == "begin" || follower?.text == "include") -> true
            token.text == "+" || token.text == "-" -> follower?.text == "!" || follower?.text == "?" || isAtMargin(index)
            else -> isAtMargin(index) && (token.text == "!" || token.kind == TokenKind.ATOM)
        }
    }

    private fun isFirstInLine(index: Int) = index == 0 || lineOf(index) > lineOf(index - 1)

    private fun isAtMargin(index: Int) = lines.position(tokens[index].span.start).column == 1

    private fun lineOf(index: Int) = lines.position(tokens[index].span.start).line

    companion object {
        const val MAX_DEPTH = 100
        const val FULL_STOP = "a full stop"
    }
}
