package argo.check.syntax

internal class ProgramReader(private val cursor: Cursor) {
    private val terms = TermReader(cursor, ::block)
    private val bodies = BodyReader(cursor, terms)

    fun literal(): Term = terms.literal()

    fun components(): List<Component> = buildList {
        while (!cursor.isAtEnd) addAll(withRecovery { component() })
    }

    private fun withRecovery(read: () -> Component): List<Component> {
        val from = cursor.at
        val component = read()
        if (!cursor.isLost) return listOf(component)
        val failed = cursor.start
        cursor.restart(from)
        return listOfNotNull(component, Unread(cursor.since(failed)).takeIf { it.span.length > 0 })
    }

    private fun component(): Component {
        val token = cursor.current
        return when {
            token.isSymbol("{") -> directive()
            token.isSymbol("!") -> goal()
            token.text in EVENTS || token.isSymbol("@") -> plan()
            else -> belief()
        }
    }

    private fun directive(): Directive = cursor.nested({ Directive(it, null, null) }) {
        val start = cursor.start
        cursor.expect("{")
        val isBlock = cursor.current.isKeyword("begin") && cursor.next().span.length > 0
        val call = terms.literal() as? Literal
        cursor.expect("}", "a closing brace")
        val components = if (isBlock) untilEnd() else null
        Directive(cursor.since(start), call, components)
    }

    private fun untilEnd(): List<Component> {
        val inner = buildList {
            while (!cursor.isAtEnd && !cursor.isLost && !isEndHere()) addAll(withRecovery { component() })
        }
        if (isEndHere()) repeat(END_TOKENS) { cursor.next() } else cursor.expected("{ end }")
        return inner
    }

    private fun isEndHere() = cursor.isAt("{") && cursor.peek(1).isKeyword("end") && cursor.peek(2).isSymbol("}")

    private fun goal(): InitialGoal {
        val start = cursor.next().span.start
        val goal = terms.literal()
        fullStop()
        return InitialGoal(cursor.since(start), goal)
    }

    private fun belief(): Belief {
        val start = cursor.start
        val head = terms.literal()
        if (head is Variable) cursor.fail("a belief is no variable, as ${head.name} is", head.span)
        val condition = if (cursor.take(":-")) terms.formula() else null
        fullStop(if (condition == null) "a full stop or :-" else Cursor.FULL_STOP)
        return Belief(cursor.since(start), head, condition)
    }

    private fun fullStop(what: String = Cursor.FULL_STOP) = cursor.expect(".", what)

    private fun plan(): Plan = cursor.nested({ plan(it.start, null, Trigger(it, "+", EventKind.BELIEF, Missing(it)), null, null) }) {
        val start = cursor.start
        val label = label()
        val trigger = trigger()
        val context = if (cursor.take(":")) terms.formula() else null
        val goalCondition = if (cursor.take("<:")) terms.formula() else null
        val body = if (cursor.take("<-")) bodyOf("a statement") else null
        fullStop()
        val plans = if (cursor.isAt("{") && cursor.peek(1).text in PLAN_BEGINNINGS) inner() else emptyList()
        Plan(cursor.since(start), label, trigger, context, goalCondition, body, plans)
    }

    private fun plan(start: Int, label: Label?, trigger: Trigger, context: Term?, body: Body?) =
        Plan(cursor.since(start), label, trigger, context, null, body, emptyList())

    private fun bodyOf(what: String): Body = bodies.body().also { if (it.statements.isEmpty()) cursor.expected(what) }

    private fun inner(): List<Plan> = cursor.between("{", "}", "a plan or a closing brace") {
        buildList {
            while (!cursor.isAt("}") && !cursor.isLost && !cursor.isAtEnd) add(plan())
        }
    }

    private fun label(): Label? {
        if (!cursor.isAt("@")) return null
        val start = cursor.next().span.start
        val token = cursor.current
        val isNamed = token.kind == TokenKind.ATOM || token.kind == TokenKind.VARIABLE || token.text == "begin" || token.text == "end"
        val name = if (isNamed) cursor.next().let { Name(it.span, it.text) } else null
        val annotations = if (cursor.isAt("[")) terms.list() else null
        if (name == null && annotations == null) cursor.expected("the name of a plan")
        return Label(cursor.since(start), name, annotations)
    }

    private fun trigger(): Trigger {
        val start = cursor.start
        val operator = cursor.current.text
        if (operator in EVENTS) cursor.next() else cursor.expected("an event, which begins with + or -")
        val kind = EventKind.entries.drop(1).firstOrNull { cursor.take(it.symbol) } ?: EventKind.BELIEF
        val term = terms.literal()
        return Trigger(cursor.since(start), operator, kind, term)
    }

    private fun block(): Block = cursor.nested({ Block(it, Body(it, emptyList())) }) {
        val start = cursor.start
        val content = cursor.between("{", "}", "a closing brace") { content() }
        Block(cursor.since(start), content)
    }

    private fun content(): Node {
        val start = cursor.start
        if (!isEventHere()) return bodyOrRule()
        val label = label()
        val trigger = trigger()
        val context = if (cursor.take(":")) terms.formula() else null
        val isBody = label == null && context == null && trigger.kind == EventKind.BELIEF && trigger.operator != "^"
        return when {
            cursor.take("<-") -> bodyOf("a statement").let { plan(start, label, trigger, context, it) }
            isBody -> statements(trigger)
            label != null || context != null -> plan(start, label, trigger, context, null)
            else -> trigger
        }
    }

    /** Reads the statements behind [first], which looks like an event, as in `{ +a; b }`. */
    private fun statements(first: Trigger): Body {
        val operator = if (first.operator == "+") BodyOperator.ADD else BodyOperator.DELETE
        val statements = listOf(Formula(first.span, operator, first.term))
        return if (cursor.take(";")) bodies.body(first.span.start, statements) else Body(first.span, statements)
    }

    private fun bodyOrRule(): Node {
        val body = bodies.body()
        if (!cursor.isAt(":-")) return body
        val head = (body.statements.singleOrNull() as? Formula)?.takeIf { it.operator == BodyOperator.DO }?.term
        if (head == null) cursor.expected("a closing brace")
        cursor.take(":-")
        val condition = terms.formula()
        return Belief(cursor.since(body.span.start), head ?: Missing(body.span), condition)
    }

    private fun isEventHere(): Boolean {
        if (cursor.isAt("@") || cursor.isAt("^")) return true
        if (!cursor.isAt("+") && !cursor.isAt("-")) return false
        val follower = cursor.peek(1)
        return follower.kind == TokenKind.ATOM || follower.kind == TokenKind.VARIABLE || follower.text in EVENT_PARTS
    }

    private companion object {
        val EVENTS = setOf("+", "-", "^")
        val PLAN_BEGINNINGS = EVENTS + setOf("@", "}")
        val EVENT_PARTS = setOf("!", "?", "~", "::", "true", "false", "begin", "end")

        const val END_TOKENS = 3
    }
}
