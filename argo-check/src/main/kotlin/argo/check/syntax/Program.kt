package argo.check.syntax

/**
 * A text in AgentSpeak, as far as it can be read: after an error the next component is read.
 *
 * @property tokens all tokens with the comments; only blanks are between them
 * @property errors the reasons why Jason refuses the text, in the order of the text; empty if it does not
 */
class Program internal constructor(
    val text: String,
    val lines: Lines,
    val tokens: List<Token>,
    val components: List<Component>,
    val errors: List<SyntaxError>,
) {
    /** Returns the nodes that a cursor at [offset] touches, the outermost first; empty if it touches none. */
    fun nodesAt(offset: Int): List<Node> =
        generateSequence(components.lastOrNull { it.span.touches(offset) } as Node?) { node ->
            node.children.lastOrNull { it.span.touches(offset) }
        }.toList()

    /** Returns the token that contains [offset], or ends there; null: there are blanks. */
    fun tokenAt(offset: Int): Token? {
        val next = tokens.binarySearchBy(offset) { it.span.start }.let { if (it >= 0) it else -it - 2 }
        return listOfNotNull(tokens.getOrNull(next), tokens.getOrNull(next - 1)).firstOrNull { it.span.touches(offset) }
    }

    /** Returns all nodes, each before its children. */
    fun nodes(): Sequence<Node> = components.asSequence().flatMap { it.withDescendants() }
}

/** Returns this node and all below it, each before its children. */
fun Node.withDescendants(): Sequence<Node> = sequence {
    val waiting = ArrayDeque(listOf(this@withDescendants))
    while (waiting.isNotEmpty()) {
        val node = waiting.removeLast()
        yield(node)
        waiting.addAll(node.children.asReversed())
    }
}

/**
 * Reads [text] in the AgentSpeak of Jason 3.2 and 3.3. Takes time proportional to the text's length. Reads each text that Jason's parser
 * accepts without an error, and every other one as far as possible.
 */
fun programOf(text: String): Program {
    val errors = ArrayList<SyntaxError>()
    val tokens = Lexer(text, errors::add).tokens()
    val lexical = errors.size
    val read = tokens.filter { it.kind != TokenKind.COMMENT && it.kind != TokenKind.UNKNOWN }
    val lines = Lines(text)
    val components = ProgramReader(Cursor(read, lines, errors::add)).components()
    return Program(text, lines, tokens, components, if (lexical == 0) errors else errors.sortedBy { it.span.start })
}
