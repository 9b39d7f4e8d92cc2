package argo.filters

/** A condition of a rule. */
sealed interface Condition {

    /**
     * A condition on the argument at [index], counted from 0. A percept without that argument does not meet the condition.
     *
     * @property until a second limit. Once a sensor's number has met [test], the condition holds until a number fails [test]'s comparison
     *     with this limit. Null: the condition holds only while the numbers meet [test]. Percepts that differ only in this argument come
     *     from one sensor
     * @throws IllegalArgumentException if [index] is negative, or [until] is not a finite number beyond the limit of an ordering
     */
    data class Argument(val index: Int, val test: TermTest, val until: Double? = null) : Condition {
        init {
            requireIndex(index)
            until?.let { requireBeyond(test, it) }
        }

        /** Returns the comparison with the second limit, or null. A condition that holds continues to hold until this comparison fails. */
        internal fun untilTest(): TermTest.Compare? =
            until?.let { TermTest.Compare((test as TermTest.Compare).operator, GroundTerm.Number(it)) }

        override fun toString(): String = "argument $index $test" + until?.let { " until ${GroundTerm.Number(it)}" }.orEmpty()
    }

    /**
     * A condition on annotations. The percept must have an annotation called [name] whose first argument meets all [tests]. If there are
     * no tests, the annotation alone is enough.
     */
    data class Annotation(val name: Predicate, val tests: List<TermTest> = emptyList()) : Condition {
        constructor(name: String, vararg tests: TermTest) : this(Predicate.of(name), tests.toList())

        override fun toString(): String =
            if (tests.isEmpty()) "there is an annotation $name" else tests.joinToString(" and ", "annotation $name ")
    }
}

private fun requireBeyond(test: TermTest, until: Double) {
    require(until.isFinite()) { "the second limit $until is no finite number" }
    require(test is TermTest.Compare && test.operator.ordering) {
        "a condition that $test has no limit that ${GroundTerm.Number(until)} could be the second one of"
    }
    val limit = (test.value as GroundTerm.Number).value
    val isBelow = test.operator == Operator.LT || test.operator == Operator.LE
    require(if (isBelow) until > limit else until < limit) {
        "the condition holds until ${GroundTerm.Number(until)} though it $test; expected a number ${if (isBelow) "above" else "below"} that"
    }
}

internal fun requireIndex(index: Int) = require(index >= 0) { "arguments are counted from 0, and there is none at $index" }
