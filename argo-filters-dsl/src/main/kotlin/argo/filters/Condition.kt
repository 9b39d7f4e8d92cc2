package argo.filters

/** How a condition compares a term with a value. The names are those of the filter files. */
enum class Operator(internal val words: String, internal val ordering: Boolean) {
    EQ("is", false),
    NE("is not", false),
    GT("is greater than", true),
    GE("is at least", true),
    LT("is less than", true),
    LE("is at most", true),
    ;

    internal companion object {
        /** The other names of the filter files' operators: equal, bigger, bigger or equal, smaller, smaller or equal. */
        private val ALIASES = mapOf("E" to EQ, "B" to GT, "BE" to GE, "S" to LT, "SE" to LE)

        private val BY_NAME = (entries.associateBy(Operator::name) + ALIASES)
            .flatMap { (name, operator) -> listOf(name to operator, name.lowercase() to operator) }.toMap()

        val NAMES: String = entries.joinToString(", ") + " (or " + ALIASES.entries.joinToString(", ") { (alias, operator) -> "$alias for $operator" } + ")"

        /** The operator that a filter file calls [name], all in upper or all in lower case, or null. */
        fun named(name: String): Operator? = BY_NAME[name]
    }
}

/**
 * A test of one term.
 *
 * Every test is false for a term that is not ground and plain: variables, expressions, plans.
 */
sealed interface Test {

    /**
     * Compares the term with [value]. The orderings hold only for numbers.
     *
     * @throws IllegalArgumentException if [operator] is an ordering and [value] is not a number
     */
    data class Compare(val operator: Operator, val value: Value) : Test {
        init {
            require(!operator.ordering || value is Value.Number) { "$operator compares numbers, and '$value' is not one" }
        }

        override fun toString(): String = "${operator.words} $value"
    }
}

/** A condition of a rule. */
sealed interface Condition {

    /**
     * A condition on the argument at [index], counted from 0. It is false for a percept that has no such argument.
     *
     * @throws IllegalArgumentException if [index] is negative
     */
    data class Argument(val index: Int, val test: Test) : Condition {
        init {
            require(index >= 0) { "arguments are counted from 0, and there is none at $index" }
        }

        override fun toString(): String = "argument $index $test"
    }

    /**
     * A condition on the annotations called [name]: the first argument of one of them must meet all [tests]. Without tests it is enough
     * that there is one. It is false for a percept that has no such annotation.
     */
    data class Annotation(val name: Predicate, val tests: List<Test> = emptyList()) : Condition {
        constructor(name: String, vararg tests: Test) : this(Predicate.of(name), tests.toList())

        override fun toString(): String =
            if (tests.isEmpty()) "there is an annotation $name" else tests.joinToString(" and ", "annotation $name ")
    }
}
