package argo.filters

/** A condition of a rule. */
sealed interface Condition {

    /**
     * A condition on the argument at [index], counted from 0. A percept without that argument does not meet it.
     *
     * @throws IllegalArgumentException if [index] is negative
     */
    data class Argument(val index: Int, val test: TermTest) : Condition {
        init {
            requireIndex(index)
        }

        override fun toString(): String = "argument $index $test"
    }

    /**
     * A condition on the annotations called [name]: the first argument of one such annotation must meet all [tests]. Without tests, the
     * percept only needs such an annotation. A percept that has none does not meet the condition.
     */
    data class Annotation(val name: Predicate, val tests: List<TermTest> = emptyList()) : Condition {
        constructor(name: String, vararg tests: TermTest) : this(Predicate.of(name), tests.toList())

        override fun toString(): String =
            if (tests.isEmpty()) "there is an annotation $name" else tests.joinToString(" and ", "annotation $name ")
    }
}

internal fun requireIndex(index: Int) = require(index >= 0) { "arguments are counted from 0, and there is none at $index" }
