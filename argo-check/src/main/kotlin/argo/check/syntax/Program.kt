package argo.check.syntax

/**
 * A text in AgentSpeak. After an error the reader continues with the next component.
 *
 * @property tokens all tokens, including comments; only blanks are between them
 * @property errors the reasons why Jason refuses the text, in the order of the text; empty: Jason accepts it
 */
class Program internal constructor(
    val text: String,
    val lines: Lines,
    val tokens: List<Token>,
    val components: List<Component>,
    val errors: List<SyntaxError>,
) {
    /** Returns the nodes that a cursor at [offset] touches, the outermost first. */
    fun nodesAt(offset: Int): List<Node> =
        generateSequence(components.lastOrNull { it.span.touches(offset) } as Node?) { node ->
            node.children.lastOrNull { it.span.touches(offset) }
        }.toList()

    /** Returns the token that contains [offset] or ends there; null: there are only blanks. */
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
 * Reads [text] as a program of Jason 3.2 or 3.3, in time proportional to its length. Reports no error in a text that Jason's parser
 * accepts. Reads other texts as far as possible.
 */
fun programOf(text: String): Program {
    val errors = ArrayList<SyntaxError>()
    val tokens = Lexer(text, errors::add).tokens()
    val lexical = errors.size
    val read = tokens.filter { it.kind != TokenKind.COMMENT && it.kind != TokenKind.UNKNOWN }
    val lines = Lines(text)
    val components = ProgramReader(Cursor(read, lines, errors::add)).components()
    val isWhole = errors.isEmpty()
    if (isWhole) errors += operandErrors(components)
    return Program(text, lines, tokens, components, if (isWhole || lexical > 0) errors.sortedBy { it.span.start } else errors)
}

/** Returns the literal or variable with which [tokens] begin; if it is incomplete, returns its first part. */
internal fun literalOf(tokens: List<Token>, lines: Lines): Term = ProgramReader(Cursor(tokens, lines) {}).literal()
