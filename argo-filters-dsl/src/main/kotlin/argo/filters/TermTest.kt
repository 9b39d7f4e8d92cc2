package argo.filters

/** A comparison of a term with a value. Filter files use the names of these constants. */
enum class Operator(internal val words: String, internal val ordering: Boolean) {
    EQ("is", false),
    NE("is not", false),
    GT("is greater than", true),
    GE("is at least", true),
    LT("is less than", true),
    LE("is at most", true),
}

/** A test of one term. Variables, expressions and plans meet no test. */
sealed interface TermTest {

    /**
     * Compares the term with [value]. If [operator] is an ordering, the test holds only for numbers.
     *
     * @throws IllegalArgumentException if [operator] is an ordering and [value] is no number
     */
    data class Compare(val operator: Operator, val value: GroundTerm) : TermTest {
        init {
            require(!operator.ordering || value is GroundTerm.Number) { "$operator compares numbers, and '$value' is not one" }
        }

        override fun toString(): String = "${operator.words} $value"
    }

    /**
     * Holds for a term that equals one of [values].
     *
     * @throws IllegalArgumentException if [values] is empty
     */
    data class OneOf(val values: Set<GroundTerm>) : TermTest {
        init {
            require(values.isNotEmpty()) { "IN needs at least one value" }
        }

        override fun toString(): String = values.joinToString(", ", "is one of ")
    }

    /**
     * Holds for a term whose whole text matches the regular expression [pattern]. The text is that of [GroundTerm.toString]: strings have
     * quotes, and structures have no blanks.
     *
     * RE2's syntax has no look-around and no back references. Matching therefore takes time linear in the length of the text.
     *
     * @throws IllegalArgumentException if [pattern] is not in RE2's syntax, or is too large
     */
    data class Matches(val pattern: String) : TermTest {
        init {
            require(pattern.isNotEmpty() && pattern == pattern.trim()) {
                "the pattern '$pattern' is empty or begins or ends with a blank, which a file cannot hold there; [ ] matches one"
            }
        }

        private val compiled = LinearPattern(pattern)

        internal fun matches(text: String): Boolean = compiled.matches(text)

        override fun toString(): String = "matches $pattern"
    }
}
