package argo.check.project

import argo.check.syntax.SyntaxError
import argo.check.syntax.Token
import argo.check.syntax.TokenKind

/**
 * Reads the syntax of a Jason project file: its head, its sections, and the end of each agent. An instance reads one file, whose end is
 * marked by the token [end].
 */
internal class MasSyntax(private val tokens: List<Token>, private val end: Token) {
    private var at = 0
    private var error: SyntaxError? = null

    private val current: Token get() = tokens.getOrElse(at) { end }

    /** Returns the first token that Jason's parser refuses in these parts, or null if there is none. */
    fun error(): SyntaxError? {
        take("MAS") { it.text == "MAS" }
        take("the name of the system, in lower case") { it.kind == TokenKind.ATOM }
        take("{")
        while (error == null && !current.isSymbol("}")) section()
        return error
    }

    private fun section() {
        val isOfAgents = current.text == AGENTS
        take("a section, as agents, or }") { it.text in SECTIONS || isOfAgents }
        take(":")
        if (isOfAgents) do agent() while (error == null && !isAtSection()) else skipTo { isAtSection() }
    }

    private fun agent() {
        take("the name of an agent, in lower case") { it.kind == TokenKind.ATOM }
        if (error == null && !isBehindSource(current) && !isAtSection()) source()
        while (error == null && !current.isSymbol(";")) part()
        take(";")
    }

    /** Reads the file name of an agent's program. Jason accepts a path only if it begins with `./` or a root. */
    private fun source() {
        var last = at
        while (tokens.getOrNull(last + 1)?.let { it.span.start == tokens[last].span.end && !isBehindSource(it) } == true) last++
        val written = tokens.subList(at, minOf(last + 1, tokens.size)).joinToString("") { it.text }
        take("a program in lower case, as bob.asl or ./src/bob.asl, or ;") { SOURCE.matches(written) }
        if (error == null) at = last + 1
    }

    private fun isBehindSource(token: Token) = token.text in BEHIND_SOURCE || token.text in WORDS

    private fun part() = when (current.text) {
        "[" -> options()
        "#" -> {
            at++
            take("a number") { it.kind == TokenKind.NUMBER }
        }
        in WORDS -> {
            at++
            take("a name") { it.kind == TokenKind.ATOM || it.kind == TokenKind.VARIABLE || it.kind == TokenKind.STRING }
            skipTo { current.span.start > tokens[at - 1].span.end || current.text in BEHIND_NAME }
            if (current.isSymbol("(")) skipBracket() else Unit
        }
        else -> take(";")
    }

    /** Reads an agent's options. Jason takes no number with a sign, and a file's name only in quotes. */
    private fun options() {
        do {
            at++ // behind the bracket or the comma
            take("the name of an option") { it.kind == TokenKind.ATOM || it.kind == TokenKind.KEYWORD }
            take("=")
            take("a name, a number without a sign, or a text in quotes") {
                it.kind == TokenKind.STRING || it.kind == TokenKind.NUMBER || WORD.matches(it.text)
            }
        } while (error == null && current.isSymbol(","))
        take("] or ,") { it.isSymbol("]") }
    }

    private fun isAtSection() = current.isSymbol("}") ||
        (current.text in SECTIONS || current.text == AGENTS) && tokens.getOrNull(at + 1)?.isSymbol(":") == true

    /** Moves behind the matching closing bracket. Brackets can be nested, since class arguments may be classes. */
    private fun skipBracket() {
        var depth = 0
        skipTo {
            if (current.isOpening) depth++
            current.isClosing && --depth == 0
        }
        take("a closing bracket") { it.isClosing }
    }

    private fun skipTo(isThere: () -> Boolean) {
        while (error == null && at < tokens.size && !isThere()) at++
    }

    private fun take(symbol: String) = take(symbol) { it.isSymbol(symbol) }

    private fun take(what: String, isIt: (Token) -> Boolean) {
        if (error != null) return
        val found = current.text.ifEmpty { "the end of the file" }
        if (isIt(current)) at++ else error = SyntaxError(current.span, "here should be $what, not $found")
    }

    companion object {
        const val AGENTS = "agents"
        val SECTIONS = setOf("classpath", "aslSourcePath", "directives", "environment", "executionControl", "infrastructure")

        /** The words that can follow an agent's source and introduce a class or a host. */
        val WORDS = setOf("agentArchClass", "agentClass", "beliefBaseClass", "at")
        private val SOURCE = Regex("(?:(?:[A-Za-z]:|\\.)?[/\\\\](?:\\S*[/\\\\])?)?[a-z]\\w*(?:\\.[a-z]\\w*)?")
        private val WORD = Regex("\\w+")
        private val BEHIND_SOURCE = setOf("[", "#", ";")
        private val BEHIND_NAME = BEHIND_SOURCE + "("
    }
}
