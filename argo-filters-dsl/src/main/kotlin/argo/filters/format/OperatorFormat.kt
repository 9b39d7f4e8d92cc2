package argo.filters.format

import argo.filters.GroundTerm
import argo.filters.Operator
import argo.filters.TermTest

/** Reads and writes the tests in filter files. A test is an operator and a value, both as text. */
internal object OperatorFormat {
    const val MATCHES = "MATCHES"
    const val IN = "IN"

    /** Operators in earlier files: equal, bigger, bigger or equal, smaller, smaller or equal. */
    private val ALIASES = mapOf(
        "E" to Operator.EQ, "B" to Operator.GT, "BE" to Operator.GE, "S" to Operator.LT, "SE" to Operator.LE,
    )

    private val OPERATORS = Operator.entries.map(Operator::name) + listOf(MATCHES, IN)

    private val CANONICAL = (OPERATORS.associateWith { it } + ALIASES.mapValues { (_, operator) -> operator.name })
        .flatMap { (written, name) -> listOf(written to name, written.lowercase() to name) }.toMap()

    val NAMES: String = OPERATORS.joinToString(", ") +
        ALIASES.entries.joinToString(", ", " (or ", ")") { (alias, operator) -> "$alias for $operator" }

    /** Returns the canonical name of the operator [written], or null. [written] may be an alias or in lower case. */
    fun operator(written: String): String? = CANONICAL[written.trim()]

    /**
     * Returns the test of a canonical [operator] with the value [written].
     *
     * @throws IllegalArgumentException if the value does not suit the operator; the message says which values do
     */
    fun test(operator: String, written: String): TermTest = when (operator) {
        MATCHES -> TermTest.Matches(written)
        IN -> TermTest.OneOf(values(written))
        else -> TermTest.Compare(Operator.valueOf(operator), value(written))
    }

    fun operator(test: TermTest): String = when (test) {
        is TermTest.Compare -> test.operator.name
        is TermTest.OneOf -> IN
        is TermTest.Matches -> MATCHES
    }

    fun value(test: TermTest): String = when (test) {
        is TermTest.Compare -> test.value.toString()
        is TermTest.OneOf -> test.values.joinToString(",", "[", "]")
        is TermTest.Matches -> test.pattern
    }

    private fun value(written: String): GroundTerm = try {
        GroundTerm.of(written)
    } catch (e: IllegalArgumentException) {
        val hint = if (written.any { it in "*.|^$?\\" }) "; for a regular expression the operator is MATCHES" else ""
        throw IllegalArgumentException(e.message + hint, e)
    }

    /** Reads the values of a Jason list with or without its brackets. */
    private fun values(written: String): Set<GroundTerm> {
        val list = GroundTerm.ofOrNull(written) as? GroundTerm.Sequence ?: GroundTerm.ofOrNull("[$written]") as? GroundTerm.Sequence
        requireNotNull(list) { "'$written' is not a list of values; expected [front,back] or front,back" }
        return list.items.toSet()
    }
}
