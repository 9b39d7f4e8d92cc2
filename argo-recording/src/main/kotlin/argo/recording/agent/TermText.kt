package argo.recording.agent

import argo.filters.jason.PerceptReader
import argo.filters.jason.PerceptSyntaxException
import jason.asSemantics.Agent
import jason.asSyntax.ASSyntax
import jason.asSyntax.Literal
import jason.asSyntax.Term
import jason.asSyntax.Trigger
import jason.asSyntax.parser.ParseException
import jason.asSyntax.parser.TokenMgrError

/** Returns the text of [term] in a recording. [termOf] reads an equal term from it, see [TermWriter]. */
internal fun textOf(term: Term): String = TermWriter().text(term)

/** Returns the text of [literal] for a field that contains only literals, such as percepts or beliefs. */
internal fun literalText(literal: Literal): String = TermWriter().literalText(literal)

internal fun triggerText(trigger: Trigger): String =
    if (trigger.type.name == SIGNAL) textOf(trigger)
    else "${trigger.operator}${trigger.type}${literalText(trigger.literal)}"

/** Returns the text of a message's [content]: a term, or a text that Jason reads when the agent takes the message. */
internal fun contentText(content: Any?): String = when (content) {
    is Term -> textOf(content)
    is String -> "$TEXT${TermWriter.quoted(content)})"
    else -> TermWriter.refusedText("a Java object of the class ${content?.javaClass?.name}")
}

/** Returns the content that [contentText] wrote as [text]. Throws like [termOf]. */
internal fun contentOf(text: String, agent: Agent): Any = try {
    if (text.startsWith(TEXT)) TermReader(text.drop(TEXT.length).dropLast(1)).quotedText() else termOf(text, agent)
} catch (_: TermReader.Unreadable) {
    throw unreadable(text, null)
} catch (@Suppress("TooGenericExceptionCaught") broken: RuntimeException) { // of Jason's own parser and terms, for some texts
    throw broken as? IllegalArgumentException ?: unreadable(text, broken)
}

private const val TEXT = "#text("

/** The trigger type of signals, which Jason 3.2.1 lacks. In the notation of triggers, a signal would look like a belief. */
private const val SIGNAL = "signal"

/**
 * Returns the term that [textOf] wrote as [text].
 *
 * @param agent the term may contain functions of this agent; if null, only Jason's own functions
 * @throws UnrecordableTerm if [textOf] could not write the term
 * @throws IllegalArgumentException if [text] is not the text of a term
 */
internal fun termOf(text: String, agent: Agent? = null): Term = try {
    TermReader(text, agent).term()
} catch (_: TermReader.Unreadable) {
    perceptOf(text) ?: parsed(text) { ASSyntax.parseTerm(it) }
}

/** Returns the literal that [literalText] wrote as [text]. Throws like [termOf]. */
internal fun literalOf(text: String): Literal = try {
    TermReader(text).literal()
} catch (_: TermReader.Unreadable) {
    perceptOf(text) ?: parsed(text) { ASSyntax.parseLiteral(it) }
}

/** Returns the trigger that [triggerText] wrote as [text]. Throws like [termOf]. */
internal fun triggerOf(text: String): Trigger {
    if (text.startsWith("#")) return termOf(text) as Trigger
    val operator = Trigger.TEOperator.entries.find { text.startsWith("$it") } ?: return parsed(text, ASSyntax::parseTrigger)
    val rest = text.drop("$operator".length)
    val type = listOf(Trigger.TEType.achieve, Trigger.TEType.test).find { rest.startsWith("$it") } ?: Trigger.TEType.belief
    return Trigger(operator, type, literalOf(rest.drop("$type".length)))
}

/** Reads a percept of a recording in format 1. The percept's strings are in the boards' notation, which Jason's parser does not read. */
private fun perceptOf(text: String): Literal? = try {
    if ('"' in text && "::" !in text) PerceptReader.read(text) else null
} catch (_: PerceptSyntaxException) {
    null
}

private fun <T> parsed(text: String, parse: (String) -> T): T = try {
    parse(text)
} catch (reason: ParseException) {
    throw unreadable(text, reason)
} catch (reason: TokenMgrError) {
    throw unreadable(text, reason)
}

/** Shows only the beginning of [text], since a text from another computer may have millions of characters. */
private fun unreadable(text: String, reason: Throwable?) =
    IllegalArgumentException("Jason cannot read \"${if (text.length > SHOWN) text.take(SHOWN) + "…" else text}\"", reason)

private const val SHOWN = 200
