package argo.check.syntax

internal class BodyReader(private val cursor: Cursor, private val terms: TermReader) {
    /** Reads statements up to a token that begins no statement. */
    fun body(): Body = cursor.nested({ Body(it, emptyList()) }) {
        val start = cursor.start
        body(start, emptyList())
    }

    /** Reads the statements behind [first]. [first] contains the statements already read from offset [start] on. */
    fun body(start: Int, first: List<Statement>): Body {
        val statements = ArrayList(first)
        while (isStatementHere()) {
            val statement = statement()
            statements += statement
            if (!cursor.take(";") && statement !is If && statement !is Loop) break
        }
        return Body(cursor.since(start), statements)
    }

    private fun isStatementHere(): Boolean {
        val token = cursor.current
        return when (token.kind) {
            TokenKind.SYMBOL -> token.text in BEGINNINGS
            TokenKind.KEYWORD -> token.text !in setOf("else", "elif", "div", "mod")
            TokenKind.UNKNOWN -> false
            else -> true
        }
    }

    private fun statement(): Statement = when (cursor.current.takeIf { it.kind == TokenKind.KEYWORD }?.text) {
        "if" -> branches()
        "for", "while" -> loop()
        else -> parallel("|||") { parallel("|&|", ::formula) }
    }

    private inline fun parallel(symbol: String, read: () -> Statement): Statement {
        val first = read()
        if (!cursor.isAt(symbol)) return first
        val branches = arrayListOf(first)
        while (cursor.take(symbol)) branches += read()
        return Parallel(first.span + branches.last().span, branches)
    }

    private fun branches(): If {
        val start = cursor.start
        val branches = ArrayList<Branch>()
        do branches += branch() while (cursor.current.isKeyword("elif"))
        val otherwise = if (cursor.current.isKeyword("else")) {
            cursor.next()
            braces()
        } else {
            null
        }
        return If(cursor.since(start), branches, otherwise)
    }

    private fun branch(): Branch {
        val start = cursor.next().span.start
        val condition = condition()
        val body = braces()
        return Branch(cursor.since(start), condition, body)
    }

    private fun loop(): Loop {
        val keyword = cursor.next()
        val condition = condition()
        val body = braces()
        return Loop(cursor.since(keyword.span.start), keyword.text, condition, body)
    }

    private fun condition(): Term = cursor.between("(", ")", "a closing bracket") { terms.formula() }

    private fun braces(): Body = cursor.between("{", "}", "a statement or a closing brace") { body() }

    private fun formula(): Statement {
        val start = cursor.start
        val operator = operator()
        if (operator == BodyOperator.DO && cursor.isAt("(") && isBodyInBrackets()) return group()
        val isGoal = operator == BodyOperator.ACHIEVE || operator == BodyOperator.ACHIEVE_APART
        val term = if (isGoal) terms.literal() else terms.formula()
        val isSign = operator == BodyOperator.DO || operator == BodyOperator.DELETE // Jason reads the `-` of DELETE as a minus
        if (!isSign && term is Literal && term.isInternal && term.functor.startsWith(".")) { // Jason refuses only actions without a package
            cursor.fail("${term.name} is an internal action, and no belief or goal that ${operator.symbol} can stand before", term.span)
        }
        return Formula(cursor.since(start), operator, term)
    }

    private fun operator(): BodyOperator {
        if (cursor.current.kind != TokenKind.SYMBOL) return BodyOperator.DO
        val one = OPERATORS[cursor.current.text] ?: return BodyOperator.DO
        val two = OPERATORS[cursor.next().text + cursor.current.text]
        if (two != null) cursor.next()
        return two ?: one
    }

    private fun group(): Statement = cursor.nested({ Group(it, Body(it, emptyList())) }) {
        val start = cursor.start
        val body = cursor.between("(", ")", "a closing bracket") { body() }
        Group(cursor.since(start), body)
    }

    /** Returns true if the parentheses here contain statements. Returns false if the parentheses contain a formula. */
    private fun isBodyInBrackets(): Boolean {
        var depth = 0
        var ahead = 0
        while (true) {
            val token = cursor.peek(ahead++)
            when {
                token.kind == TokenKind.UNKNOWN -> return false
                token.isOpening -> depth++
                token.isClosing && --depth == 0 -> return false
                token.kind == TokenKind.SYMBOL && token.text in ONLY_IN_BODIES -> return true
                token.kind == TokenKind.KEYWORD && token.text in setOf("if", "for", "while") -> return true
            }
        }
    }

    private companion object {
        val OPERATORS = BodyOperator.entries.filter { it != BodyOperator.DO }.associateBy { it.symbol }
        val BEGINNINGS = setOf("!", "!!", "?", "+", "-", "(", "[", "{", "~", "::")
        val ONLY_IN_BODIES = setOf(";", "|&|", "|||", "!", "!!", "?")
    }
}
