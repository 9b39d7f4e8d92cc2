package argo.tools.migration

import argo.tools.command.closest

/**
 * An option in a list, such as `baud(9600)` or `urgent`.
 *
 * @property expected the option's value, in words; null: it has none
 * @property accepts returns true if the text, of a value that is no variable, is such a value
 */
internal class KnownOption(val expected: String?, val accepts: (String) -> Boolean) {
    companion object {
        private const val MAX_MS = 600_000

        private fun whole(range: IntRange) =
            KnownOption("a whole number from ${range.first} to ${range.last}") { it.toIntOrNull()?.let(range::contains) == true }

        private fun oneOf(vararg words: String) = KnownOption(words.joinToString(" or "), words::contains)

        private fun any(expected: String) = KnownOption(expected) { true }

        /** The options of `argo.port`, and of `port` in `argo.ports`. */
        val OF_PORT: Map<String, KnownOption> = mapOf(
            "baud" to whole(1..20_000_000), "timeout" to whole(1..MAX_MS), "stale" to whole(0..MAX_MS), "boot" to whole(0..MAX_MS),
            "spacing" to whole(0..MAX_MS), "queue" to whole(1..1000), "mode" to oneOf("request", "listen"),
            "protocol" to oneOf("1", "2", "auto"), "as" to any("the name of a namespace"),
        )

        val OF_ACT: Map<String, KnownOption> = mapOf(
            "timeout" to whole(1..MAX_MS), "urgent" to KnownOption(null) { true }, "latest" to KnownOption(null) { true },
            "port" to any("a port"),
        )

        /** The options of `argo.Arch` in a project file. */
        val OF_ARCH: Map<String, KnownOption> = mapOf(
            "argo_sensing" to oneOf("fresh", "every", "in_cycle"), "argo_percepts" to whole(1..Int.MAX_VALUE),
            "argo_view" to whole(0..65_535), "argo_record" to any("a file, or last(5)"),
            "argo_ros" to KnownOption("the address of a rosbridge_server, as \"robot:9090\"") { it.toIntOrNull() == null },
        )
    }
}

/** Checks the options in [list], the tokens of a list of options; a list that begins otherwise, as a variable, is left out. */
internal fun Advices.options(list: List<Token>, known: Map<String, KnownOption>, owner: String) {
    if (list.firstOrNull()?.isSymbol('[') != true) return
    for (option in itemsIn(list)) {
        val name = option.first()
        if (name.kind != Token.Kind.WORD || name.isVariable) continue
        val value = option.drop(2).dropLast(1)
        option(name, value, known[name.text], known.keys, owner)
    }
}

private fun Advices.option(name: Token, value: List<Token>, known: KnownOption?, names: Set<String>, owner: String) {
    val written = value.joinToString("") { it.text }
    val single = value.singleOrNull()
    when {
        known == null -> {
            val remedy = meant(name.text, names) + "there are ${names.joinToString()}"
            change(name.line, "${name.text} is no option of $owner", remedy)
        }
        known.expected == null ->
            if (value.isNotEmpty()) change(name.line, "${name.text} of $owner has no value, and here it is $written", "write ${name.text}")
        value.isEmpty() -> change(name.line, "${name.text} of $owner needs a value", "it is ${known.expected}")
        single?.isVariable == true -> if (name.text == "as") {
            val what = "$written is a variable to Jason; while it is unbound, $owner fails"
            note(name.line, what, "a namespace begins in lower case: as(${written.replaceFirstChar(Char::lowercase)})")
        }
        (single != null || value.first().isSymbol('-')) && !known.accepts(written.trim('"')) ->
            change(name.line, "${name.text} of $owner is ${known.expected}, not $written", "correct the value")
    }
}

/** Checks the option of `argo.Arch` at [at] in [tokens] of a project file, if there is one. */
internal fun Advices.archOption(tokens: List<Token>, at: Int) {
    val name = tokens[at]
    if (name.kind != Token.Kind.WORD || !name.text.startsWith("argo_") || tokens.getOrNull(at + 1)?.isSymbol('=') != true) return
    val value = tokens.drop(at + 2).takeWhile { !it.isSymbol(',') && !it.isSymbol(']') }
    val known = KnownOption.OF_ARCH[name.text]
    if (known != null || closest(name.text, KnownOption.OF_ARCH.keys) != null) {
        return option(name, value, known, KnownOption.OF_ARCH.keys, "argo.Arch")
    }
    note(name.line, "${name.text} is no option of argo.Arch; an observer of the project may read it", "no change is needed if one does")
}

/** Returns `probably …; ` if one of [names] is nearly [written]; else an empty text. */
internal fun meant(written: String, names: Set<String>): String = closest(written, names)?.let { "probably $it; " }.orEmpty()

/** Returns the items of the list in brackets at the beginning of [list]. */
private fun itemsIn(list: List<Token>): List<List<Token>> {
    val items = ArrayList<ArrayList<Token>>()
    var depth = 0
    for (token in list) {
        val symbol = token.text.singleOrNull().takeIf { token.kind == Token.Kind.SYMBOL }
        if (symbol != null && symbol in ")]}") depth--
        if (depth == 0 && symbol == ']') break
        if (depth == 0 && symbol == '[' || depth == 1 && symbol == ',') items += ArrayList<Token>() else items.last() += token
        if (symbol != null && symbol in "([{") depth++
    }
    return items.filter { it.isNotEmpty() }
}
