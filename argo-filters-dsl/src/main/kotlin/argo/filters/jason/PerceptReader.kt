package argo.filters.jason

import jason.asSyntax.ASSyntax
import jason.asSyntax.Literal
import jason.asSyntax.parser.ParseException
import jason.asSyntax.parser.TokenMgrError

/** A percept's text is not a literal; the message says what Jason's parser found. */
class PerceptSyntaxException(message: String, cause: Throwable? = null) : Exception(message, cause)

/**
 * Reads percepts into Jason's literals, just as Jason's own parser does but faster for what boards send: functors, atoms, numbers, strings,
 * nested structures, lists, annotations and negation. Anything else is left to Jason's parser.
 *
 * Literals are kept and given again for the same text, so they must not be changed; Jason's belief base copies what it adds. Not safe for
 * use by several threads at once.
 *
 * @param kept how many literals are kept at most; those that were not asked for longest go first
 * @throws IllegalArgumentException if [kept] is negative
 */
class PerceptReader(private val kept: Int = DEFAULT_KEPT) {
    init {
        require(kept >= 0) { "a reader cannot keep $kept literals" }
    }

    private val literals = object : LinkedHashMap<String, Literal>(INITIAL_CAPACITY, LOAD_FACTOR, true) {
        override fun removeEldestEntry(eldest: Map.Entry<String, Literal>) = size > kept
    }

    /**
     * The literal that [percept] is the text of.
     *
     * @throws PerceptSyntaxException if it is none, or is nested too deep for Jason's parser
     */
    fun read(percept: String): Literal = literals[percept] ?: parse(percept).also { literals[percept] = it }

    private fun parse(percept: String): Literal = LiteralParser(percept).parse() ?: parseWithJason(percept)

    private fun parseWithJason(percept: String): Literal = try {
        ASSyntax.parseLiteral(percept)
    } catch (e: ParseException) {
        throw refusal(percept, e)
    } catch (e: TokenMgrError) {
        throw refusal(percept, e)
    } catch (e: RuntimeException) {
        throw refusal(percept, e) // so it refuses expressions of terms that are no formulas, and numbers out of range
    } catch (e: StackOverflowError) {
        throw PerceptSyntaxException("${shortened(percept)} is nested too deep to be read", e)
    }

    private fun refusal(percept: String, cause: Throwable) =
        PerceptSyntaxException("${shortened(percept)} is not a literal that Jason can read: ${cause.message.orEmpty().lineSequence().first()}", cause)

    private fun shortened(percept: String) = if (percept.length <= SHOWN) "'$percept'" else "'${percept.take(SHOWN)}…'"

    private companion object {
        const val DEFAULT_KEPT = 1_024
        const val INITIAL_CAPACITY = 16
        const val LOAD_FACTOR = 0.75f
        const val SHOWN = 80
    }
}
