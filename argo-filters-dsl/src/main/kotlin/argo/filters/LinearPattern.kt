package argo.filters

import com.google.re2j.Pattern
import com.google.re2j.PatternSyntaxException

/**
 * A regular expression. Matching takes linear time and bounded memory.
 *
 * @throws IllegalArgumentException if [pattern] is not in RE2's syntax or is too large
 */
internal class LinearPattern(pattern: String) {
    private val compiled: Pattern

    init {
        require(pattern.length <= MAX_LENGTH) { "the pattern is ${pattern.length} characters long; at most $MAX_LENGTH are expected" }
        require(repetitions(pattern) <= MAX_REPETITIONS) {
            "the counts in '$pattern' repeat more than $MAX_REPETITIONS times together; use smaller counts"
        }
        compiled = try {
            Pattern.compile(pattern, Pattern.DOTALL)
        } catch (e: PatternSyntaxException) {
            throw IllegalArgumentException("'$pattern' is not a regular expression in RE2's syntax: ${e.description}", e)
        }
        require(compiled.programSize() <= MAX_PROGRAM) { "the pattern '$pattern' is too large" }
    }

    fun matches(text: String): Boolean = compiled.matches(text)

    /** Returns an upper bound of the copies that RE2's compiler makes of a part of the pattern: the product of the counts. */
    private fun repetitions(pattern: String): Long =
        COUNT.findAll(pattern).fold(1L) { product, count -> minOf(product * maxOf(largest(count), 1), MAX_REPETITIONS + 1) }

    private fun largest(count: MatchResult): Long =
        count.groupValues.drop(1).mapNotNull(String::toLongOrNull).maxOrNull() ?: 1

    private companion object {
        const val MAX_LENGTH = 1_000
        const val MAX_REPETITIONS = 1_000L
        const val MAX_PROGRAM = 10_000
        val COUNT = Regex("""\{(\d{1,9})(?:,(\d{0,9}))?\}""")
    }
}
