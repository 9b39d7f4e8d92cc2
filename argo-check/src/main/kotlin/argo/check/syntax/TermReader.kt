package argo.check.syntax

/** Reads terms and formulas. [readBlock] reads a term in braces. */
internal class TermReader(private val cursor: Cursor, private val readBlock: () -> Block) {
    /** Reads a logical formula or any other term. Every term can be a formula. */
    fun formula(): Term = cursor.nested(::Missing) {
        chain(OR) { chain(AND) { if (cursor.current.isKeyword("not")) Prefixed(cursor.next(), comparison()) else comparison() } }
    }

    /** Reads a literal or a variable, as it may follow `!` or stand in an event or the head of a belief. */
    fun literal(): Term {
        val start = cursor.start
        val namespace = namespace()
        val isNegated = cursor.take("~")
        val token = cursor.current
        return when {
            token.kind == TokenKind.VARIABLE -> variable(start, namespace, isNegated)
            token.kind == TokenKind.ATOM || token.isKeyword("begin") || token.isKeyword("end") -> structure(start, namespace, isNegated)
            token.isKeyword("true") || token.isKeyword("false") ->
                cursor.next().let { Literal(it.span, namespace, isNegated, Name(it.span, it.text), emptyList(), null, false) }
            else -> missing("a literal")
        }
    }

    fun list(): ListTerm = cursor.nested({ ListTerm(it, emptyList(), null) }) {
        val start = cursor.start
        cursor.expect("[")
        val items = if (cursor.isAt("]") || cursor.isAt("|")) emptyList() else separated(::operand)
        val tail = if (cursor.take("|")) tail() else null
        cursor.expect("]", "] or a comma")
        ListTerm(cursor.since(start), items, tail)
    }

    private fun tail(): Term = if (cursor.isAt("[")) list() else {
        if (cursor.current.kind == TokenKind.VARIABLE) variable(cursor.start, null, false) else missing("a variable or a list")
    }

    private fun comparison(): Term = operand().let { left ->
        if (cursor.current.text in COMPARISONS) Operation(listOf(cursor.next()), listOf(left, operand())) else left
    }

    private fun operand(): Term = when {
        cursor.current.kind == TokenKind.STRING -> cursor.next().let { StringTerm(it.span, it.text.removeSurrounding("\"")) }
        cursor.isAt("[") -> list()
        cursor.isAt("{") -> readBlock()
        else -> chain(SUMS) { chain(PRODUCTS) { chain(POWERS) { number() } } }
    }

    private fun number(): Term = when {
        cursor.isAt("+") || cursor.isAt("-") -> Prefixed(cursor.next(), unsigned())
        else -> unsigned()
    }

    private fun unsigned(): Term = when {
        cursor.current.kind == TokenKind.NUMBER -> cursor.next().let { NumberTerm(it.span, it.text) }
        cursor.isAt("(") -> bracketed()
        else -> if (isLiteralHere()) literal() else missing("a term")
    }

    private fun bracketed(): Term {
        val start = cursor.start
        val term = cursor.between("(", ")", "a closing bracket") { formula() }
        return Bracketed(cursor.since(start), term)
    }

    private fun isLiteralHere(): Boolean {
        val token = cursor.current
        return token.kind == TokenKind.ATOM || token.kind == TokenKind.VARIABLE || token.text in LITERAL_BEGINNINGS
    }

    private fun namespace(): Term? {
        val token = cursor.current
        val isNamed = cursor.peek(1).isSymbol("::")
        return when {
            cursor.isAt("::") -> Literal(cursor.next().span, null, false, Name(token.span, "this_ns"), emptyList(), null, false)
            isNamed && token.kind == TokenKind.ATOM -> {
                cursor.next()
                cursor.next()
                Literal(token.span, null, false, Name(token.span, token.text), emptyList(), null, false)
            }
            token.kind == TokenKind.VARIABLE && isNamed -> variable(cursor.start, null, false).also { cursor.next() }
            else -> null
        }
    }

    private fun variable(start: Int, namespace: Term?, isNegated: Boolean): Variable {
        val token = cursor.next()
        val annotations = if (cursor.isAt("[")) list() else null
        return Variable(cursor.since(start), namespace, isNegated, Name(token.span, token.text), annotations)
    }

    private fun structure(start: Int, namespace: Term?, isNegated: Boolean): Literal {
        val token = cursor.next()
        val isQuoted = token.text.startsWith('\'')
        val name = Name(token.span, if (isQuoted) token.text.removeSurrounding("'") else token.text)
        val arguments = if (cursor.take("(")) arguments() else emptyList()
        val annotations = if (cursor.isAt("[")) list() else null
        return Literal(cursor.since(start), namespace, isNegated, name, arguments, annotations, !isQuoted && '.' in token.text)
    }

    private fun arguments(): List<Term> = separated(::formula).also { cursor.expect(")", "a comma or a closing bracket") }

    private fun <T> separated(read: () -> T): List<T> = buildList {
        do add(read()) while (cursor.take(","))
    }

    /** Reads operands between [operators]. A `+` or `-` before `!` or `?` belongs to the next plan. */
    private inline fun chain(operators: Set<String>, read: () -> Term): Term {
        val first = read()
        if (!isOperator(operators)) return first
        val found = ArrayList<Token>()
        val operands = arrayListOf(first)
        while (isOperator(operators)) {
            found += cursor.next()
            operands += read()
        }
        return Operation(found, operands)
    }

    private fun isOperator(operators: Set<String>): Boolean {
        val token = cursor.current
        if (token.text !in operators || token.kind != TokenKind.SYMBOL && token.kind != TokenKind.KEYWORD) return false
        val follower = cursor.peek(1)
        return !(operators === SUMS && (follower.isSymbol("!") || follower.isSymbol("?")))
    }

    private fun missing(what: String): Missing {
        val place = cursor.start
        cursor.expected(what)
        return Missing(Span(place, place))
    }

    private companion object {
        val OR = setOf("|")
        val AND = setOf("&")
        val SUMS = setOf("+", "-")
        val PRODUCTS = setOf("*", "/", "div", "mod")
        val POWERS = setOf("**")
        val COMPARISONS = setOf("<", "<=", ">", ">=", "==", "\\==", "=", "=..")
        val LITERAL_BEGINNINGS = setOf("~", "::", "true", "false", "begin", "end")
    }
}
