package argo.check.syntax

/**
 * An AgentSpeak text. After an error, the reader continues with the next component.
 *
 * @property tokens all tokens, including comments; only blanks are outside tokens
 * @property errors the reasons why Jason refuses the text, in text order; empty if Jason accepts it
 */
class Program internal constructor(
    val text: String,
    val lines: Lines,
    val tokens: List<Token>,
    val components: List<Component>,
    val errors: List<SyntaxError>,
) {
    /** Returns the nodes at [offset], the outermost first. A node's end counts as inside. */
    fun nodesAt(offset: Int): List<Node> =
        generateSequence(components.lastOrNull { it.span.touches(offset) } as Node?) { node ->
            node.children.lastOrNull { it.span.touches(offset) }
        }.toList()

    /** Returns the token that contains [offset] or ends there, or null if only blanks are there. */
    fun tokenAt(offset: Int): Token? {
        val next = tokens.binarySearchBy(offset) { it.span.start }.let { if (it >= 0) it else -it - 2 }
        return listOfNotNull(tokens.getOrNull(next), tokens.getOrNull(next - 1)).firstOrNull { it.span.touches(offset) }
    }

    /** Returns the comments, each with the line in which it begins. */
    internal fun comments(): List<Pair<Int, String>> =
        tokens.filter { it.kind == TokenKind.COMMENT }.map { lines.position(it.span.start).line to it.text }

    /** Returns all nodes, each before its children. */
    fun nodes(): Sequence<Node> = components.asSequence().flatMap { it.withDescendants() }
}

/** Returns this node and all its descendants, each before its children. */
fun Node.withDescendants(): Sequence<Node> = sequence {
    val waiting = ArrayDeque(listOf(this@withDescendants))
    while (waiting.isNotEmpty()) {
        val node = waiting.removeLast()
        yield(node)
        waiting.addAll(node.children.asReversed())
    }
}

/**
 * Reads [text] as a program of Jason 3.2 or 3.3. The time is proportional to the length of [text]. Reports no error if Jason's parser
 * accepts the text. Reads the correct parts of other texts.
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

/** Returns the literal or variable at the beginning of [tokens]. If it is incomplete, returns its first part. */
internal fun literalOf(tokens: List<Token>, lines: Lines): Term = ProgramReader(Cursor(tokens, lines) {}).literal()
