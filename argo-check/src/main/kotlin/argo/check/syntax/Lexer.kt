package argo.check.syntax

/**
 * Reads the tokens of [text] as Jason's parser does: each token is as long as possible. Calls [report] for errors. Each non-blank character
 * belongs to one token.
 */
internal class Lexer(private val text: String, private val report: (SyntaxError) -> Unit) {
    private var at = 0
    private var start = 0

    fun tokens(): List<Token> = buildList {
        while (skipBlanks()) {
            start = at
            val kind = next()
            add(Token(kind, text.substring(start, at), Span(start, at)))
        }
    }

    private fun skipBlanks(): Boolean {
        while (at < text.length && text[at] in BLANKS) at++
        return at < text.length
    }

    private fun peek(ahead: Int = 0): Char = text.getOrElse(at + ahead) { '\u0000' }

    private fun next(): TokenKind = when {
        text.startsWith("//", at) -> lineComment()
        text.startsWith("/*", at) -> blockComment()
        peek() == '"' -> string()
        peek() == '\'' -> quotedAtom()
        isNumberHere() -> number()
        peek().isLetter() || peek() == '_' || peek() == '.' && isNamePart(peek(1)) -> name()
        else -> symbol()
    }

    private fun lineComment(): TokenKind {
        while (at < text.length && text[at] !in "\n\r") at++
        return TokenKind.COMMENT
    }

    private fun blockComment(): TokenKind {
        val end = text.indexOf("*/", at + 2)
        if (end < 0) refuse("this comment has no end", at, at + 2)
        at = if (end < 0) text.length else end + 2
        return TokenKind.COMMENT
    }

    private fun string(): TokenKind {
        at++
        while (at < text.length && text[at] !in "\"\n\r") {
            if (peek() == '\\') escape()
            at++
        }
        if (peek() == '"') at++ else refuse("this string has no end; it ends in the line in which it begins")
        return TokenKind.STRING
    }

    private fun escape() {
        if (peek(1) !in ESCAPED) refuse("Jason knows no \\${peek(1).takeUnless(Char::isISOControl) ?: ""} in a string", at, at + 1)
        if (peek(1) != '\u0000' && peek(1) !in "\n\r") at++
    }

    private fun quotedAtom(): TokenKind {
        val end = text.indexOf('\'', at + 1)
        if (end < 0) refuse("this name in quotes has no end", at, at + 1)
        if (end < 0) lineComment() else at = end + 1
        return TokenKind.ATOM
    }

    /** Returns true if a number begins here. Jason reads `.5a` and `.5.5` as names, since the name is longer. */
    private fun isNumberHere(): Boolean {
        if (peek() in DIGITS) return true
        if (peek() != '.' || peek(1) !in DIGITS) return false
        nameParts()
        val nameEnd = at
        at = start
        number()
        return (at >= nameEnd).also { at = start }
    }

    private fun number(): TokenKind {
        digits()
        if (peek() == '.' && peek(1) in DIGITS) {
            at++
            digits()
        }
        val signed = if (peek(1) in "+-") 2 else 1
        if (peek() in "eE" && peek(signed) in DIGITS) {
            at += signed
            digits()
        }
        return TokenKind.NUMBER
    }

    private fun digits() {
        while (peek() in DIGITS) at++
    }

    private fun name(): TokenKind {
        val isVariable = peek() in 'A'..'Z' || peek() == '_'
        if (isVariable) variableParts() else nameParts()
        val word = text.substring(start, at)
        val foreign = word.firstOrNull { it > '\u007f' }
        if (foreign != null) refuse("the name $word has the letter $foreign; Jason reads only a to z, digits and _ in names")
        return when {
            isVariable -> TokenKind.VARIABLE
            word in KEYWORDS -> TokenKind.KEYWORD
            else -> TokenKind.ATOM
        }
    }

    private fun variableParts() {
        while (isNamePart(peek())) at++
    }

    private fun nameParts() {
        do at++ while (isNamePart(peek()) || peek() == '.' && isNamePart(peek(1)))
    }

    private fun symbol(): TokenKind {
        val found = SYMBOLS.firstOrNull { text.startsWith(it, at) }
        at += found?.length ?: Character.charCount(text.codePointAt(at))
        if (found != null) return TokenKind.SYMBOL
        val written = text.substring(start, at)
        val code = "U+%04X".format(written.codePointAt(0))
        refuse("Jason reads no ${if (written[0] in '!'..'~') written else "character $code"} here")
        return TokenKind.UNKNOWN
    }

    private fun refuse(message: String, from: Int = start, to: Int = at) = report(SyntaxError(Span(from, to), message))

    private companion object {
        const val BLANKS = " \t\n\r"
        const val DIGITS = "0123456789"
        const val ESCAPED = "ntbrf\\'\"01234567"
        val KEYWORDS = setOf("true", "false", "not", "div", "mod", "begin", "end", "if", "else", "elif", "for", "while")

        /** Longer symbols precede their own beginnings. */
        val SYMBOLS = listOf(
            "|&|", "|||", "\\==", "=..", "<-", "<:", "<=", ":-", "::", ">=", "==", "**", "!!", "<", ">", "=", ":", "*", "/", "+", "-", "!",
            "?", "^", "~", "@", "&", "|", "{", "}", "[", "]", "(", ")", ",", ";", ".",
        )

        /** Non-ASCII letters count as parts of a name. Each name then causes at most one error. */
        fun isNamePart(character: Char): Boolean = character == '_' || character in DIGITS || character.isLetter()
    }
}
