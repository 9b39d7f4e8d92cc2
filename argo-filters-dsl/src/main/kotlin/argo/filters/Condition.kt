package argo.filters

/** How a condition compares a term with a value. The names are those of the filter files. */
enum class Operator(internal val words: String, internal val ordering: Boolean) {
    EQ("is", false),
    NE("is not", false),
    GT("is greater than", true),
    GE("is at least", true),
    LT("is less than", true),
    LE("is at most", true),
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
     * A condition on the annotations called [name], of which one must meet it: with a [test], the first argument of the annotation
     * must meet the test; without, the annotation must be there. It is false for a percept that has no such annotation.
     */
    data class Annotation(val name: Predicate, val test: Test? = null) : Condition {
        override fun toString(): String = if (test == null) "there is an annotation $name" else "annotation $name $test"
    }
}
