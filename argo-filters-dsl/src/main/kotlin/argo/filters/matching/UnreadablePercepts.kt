package argo.filters.matching

import argo.filters.GroundTerm
import argo.filters.Syntax
import com.google.re2j.Pattern

/**
 * Explains why an agent leaves out a percept with this text, and how to correct the text. Returns null if the text is a literal without
 * variables and with finite numbers. Never throws. A percept with a sum, such as `at(2+1)`, counts as unreadable here, although an agent
 * believes it.
 */
fun whyUnreadable(percept: String): String? {
    val text = percept.trim()
    val word = text.take(Syntax.wordEnd(text, 0, text.length))
    val foreign = FOREIGN.find(withoutQuoted(text))?.value
    val value = GroundTerm.ofOrNull(text)
    return when {
        text in Syntax.TRUTH_VALUES -> reserved(text)
        value is GroundTerm.Structure -> if (isFinite(value)) null else INFINITE
        text.isEmpty() -> "it is empty"
        text[0] in 'A'..'Z' -> "its name begins in upper case, so it is a variable; write ${readableName(text)}"
        text[0] == '_' -> "its name begins with _, so it is a variable; write ${readableName(text)}"
        hasBreakInQuotes(text) -> "there is a line break in quotes; write \\n"
        !isBalanced(text) -> "a bracket or a quote is not closed"
        foreign != null ->
            "$foreign is no letter of a word, which a to z are; put the word in quotes"
        VARIABLE.containsMatchIn(withoutQuoted(text)) ->
            "a word in it begins in upper case, so it is a variable; write it in lower case or in quotes"
        Syntax.isReserved(word, 0, word.length) -> reserved(word)
        WRONG_ESCAPE.containsMatchIn(text.replace("\\\\", "")) ->
            "a backslash in it begins no escape that Jason knows; write \\u005C for a backslash"
        else -> "it is no literal: a name in lower case, and arguments in brackets, as in dist(front,30)"
    }
}

private fun reserved(word: String) = "$word is a word of AgentSpeak, which cannot be a percept's name"

/** Explains that an agent leaves out a percept with a number that is infinite or NaN. */
const val INFINITE: String = "it holds a number that is infinite or none; the largest that an agent knows is 1.7976931348623157e308"

private fun isFinite(term: GroundTerm): Boolean = when (term) {
    is GroundTerm.Number -> term.value.isFinite()
    is GroundTerm.Sequence -> term.items.all(::isFinite)
    is GroundTerm.Structure -> term.arguments.all(::isFinite) && term.annotations.all(::isFinite)
    is GroundTerm.Text -> true
}

/** Returns true if [percept] contains an AgentSpeak comment outside of quotes. */
fun hasComment(percept: String): Boolean =
    ("//" in percept || "/*" in percept) && withoutQuoted(percept).let { "//" in it || "/*" in it }

/** A pattern for RE2. On a long text in quotes, Java's own engine overflows the stack. */
private val QUOTED = Pattern.compile("\"(?:[^\"\\\\]|\\\\.)*\"|'[^']*'")

private fun withoutQuoted(text: String): String = QUOTED.matcher(text).replaceAll("0")

private fun hasBreakInQuotes(text: String): Boolean {
    val quoted = QUOTED.matcher(text)
    return generateSequence { if (quoted.find()) quoted.group() else null }.any { '\n' in it || '\r' in it }
}

private val WRONG_ESCAPE = Regex("""\\(?:[^ntbrf"'u0-7]|u(?![0-9a-fA-F]{4}))""")
private val VARIABLE = Regex("""(?<![\p{L}\p{N}_])[\p{Lu}_]""")

private val FOREIGN = Regex("""[\p{L}&&[^A-Za-z]]""")

/** Returns [text] changed so that its name is no variable. If the result is unreadable, returns advice in words. */
private fun readableName(text: String): String = GroundTerm.inLowerCase(text) ?: "a name that begins with one of a to z"
