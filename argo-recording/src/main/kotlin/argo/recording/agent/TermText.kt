package argo.recording.agent

import argo.filters.jason.PerceptReader
import argo.filters.jason.PerceptSyntaxException
import argo.filters.jason.perceptText
import jason.asSyntax.ASSyntax
import jason.asSyntax.Literal
import jason.asSyntax.Term
import jason.asSyntax.parser.ParseException
import jason.asSyntax.parser.TokenMgrError

/** The text of [term] in a recording. */
internal fun textOf(term: Term): String = if (term is Literal && !term.isVar && term.isGround) perceptText(term) else "$term"

/**
 * The term that [textOf] wrote as [text].
 * @throws IllegalArgumentException if it is none
 */
internal fun termOf(text: String): Term = perceptOf(text) ?: parsed(text) { ASSyntax.parseTerm(it) }

/** The literal that [textOf] wrote as [text]. */
internal fun literalOf(text: String): Literal = perceptOf(text) ?: parsed(text) { ASSyntax.parseLiteral(it) }

/** It reads strings as boards write them, which Jason's parser does not. */
private fun perceptOf(text: String): Literal? = try {
    if ('"' in text && "::" !in text) PerceptReader.read(text) else null
} catch (_: PerceptSyntaxException) {
    null
}

internal fun <T> parsed(text: String, parse: (String) -> T): T = try {
    parse(text)
} catch (unreadable: ParseException) {
    throw IllegalArgumentException("a recording holds \"$text\", which Jason cannot read", unreadable)
} catch (unreadable: TokenMgrError) {
    throw IllegalArgumentException("a recording holds \"$text\", which Jason cannot read", unreadable)
}
