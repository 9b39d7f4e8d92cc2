package argo.check.syntax

/** The kinds of tokens. Jason skips comments. Jason refuses a text with an unknown token. */
enum class TokenKind { ATOM, VARIABLE, NUMBER, STRING, KEYWORD, SYMBOL, COMMENT, UNKNOWN }

/**
 * A token of AgentSpeak.
 *
 * @property text the token as written: a string includes its quotes, a comment its slashes
 */
class Token(val kind: TokenKind, val text: String, val span: Span) {
    fun isSymbol(symbol: String): Boolean = kind == TokenKind.SYMBOL && text == symbol

    fun isKeyword(word: String): Boolean = kind == TokenKind.KEYWORD && text == word

    /** True for an opening bracket or brace. */
    val isOpening: Boolean get() = kind == TokenKind.SYMBOL && text in OPENING

    /** True for a closing bracket or brace. */
    val isClosing: Boolean get() = kind == TokenKind.SYMBOL && text in CLOSING

    override fun toString(): String = text

    private companion object {
        val OPENING = setOf("(", "[", "{")
        val CLOSING = setOf(")", "]", "}")
    }
}

/**
 * A reason why Jason refuses a text.
 *
 * @property message the error, and the input that Jason expects
 */
class SyntaxError(val span: Span, val message: String) {
    override fun toString(): String = message
}
