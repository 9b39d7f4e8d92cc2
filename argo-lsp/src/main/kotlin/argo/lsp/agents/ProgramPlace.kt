package argo.lsp.agents

import argo.check.syntax.Program
import argo.check.syntax.Span
import argo.check.syntax.Token
import argo.check.syntax.TokenKind

/** A call around a place, which is not closed yet. [argument] is the index of the argument at the place, counted from 0. */
internal data class OpenCall(val name: String, val argument: Int, val isInList: Boolean)

/** The kinds of places in a program. Each kind expects other words. */
internal enum class Region {
    /** Between components. */
    TOP,

    HEAD,

    CONTEXT,

    BODY,
}

/** The place of a cursor in [program]. The program may be incomplete there. */
internal class ProgramPlace(private val program: Program, private val offset: Int) {
    private val touched = program.tokens.lastOrNull { it.span.start < offset && it.span.end >= offset }

    /** True if the cursor is in a comment or a string. */
    val isAside: Boolean = touched?.let { it.kind == TokenKind.COMMENT || it.kind == TokenKind.STRING } == true

    /** The word up to the cursor, including dots, such as `argo.ac`; empty if there is no word. */
    val word: Span = Span(beginningOfWord(), offset)

    val text: String get() = program.text.substring(word.start, word.end)

    /** The tokens before [word] in its belief, rule, goal or plan. */
    private val before: List<Token> = program.tokens.filter { it.span.end <= word.start && it.kind != TokenKind.COMMENT }
        .let { tokens -> tokens.subList(tokens.indexOfLast { it.isSymbol(".") } + 1, tokens.size) }

    /** The symbols before [word], such as `+!`. Blanks may follow them. */
    val prefix: String = before.takeLastWhile { it.kind == TokenKind.SYMBOL && it.text in PREFIXES }.joinToString("") { it.text }

    val region: Region = when {
        hasOutside("<-") -> Region.BODY
        hasOutside(":") || hasOutside(":-") -> Region.CONTEXT
        before.isNotEmpty() -> Region.HEAD
        else -> Region.TOP
    }

    /** The calls around the cursor, the innermost first. */
    val calls: List<OpenCall> = openCalls()

    private fun beginningOfWord(): Int {
        val text = program.text
        var begin = offset
        while (begin > 0 && (text[begin - 1].isLetterOrDigit() || text[begin - 1] in "_.")) begin--
        // a number is not a word
        return if (text.substring(begin, offset).firstOrNull()?.isDigit() == true) offset else begin
    }

    private fun hasOutside(symbol: String): Boolean {
        var depth = 0
        return before.any { token ->
            if (token.isOpening) depth++
            if (token.isClosing) depth--
            depth <= 0 && token.isSymbol(symbol)
        }
    }

    private fun openCalls(): List<OpenCall> {
        val found = ArrayList<OpenCall>()
        var closed = 0
        var commas = 0
        var isInList = false
        for (at in before.indices.reversed()) {
            val token = before[at].takeIf { it.kind == TokenKind.SYMBOL } ?: continue
            when {
                token.isClosing -> closed++
                token.isOpening && closed > 0 -> closed--
                token.text == "(" -> {
                    val name = before.getOrNull(at - 1)?.takeIf { it.kind == TokenKind.ATOM }?.text.orEmpty()
                    found += OpenCall(name, commas, isInList)
                    commas = 0
                    isInList = false
                }
                token.text == "[" || token.text == "{" -> {
                    commas = 0
                    isInList = token.text == "["
                }
                token.text == "," && closed == 0 -> commas++
            }
        }
        return found
    }

    private companion object {
        val PREFIXES = setOf("!", "!!", "?", "+", "-", "^")
    }
}
