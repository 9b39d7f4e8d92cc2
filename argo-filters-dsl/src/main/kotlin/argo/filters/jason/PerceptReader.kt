package argo.filters.jason

import jason.asSyntax.ASSyntax
import jason.asSyntax.Literal
import jason.asSyntax.parser.TokenMgrError

/** A percept's text is not a literal; the message says what Jason's parser found. */
class PerceptSyntaxException(message: String, cause: Throwable? = null) : Exception(message, cause)

/**
 * Reads percepts into Jason's literals with the result of Jason's own parser. Literals of the forms that boards send (functors, atoms,
 * numbers, strings, nested structures, lists, annotations, negation) are read faster; other text is left to Jason's parser. In strings it
 * also knows `\uXXXX`, for characters that Jason's syntax cannot write. Any thread may use it.
 */
object PerceptReader {
    private const val SHOWN = 80

    /**
     * Reads the literal whose text is [percept]; returns a new one at each call.
     *
     * @throws PerceptSyntaxException if [percept] is no literal, or is nested too deep for Jason's parser
     */
    @JvmStatic
    fun read(percept: String): Literal = FastLiteralParser(percept).parse() ?: parseWithJason(percept)

    private fun parseWithJason(percept: String): Literal = try {
        ASSyntax.parseLiteral(percept)
    } catch (e: Exception) {
        throw refusal(percept, e) // a ParseException, or a RuntimeException (for expressions that are no formulas, and for large numbers)
    } catch (e: TokenMgrError) {
        throw refusal(percept, e)
    } catch (e: StackOverflowError) {
        throw PerceptSyntaxException("${shortened(percept)} is nested too deep to be read", e)
    }

    private fun refusal(percept: String, cause: Throwable): PerceptSyntaxException {
        val found = cause.message.orEmpty().lineSequence().first()
        return PerceptSyntaxException("${shortened(percept)} is not a literal that Jason can read: $found", cause)
    }

    private fun shortened(percept: String) = if (percept.length <= SHOWN) "'$percept'" else "'${percept.take(SHOWN)}…'"
}
