package argo.filters.jason

import argo.filters.foreignText
import jason.asSyntax.ASSyntax
import jason.asSyntax.Literal
import jason.asSyntax.parser.TokenMgrError

/** Thrown if the text of a percept is no literal. The message contains the error of Jason's parser. */
class PerceptSyntaxException(message: String, cause: Throwable? = null) : Exception(message, cause)

/**
 * Reads percepts into the literals that Jason's own parser would return. Reads usual forms faster than Jason: functors, atoms, numbers,
 * strings, nested structures, lists, annotations, negation. Jason's parser reads all other text. `\uXXXX` in a string stands for a
 * character that Jason's syntax cannot express. Safe for use by several threads at once.
 */
object PerceptReader {
    /**
     * Reads the literal in the text [percept]. Returns a new literal at each call.
     *
     * @throws PerceptSyntaxException if [percept] is no literal, or if it is nested too deep for Jason's parser
     */
    @JvmStatic
    fun read(percept: String): Literal = FastLiteralParser(percept).parse() ?: parseWithJason(percept)

    private fun parseWithJason(percept: String): Literal = try {
        ASSyntax.parseLiteral(percept)
    } catch (e: Exception) {
        throw refusal(percept, e) // a RuntimeException comes from an expression that is no formula, or from a large number
    } catch (e: TokenMgrError) {
        throw refusal(percept, e)
    } catch (e: StackOverflowError) {
        throw PerceptSyntaxException("${shown(percept)} is nested too deep to be read", e)
    }

    private fun refusal(percept: String, cause: Throwable): PerceptSyntaxException {
        val found = cause.message.orEmpty().lineSequence().first()
        return PerceptSyntaxException("${shown(percept)} is not a literal that Jason can read: ${foreignText(found, first = 200)}", cause)
    }

    private fun shown(percept: String) = "'${foreignText(percept, first = 80)}'"
}
