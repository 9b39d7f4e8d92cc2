package argo.filters.format

import argo.filters.Operator
import argo.filters.Test
import argo.filters.Value

/** The words that filter files have for tests: an operator and a value, both as text. */
internal object TestFormat {
    const val MATCHES = "MATCHES"
    const val IN = "IN"

    /** Names of earlier files: equal, bigger, bigger or equal, smaller, smaller or equal. */
    private val ALIASES = mapOf(
        "E" to Operator.EQ, "B" to Operator.GT, "BE" to Operator.GE, "S" to Operator.LT, "SE" to Operator.LE,
    )

    private val OPERATORS = Operator.entries.map(Operator::name) + listOf(MATCHES, IN)

    private val CANONICAL = (OPERATORS.associateWith { it } + ALIASES.mapValues { (_, operator) -> operator.name })
        .flatMap { (written, name) -> listOf(written to name, written.lowercase() to name) }.toMap()

    val NAMES: String = OPERATORS.joinToString(", ") +
        ALIASES.entries.joinToString(", ", " (or ", ")") { (alias, operator) -> "$alias for $operator" }

    /** The operator that is [written], all in upper or all in lower case and maybe as an alias, or null. */
    fun operator(written: String): String? = CANONICAL[written.trim()]

    /**
     * The test of a canonical [operator] and the value that is [written].
     *
     * @throws IllegalArgumentException if the value does not suit the operator; the message says what is expected
     */
    fun test(operator: String, written: String): Test = when (operator) {
        MATCHES -> Test.Matches(written)
        IN -> Test.OneOf(values(written))
        else -> Test.Compare(Operator.valueOf(operator), value(written))
    }

    fun operator(test: Test): String = when (test) {
        is Test.Compare -> test.operator.name
        is Test.OneOf -> IN
        is Test.Matches -> MATCHES
    }

    fun value(test: Test): String = when (test) {
        is Test.Compare -> test.value.toString()
        is Test.OneOf -> test.values.joinToString(",", "[", "]")
        is Test.Matches -> test.pattern
    }

    private fun value(written: String): Value = try {
        Value.of(written)
    } catch (e: IllegalArgumentException) {
        val hint = if (written.any { it in "*.|^$?\\" }) "; for a regular expression the operator is MATCHES" else ""
        throw IllegalArgumentException(e.message + hint, e)
    }

    /** A Jason list, or the same without its brackets. */
    private fun values(written: String): Set<Value> {
        val list = Value.ofOrNull(written) as? Value.Sequence ?: Value.ofOrNull("[$written]") as? Value.Sequence
        requireNotNull(list) { "'$written' is not a list of values; expected [front,back] or front,back" }
        return list.items.toSet()
    }
}
