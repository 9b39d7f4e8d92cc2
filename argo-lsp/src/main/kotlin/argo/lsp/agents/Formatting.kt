package argo.lsp.agents

import argo.check.syntax.Component
import argo.check.syntax.Directive
import argo.check.syntax.Plan
import argo.check.syntax.Program
import argo.check.syntax.Span
import argo.check.syntax.Token
import argo.check.syntax.TokenKind
import argo.check.syntax.Unread
import argo.check.syntax.programOf

/**
 * Returns the blanks of [program] that formatting changes. It changes blanks at the ends of lines, at the beginnings of lines, and beside
 * brackets, commas and operators. Formatting neither joins nor splits lines. Several blanks in a row stay, since they may align a column.
 * Components with an error stay unchanged.
 */
internal fun formattingOf(program: Program): List<Blanks> {
    val changes = Formatting(program).changes()
    val result = StringBuilder(program.text)
    changes.asReversed().forEach { result.replace(it.span.start, it.span.end, it.text) }
    return changes.takeIf { programOf("$result").tokens.map(Token::text) == program.tokens.map(Token::text) }.orEmpty()
}

/** A change of blanks: [text] replaces the blanks at [span]. */
internal class Blanks(val span: Span, val text: String)

internal class Formatting(private val program: Program) {
    private val text = program.text
    private val tokens = program.tokens

    /** The nesting depth of each component, by the offset of its beginning. */
    private val beginnings = HashMap<Int, Int>()
    private val unreadable = ArrayList<Span>()

    /** The line of each open bracket, counted from 0 through the program. */
    private val open = ArrayList<Int>()
    private var line = 0
    private var nesting = 0

    /** True after a `<-` that begins a line. Each statement is then on its own line. */
    private var isBelowArrow = false

    init {
        program.components.forEach { enter(it, 0) }
    }

    private fun enter(component: Component, depth: Int) {
        beginnings[component.span.start] = depth
        if (component is Unread || program.errors.any { component.span.touches(it.span.start) }) unreadable += component.span
        if (component is Directive) component.components.orEmpty().forEach { enter(it, depth + 1) }
        if (component is Plan) component.plans.forEach { enter(it, depth + 1) }
    }

    fun changes(): List<Blanks> {
        val changes = ArrayList<Blanks>()
        var end = 0
        tokens.forEachIndexed { at, token ->
            val gap = Span(end, token.span.start)
            val written = text.substring(gap.start, gap.end)
            val isFirst = at == 0 || '\n' in written || '\r' in written
            if (isFirst) line++
            val better = if (isFirst) lineBreak(written, at) else between(tokens[at - 1], token, written)
            follow(token, isFirst)
            if (better != written && unreadable.none { gap.start < it.end && it.start <= gap.end }) changes += Blanks(gap, better)
            end = token.span.end
        }
        val last = text.substring(end)
        if (tokens.isNotEmpty() && unreadable.isEmpty()) changes += Blanks(Span(end, text.length), BREAK.find(last)?.value ?: "\n")
        return changes.filter { text.substring(it.span.start, it.span.end) != it.text }
    }

    /** Returns the line breaks between two tokens, without blanks before the breaks, and the indentation of the [second][at] token. */
    private fun lineBreak(written: String, at: Int): String {
        val breaks = BREAK.findAll(written).joinToString("") { it.value }
        val token = tokens[at]
        if (token.kind == TokenKind.COMMENT && '\n' in token.text) return breaks + written.takeLastWhile { it == ' ' || it == '\t' }
        return breaks + " ".repeat(indentation(at))
    }

    private fun indentation(at: Int): Int {
        val next = tokens.subList(at, tokens.size).firstOrNull { it.kind != TokenKind.COMMENT } ?: return 0
        beginnings[next.span.start]?.let { return INDENT * it }
        val openLines = (if (tokens[at].isClosing) open.dropLast(1) else open).distinct().size
        val isArrow = tokens[at].isSymbol("<-")
        return INDENT * (nesting + 1 + openLines) + if (isBelowArrow && !isArrow) ARROW else 0
    }

    private fun follow(token: Token, isFirst: Boolean) {
        beginnings[token.span.start]?.let {
            nesting = it
            open.clear()
            isBelowArrow = false
        }
        if (token.isSymbol("<-") && open.isEmpty()) isBelowArrow = isFirst
        if (token.isOpening) open += line
        if (token.isClosing) open.removeLastOrNull()
    }

    private fun between(left: Token, right: Token, written: String): String {
        val isTight = left.text in TIGHT_BEHIND && left.kind == TokenKind.SYMBOL ||
            right.text in TIGHT_BEFORE && right.kind == TokenKind.SYMBOL
        return when {
            right.kind == TokenKind.COMMENT || left.kind == TokenKind.COMMENT -> written.ifEmpty { " " }
            isTight -> ""
            left.isSymbol(",") || left.isSymbol(";") || isSpaced(left) || isSpaced(right) -> written.ifEmpty { " " }
            else -> written
        }
    }

    private fun isSpaced(token: Token) = token.kind == TokenKind.SYMBOL && token.text in SPACED

    private companion object {
        const val INDENT = 4

        /** The width of `<- `. */
        const val ARROW = 3
        val BREAK = Regex("\r\n|\n|\r")
        val TIGHT_BEHIND = setOf("(", "[")
        val TIGHT_BEFORE = setOf(")", "]", ",", ";")
        val SPACED = setOf("<-", ":-", ":", "<:", "&", ">", "<", ">=", "<=", "==", "\\==", "=", "=..")
    }
}
