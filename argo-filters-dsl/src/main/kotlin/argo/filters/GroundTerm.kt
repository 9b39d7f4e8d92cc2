package argo.filters

/**
 * A ground Jason term. Conditions compare arguments with such terms.
 *
 * Two values are equal if the terms are equal in Jason: `36` equals `36.0`, but the atom `front` does not equal the string `"front"`.
 * [of] turns the text from `toString` back into an equal value.
 */
sealed interface GroundTerm {

    /** A number. Jason's numbers are doubles. */
    class Number(value: Double) : GroundTerm {
        /** The number, never NaN. The number is never negative zero, because Jason treats negative zero as zero. */
        val value: Double = value + 0.0

        init {
            require(!value.isNaN()) { "NaN is no number that a percept could hold" }
        }

        override fun equals(other: Any?): Boolean = other is Number && value == other.value
        override fun hashCode(): Int = value.hashCode()
        override fun toString(): String = when {
            value == Double.POSITIVE_INFINITY -> BEYOND_RANGE
            value == Double.NEGATIVE_INFINITY -> "-$BEYOND_RANGE"
            value == Math.rint(value) && Math.abs(value) < EXACT_INTEGERS -> value.toLong().toString()
            else -> value.toString()
        }

        private companion object {
            const val BEYOND_RANGE = "1e999"
            const val EXACT_INTEGERS = 9007199254740992.0
        }
    }

    /**
     * A string. Jason's syntax cannot express some strings, such as `C:\maps`. `toString` writes their backslashes and carriage returns
     * as `\u005C` and `\u000D`. [of] and the reader of percepts understand these escapes. Jason's parser does not.
     *
     * @property text the characters of the string. `\n`, `\"` and `\uXXXX` are resolved. Other escapes stay as written
     */
    data class Text(val text: String) : GroundTerm {
        override fun toString(): String = StringText.write(text)
    }

    /** A list. */
    data class Sequence(val items: List<GroundTerm>) : GroundTerm {
        override fun toString(): String = items.joinToString(",", "[", "]")
    }

    /** An atom or a structure. An atom has no arguments. Annotations have no order. */
    data class Structure(
        val predicate: Predicate,
        val arguments: List<GroundTerm> = emptyList(),
        val annotations: Set<GroundTerm> = emptySet(),
    ) : GroundTerm {
        init {
            val functor = predicate.functor
            require(!Syntax.isDotted(functor, 0, functor.length)) {
                "'$functor' is an internal action or a function to Jason, and no value"
            }
            require(functor !in Syntax.TRUTH_VALUES || arguments.isEmpty() && annotations.isEmpty()) {
                "'$functor' has neither arguments nor annotations in Jason"
            }
        }

        override fun toString(): String = buildString {
            append(predicate)
            if (arguments.isNotEmpty()) arguments.joinTo(this, ",", "(", ")")
            if (annotations.isNotEmpty()) annotations.map(GroundTerm::toString).sorted().joinTo(this, ",", "[", "]")
        }
    }

    companion object {
        private val WORDS = Regex("[A-Za-z][A-Za-z0-9_]*(?:[ -][A-Za-z0-9_]+)+")

        /**
         * Reads a value in Jason's syntax: `front`, `-3.5`, `"text"`, `pos(1,2)`, `[a,b]`.
         *
         * @throws IllegalArgumentException if [text] is no value; the message states the fault
         */
        fun of(text: String): GroundTerm = requireNotNull(ofOrNull(text)) { explain(text) }

        /** Reads a value like [of]. Returns null if [text] is no value. Variables, expressions and plans are no values. */
        fun ofOrNull(text: CharSequence): GroundTerm? = GroundTermReader(text, 0, text.length).readWhole()

        private fun explain(text: String): String {
            val trimmed = text.trim()
            return when {
                trimmed.isEmpty() -> "the value is missing"
                WORDS.matches(trimmed) -> "'$trimmed' is not a value that Jason can read; a text stands in quotes (\"$trimmed\")"
                trimmed[0] in 'A'..'Z' || trimmed[0] == '_' && Syntax.isWordCharacter(trimmed.last()) ->
                    "'$trimmed' is a variable to Jason; an atom starts with a lower-case letter" +
                        "${inLowerCase(trimmed)?.let { " ($it)" }.orEmpty()} or stands in quotes"
                else -> "'$trimmed' is not a value that Jason can read: " +
                    "an atom (front), a number (-3.5), a string (\"text\"), a structure (pos(1,2)) or a list ([a,b])"
            }
        }

        /**
         * Turns [text], which begins like a variable, into a name. Removes leading underscores and makes the first letter lower case.
         * Returns null if the result is no atom or structure in Jason.
         */
        internal fun inLowerCase(text: String): String? =
            text.trimStart('_').replaceFirstChar(Char::lowercase).takeIf { ofOrNull(it) is Structure }
    }
}
