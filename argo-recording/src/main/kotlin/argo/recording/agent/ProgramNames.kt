package argo.recording.agent

import jason.asSyntax.ASSyntax
import jason.asSyntax.StringTerm
import jason.asSyntax.parser.SimpleCharStream
import jason.asSyntax.parser.Token
import jason.asSyntax.parser.TokenMgrError
import jason.asSyntax.parser.as2jConstants
import jason.asSyntax.parser.as2jTokenManager
import java.io.StringReader

/** The names of files, classes and directives in the [text] of a program. Splits the text into Jason's tokens, and executes none of it. */
internal class ProgramNames(text: String) {
    /**
     * A file that a program includes, by its name in the text. For a file in a block `{ begin … }`, Jason searches only the source path.
     */
    data class Included(val name: String, val isInBlock: Boolean)

    private val tokens = tokensOf(text)

    private val blocks = tokens.indices.runningFold(0) { blocks, at ->
        if (!isAt(at, "{")) blocks else if (isAt(at + 1, "begin")) blocks + 1 else if (isAt(at + 1, "end")) blocks - 1 else blocks
    }

    val includes: List<Included> = tokens.indices.filter { isAt(it, "{") }.mapNotNull { at ->
        val name = argumentOf("include", if (isAt(at + 1, "begin")) at + 2 else at + 1)
        name?.let { Included(it.replace('\\', '/'), blocks[at] > 0) }
    }

    /**
     * The classes of functions and actions that Jason may instantiate when it reads the text. In blocks `{ begin … }` Jason instantiates
     * them without asking the agent.
     */
    val classes: Set<String> = tokens.indices.mapNotNullTo(LinkedHashSet()) { at ->
        argumentOf("register_function", at)
            ?: tokens[at].takeIf { isFunctor(it) && '.' in it.image.drop(1) && (blocks[at] > 0 || isAt(at + 1, "(")) }?.image
    }

    val directives: Set<String> = tokens.indices.filter { isAt(it, "{") && !isAt(it + 1, "end") }
        .mapNotNullTo(LinkedHashSet()) { at -> tokens.getOrNull(if (isAt(at + 1, "begin")) at + 2 else at + 1)?.takeIf(::isFunctor)?.image }

    private fun isFunctor(token: Token) = token.kind == as2jConstants.ATOM

    private fun isAt(place: Int, image: String) = tokens.getOrNull(place)?.image == image

    private fun argumentOf(functor: String, place: Int): String? {
        val string = tokens.getOrNull(place + 2)
        if (!isAt(place, functor) || !isAt(place + 1, "(") || string?.kind != as2jConstants.STRING) return null
        return (ASSyntax.parseTerm(string.image) as StringTerm).string
    }

    private fun tokensOf(text: String): List<Token> {
        val manager = as2jTokenManager(SimpleCharStream(StringReader(text)))
        val tokens = ArrayList<Token>()
        try {
            while (true) tokens += manager.nextToken.takeIf { it.kind != as2jConstants.EOF } ?: break
        } catch (_: TokenMgrError) {
            // Jason reports the error, and reads no further
        }
        return tokens
    }
}
