package argo.filters.matching

import argo.filters.GroundTerm
import argo.filters.Syntax
import com.google.re2j.Pattern

/**
 * Why an agent leaves out a percept of this text, with what to write instead; null if the text is a literal without variables. Never
 * throws. An agent also believes percepts with sums in them, such as `at(2+1)`, which this takes for unreadable.
 */
fun whyUnreadable(percept: String): String? {
    val text = percept.trim()
    val word = text.take(Syntax.wordEnd(text, 0, text.length))
    val foreign = FOREIGN.find(withoutQuoted(text))?.value
    return when {
        GroundTerm.ofOrNull(text) is GroundTerm.Structure -> null
        text.isEmpty() -> "it is empty"
        text[0] in 'A'..'Z' -> "its name begins in upper case, so it is a variable; write ${readableName(text)}"
        text[0] == '_' -> "its name begins with _, so it is a variable; write ${readableName(text)}"
        hasBreakInQuotes(text) -> "there is a line break in quotes; write \\n"
        !isBalanced(text) -> "a bracket or a quote is not closed"
        foreign != null ->
            "$foreign is no letter of a word, which a to z are; put the word in quotes"
        VARIABLE.containsMatchIn(withoutQuoted(text)) ->
            "a word in it begins in upper case, so it is a variable; write it in lower case or in quotes"
        Syntax.isReserved(word, 0, word.length) -> "$word is a word of AgentSpeak, which cannot be a percept's name"
        else -> "it is no literal: a name in lower case, and arguments in brackets, as in dist(front,30)"
    }
}

/** Of RE2, since Java's own patterns use up the stack on a long text in quotes. */
private val QUOTED = Pattern.compile("\"(?:[^\"\\\\]|\\\\.)*\"|'[^']*'")

private fun withoutQuoted(text: String): String = QUOTED.matcher(text).replaceAll("0")

private fun hasBreakInQuotes(text: String): Boolean {
    val quoted = QUOTED.matcher(text)
    return generateSequence { if (quoted.find()) quoted.group() else null }.any { '\n' in it || '\r' in it }
}

private val VARIABLE = Regex("""(?<![\p{L}\p{N}_])[\p{Lu}_]""")

private val FOREIGN = Regex("""[\p{L}&&[^A-Za-z]]""")

/** The text with a name that is none of a variable, or what to write where that does not make it readable. */
private fun readableName(text: String): String = GroundTerm.inLowerCase(text) ?: "a name that begins with one of a to z"
