package argo.check.rules

import argo.check.syntax.Lexer
import argo.check.syntax.ListTerm
import argo.check.syntax.Literal
import argo.check.syntax.NumberTerm
import argo.check.syntax.Prefixed
import argo.check.syntax.StringTerm
import argo.check.syntax.Term
import argo.check.syntax.TokenKind
import argo.check.syntax.Variable

/**
 * An option in a list, such as `baud(9600)` or `urgent`.
 *
 * @property expected the option's value in words, or null if the option has no value
 * @property accepts returns true for a valid value; not called for variables
 */
internal class KnownOption(val expected: String?, val accepts: (String) -> Boolean) {
    companion object {
        private const val MAX_MS = 600_000

        private fun whole(range: IntRange) =
            KnownOption("a whole number from ${range.first} to ${range.last}") { it.toIntOrNull()?.let(range::contains) == true }

        private fun oneOf(vararg words: String) = KnownOption(words.joinToString(" or "), words::contains)

        private fun any(expected: String) = KnownOption(expected) { true }

        val OF_PORT: Map<String, KnownOption> = mapOf(
            "baud" to whole(1..20_000_000), "timeout" to whole(1..MAX_MS), "stale" to whole(0..MAX_MS), "boot" to whole(0..MAX_MS),
            "spacing" to whole(0..MAX_MS), "queue" to whole(1..1000), "mode" to oneOf("request", "listen"),
            "protocol" to oneOf("1", "2", "auto"), "as" to any("the name of a namespace"),
        )

        val OF_ACT: Map<String, KnownOption> = mapOf(
            "timeout" to whole(1..MAX_MS), "urgent" to KnownOption(null) { true }, "latest" to KnownOption(null) { true },
            "port" to any("a port"), "answer" to any("a term, as a variable"),
        )

        val OF_ARCH: Map<String, KnownOption> = mapOf(
            "argo_sensing" to oneOf("fresh", "every", "in_cycle"), "argo_percepts" to whole(1..Int.MAX_VALUE),
            "argo_view" to whole(0..65_535),
            "argo_watch" to oneOf("true", "false"),
            "argo_debug" to whole(0..65_535),
            "argo_safe" to KnownOption("a command without variables, as stop or \"speed(0)\"", ::isCommand),
            "argo_record" to KnownOption("a file such as \"drive.mcap\", or \"last(5)\" for the last five minutes", ::isRecording),
            "argo_resume" to KnownOption("the name of a file, as \"robot.state\"") { it.isNotBlank() },
            "argo_ros" to KnownOption("the address of a rosbridge_server, as \"robot:9090\"") { value ->
                value.isNotBlank() && value.toIntOrNull() == null
            },
            OF_FLEET to KnownOption("computers and agents, or one of them, as \"computers,agents\"") { value ->
                value.split(',').all { it.trim() in setOf("computers", "agents") }
            },
        )

        /** The option for fleets. Agents without the architecture `argo.Arch` may have it, too. */
        const val OF_FLEET = "argo_fleet"

        private fun isCommand(value: String) = Regex("""\s*[a-z]\w*\s*(\(.+\)\s*)?""").matches(value) &&
            Lexer(value) {}.tokens().none { it.kind == TokenKind.VARIABLE }

        private fun isRecording(value: String): Boolean {
            val last = Regex("last\\((.*)\\)").matchEntire(value.trim())
            return value.isNotBlank() && (last == null || last.groupValues[1].trim().toDoubleOrNull().let { it != null && it > 0 })
        }
    }
}

internal object Options {
    fun check(list: ListTerm, known: Map<String, KnownOption>, owner: String, report: Report) {
        val options = list.items.filterIsInstance<Literal>()
        options.forEach { option(it, known[it.functor], known.keys, owner, report) }
        options.groupBy { it.functor }.filterKeys(known::contains).values.mapNotNull { it.getOrNull(1) }.forEach {
            report.error("option", it.span, "${it.functor} of $owner is given twice", "the plan fails there", "keep one of them")
        }
    }

    private fun option(option: Literal, known: KnownOption?, names: Set<String>, owner: String, report: Report) {
        val name = option.functor
        val value = option.arguments.singleOrNull()
        when {
            known == null -> report.error(
                "option", option.span, "$name is no option of $owner", "the plan fails there",
                SimilarNames.near(name, names)?.let { "did you mean $it?" } ?: "there are ${names.joinToString()}",
            )
            known.expected == null -> if (option.arity > 0) {
                report.error("option", option.span, "$name of $owner has no value, and here it is ${value ?: "several"}",
                    "the plan fails there", "write $name")
            }
            value == null -> report.error("option", option.span, "$name of $owner needs a value", "the plan fails there",
                "it is ${known.expected}")
            value is Variable -> if (name == "as" && option.arity == 1 && value.name.text.first().isUpperCase()) {
                report.hint(
                    "namespace", value.span, "${value.name} is a variable to Jason", "while it is unbound, $owner fails",
                    "a namespace begins in lower case: as(${value.name.text.replaceFirstChar(Char::lowercase)})",
                )
            }
            written(value)?.let(known.accepts) == false ->
                report.error("option", value.span, "$name of $owner is ${known.expected}, not ${written(value)}", "the plan fails there",
                    "correct the value")
        }
    }

    private fun written(value: Term): String? = when (value) {
        is Literal -> value.functor
        is NumberTerm -> value.text
        is StringTerm -> value.text
        is Prefixed -> written(value.operand)?.let { value.operator.text + it }
        else -> null
    }
}
