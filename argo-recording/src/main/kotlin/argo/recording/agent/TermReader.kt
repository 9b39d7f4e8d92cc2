package argo.recording.agent

import jason.asSemantics.Agent
import jason.asSemantics.ArithFunction
import jason.asSyntax.ArithExpr
import jason.asSyntax.ArithFunctionTerm
import jason.asSyntax.Atom
import jason.asSyntax.BinaryStructure
import jason.asSyntax.InternalActionLiteral
import jason.asSyntax.ListTerm
import jason.asSyntax.ListTermImpl
import jason.asSyntax.Literal
import jason.asSyntax.LiteralImpl
import jason.asSyntax.LogExpr
import jason.asSyntax.LogicalFormula
import jason.asSyntax.MapTermImpl
import jason.asSyntax.NumberTerm
import jason.asSyntax.NumberTermImpl
import jason.asSyntax.Plan
import jason.asSyntax.PlanBody
import jason.asSyntax.PlanBodyImpl
import jason.asSyntax.Pred
import jason.asSyntax.RelExpr
import jason.asSyntax.Rule
import jason.asSyntax.SetTermImpl
import jason.asSyntax.SourceInfo
import jason.asSyntax.StringTermImpl
import jason.asSyntax.Structure
import jason.asSyntax.Term
import jason.asSyntax.Trigger
import jason.asSyntax.UnnamedVar
import jason.asSyntax.VarTerm
import jason.asSyntax.directives.FunctionRegister

/**
 * Reads the term that [TermWriter] wrote as [text]. Leaves Jason's counters unchanged. The text may name functions of [agent]; if [agent]
 * is null, only Jason's own functions.
 */
internal class TermReader(private val text: String, private val agent: Agent? = null) {
    /** Reports that the text does not come from [TermWriter]. */
    class Unreadable : Exception()

    private var at = 0

    fun term(): Term = whole(::next)

    /** Reads a text that can only be a literal. */
    fun literal(): Literal = whole {
        val read = next() as? Literal ?: fail()
        if (read.javaClass == Atom::class.java && !text.startsWith("#atom(")) LiteralImpl(read.ns, Literal.LPos, read.functor) else read
    }

    fun quotedText(): String = whole(::quoted)

    private inline fun <T> whole(read: () -> T): T {
        val value = try {
            read()
        } catch (_: ClassCastException) {
            fail()
        } catch (_: NumberFormatException) {
            fail()
        }
        if (at != text.length) fail()
        return value
    }

    private fun fail(): Nothing = throw Unreadable()

    private fun take(token: String): Boolean = text.startsWith(token, at).also { if (it) at += token.length }

    private fun expect(token: String) {
        if (!take(token)) fail()
    }

    private fun peek(): Char = text.getOrElse(at) { END }

    private inline fun word(isPart: (Char) -> Boolean): String {
        val start = at
        while (at < text.length && isPart(text[at])) at++
        return text.substring(start, at)
    }

    private fun next(): Term = when (val first = peek()) {
        '"' -> StringTermImpl(plainString())
        '[' -> list()
        '(' -> operation()
        '#' -> if (text.getOrElse(at + 1) { END } == '"') literalHere() else marked()
        else -> if (first.isDigit() || first == '-') NumberTermImpl(number()) else if (take("not (")) negation() else literalHere()
    }

    private fun number(): Double {
        val start = at
        take("-")
        if (!peek().isDigit()) fail()
        word(Char::isDigit)
        if (peek() == '.' && text.getOrElse(at + 1) { END }.isDigit()) {
            at++
            word(Char::isDigit)
        }
        if (peek() == 'E' || peek() == 'e') {
            at++
            if (!take("-")) take("+")
            word(Char::isDigit)
        }
        return text.substring(start, at).toDouble()
    }

    private fun plainString(): String {
        val start = ++at
        while (peek() != '"') {
            if (at >= text.length) fail()
            at += if (peek() == '\\') 2 else 1
        }
        return text.substring(start, at++).replace("\\n", "\n").replace("\\\"", "\"")
    }

    private fun quoted(): String {
        expect("\"")
        val read = StringBuilder()
        while (true) {
            if (at >= text.length) fail()
            when (val sign = text[at++]) {
                '"' -> return "$read"
                '\\' -> read.append(escaped())
                else -> read.append(sign)
            }
        }
    }

    private fun escaped(): Char {
        if (at >= text.length) fail()
        return when (val sign = text[at++]) {
            'n' -> '\n'
            'u' -> {
                if (at + HEX > text.length) fail()
                text.substring(at, at + HEX).toInt(RADIX).toChar().also { at += HEX }
            }
            else -> sign
        }
    }

    private fun items(end: String): List<Term> {
        if (take(end)) return emptyList()
        val items = ArrayList<Term>()
        do items += next() while (take(","))
        expect(end)
        return items
    }

    private fun list(): ListTerm {
        expect("[")
        val list = ListTermImpl()
        if (take("]")) return list
        var last: ListTerm = list
        if (peek() != '|') do last = last.append(next()) while (take(","))
        if (take("|")) last.setTail(literalHere() as VarTerm)
        expect("]")
        return list
    }

    private fun negation(): Term = LogExpr(LogExpr.LogicalOp.not, next() as LogicalFormula).also { expect(")") }

    private fun operation(): Term {
        expect("(")
        if (take("+")) return sign(ArithExpr.ArithmeticOp.plus)
        if (peek() == '-') {
            val start = at++
            if (!peek().isDigit()) return sign(ArithExpr.ArithmeticOp.minus)
            val size = number()
            if (take(")")) return ArithExpr(ArithExpr.ArithmeticOp.minus, NumberTermImpl(size))
            at = start
        }
        val left = next()
        return binary(left).also { expect(")") }
    }

    private fun sign(of: ArithExpr.ArithmeticOp): Term = ArithExpr(of, next() as NumberTerm).also { expect(")") }

    private fun binary(left: Term): Term {
        LOGICAL.firstOrNull { take("$it") }?.let { return LogExpr(left as LogicalFormula, it, next() as LogicalFormula) }
        RELATIONAL.firstOrNull { take("$it") }?.let { return RelExpr(left, it, next()) }
        val operator = ARITHMETIC.firstOrNull { take("$it") } ?: fail()
        return ArithExpr(left as NumberTerm, operator, next() as NumberTerm)
    }

    private fun literalHere(): Literal {
        val isNegated = take("~")
        val first = name()
        if (!take("::")) return annotated(first, Literal.DefaultNS, isNegated)
        val space = first.run { variable?.let { variableOf(it, number, Literal.DefaultNS) } ?: Atom(functor) }
        return take("~").let { annotated(name(), space, it || isNegated) }
    }

    private class Name(val functor: String, val variable: String? = null, val number: Int? = null, val isPlain: Boolean = false)

    private fun name(): Name = when {
        take("#var(") -> {
            val name = quoted()
            val number = if (take(",")) whole() else null
            expect(")")
            Name("", name, number)
        }
        take("#") -> Name(quoted())
        peek() == '\'' -> {
            val start = at++
            word { it != '\'' }
            expect("'")
            Name(text.substring(start, at))
        }
        else -> nameOf(word { it.isLetterOrDigit() || it == '_' || it == '.' })
    }

    private fun nameOf(word: String): Name = when {
        word.isEmpty() || word[0].isDigit() -> fail()
        word[0] == '_' -> Name("", word, TermWriter.NUMBERED.matchEntire(word)?.groupValues?.get(1)?.toInt() ?: fail())
        word[0].isUpperCase() -> if ('.' in word) fail() else Name("", word)
        else -> Name(word, isPlain = true)
    }

    private fun whole(): Int = word { it.isDigit() || it == '-' }.toInt()

    private fun variableOf(name: String, number: Int?, space: Atom): VarTerm =
        if (number == null) VarTerm(space, name) else UnnamedVar.create(space, -number, name)

    private fun annotated(name: Name, space: Atom, isNegated: Boolean): Literal {
        if (name.variable != null) {
            val variable = variableOf(name.variable, name.number, space)
            if (isNegated) variable.setNegated(Literal.LNeg)
            annotate(variable)
            return variable
        }
        if (name.isPlain && '.' in name.functor) return call(name.functor, space)
        val isLiteral = peek() == '('
        val terms = if (take("(")) items(")") else emptyList()
        if (!isLiteral && !isNegated && peek() != '[') {
            if (name.isPlain && space == Literal.DefaultNS) CONSTANTS[name.functor]?.let { return it }
            return atom(name.functor, space)
        }
        val literal = LiteralImpl(space, !isNegated, name.functor)
        if (terms.isNotEmpty()) literal.terms = terms
        annotate(literal)
        return literal
    }

    /** Adds the annotations in their written order. Jason would sort annotations, but it cannot compare terms of every kind. */
    private fun annotate(literal: Literal) {
        if (peek() == '[') literal.annotatedBy(list())
    }

    private fun <T : Literal> T.annotatedBy(annotations: ListTerm?): T = also { literal ->
        if (annotations?.term == null) return@also literal.setAnnots(annotations).let { }
        literal.setAnnots(ListTermImpl().also { it.append(annotations.term) })
        literal.annots.setNext(annotations.next)
    }

    private fun atom(functor: String, space: Atom): Literal =
        Atom(functor).let { if (space == Literal.DefaultNS) it else it.cloneNS(space) }

    private fun call(functor: String, space: Atom): Literal {
        val structure = Structure(functor)
        if (take("(")) structure.terms = items(")")
        return InternalActionLiteral(space, structure, null)
    }

    private fun marked(): Term {
        expect("#")
        val kind = (if (take("-")) "-" else "") + word(Char::isLetter)
        if (!take("(")) return CONSTANT_NUMBERS[kind]?.let(::NumberTermImpl) ?: if (kind == "null") StringTermImpl() else fail()
        return when (kind) {
            "var" -> {
                at -= "#var(".length
                literalHere()
            }
            "atom" -> literalHere().also { expect(")") }
            "structure" -> literalHere().let { read -> Structure(read.ns, read.functor).with(read.terms) }.also { expect(")") }
            "pred" -> literalHere().let { Pred(it.ns, it.functor).with(it.terms).annotatedBy(it.annots) }.also { expect(")") }
            "string" -> StringTermImpl(quoted()).also { expect(")") }
            "set" -> SetTermImpl().apply { items(")").forEach(::add) }
            "map" -> MapTermImpl().apply { items(")").chunked(2).forEach { if (it.size == 2) put(it[0], it[1]) else fail() } }
            "fun" -> function()
            "plan" -> plan().also { expect(")") }
            "rule" -> rule().also { expect(")") }
            "event" -> event().also { expect(")") }
            "body" -> body().also { expect(")") }
            "refused" -> throw UnrecordableTerm(quoted())
            else -> fail()
        }
    }

    private fun function(): Term {
        val name = (next() as StringTermImpl).string
        val terms = if (take(",")) items(")") else emptyList<Term>().also { expect(")") }
        val function: ArithFunction = agent?.getFunction(name, terms.size) ?: FunctionRegister.getFunction(name, terms.size)
            ?: throw UnrecordableTerm("the function $name, which the agent does not have")
        return ArithFunctionTerm(function).also {
            it.terms = terms
            it.agent = agent
        }
    }

    /** Sets [terms] without a copy. Jason's copies of variables lose their negation. */
    private fun <T : Structure> T.with(terms: List<Term>?): T = also { if (!terms.isNullOrEmpty()) it.terms = terms }

    private fun flag(): Boolean = if (take("1")) true else if (take("0")) false else fail()

    private fun <T> orNone(read: () -> T): T? = if (take(TermWriter.NONE)) null else read()

    private fun place(): SourceInfo? = orNone {
        expect("#at(")
        val file = orNone(::quoted)
        expect(",")
        val begin = whole()
        expect(",")
        SourceInfo(file, begin, whole()).also { expect(")") }
    }

    private fun <T> then(read: () -> T): T {
        expect(",")
        return read()
    }

    private fun plan(): Plan {
        val isTerm = flag()
        val source = then(::quoted)
        val place = then(::place)
        val label = then { orNone(::next) } as Literal?
        val trigger = then(::next) as Trigger
        val context = then { orNone(::next) } as LogicalFormula?
        val condition = then { orNone(::next) } as LogicalFormula?
        val plan = Plan(label?.let { it as? Pred ?: Pred(it) }, trigger, context, then(::next) as PlanBody)
        plan.srcInfo = place
        plan.sourceFile = source
        plan.setAsPlanTerm(isTerm)
        if (condition != null) plan.goalCondition = condition
        return plan
    }

    private fun rule(): Rule {
        val isTerm = flag()
        val head = then(::literalHere)
        return Rule(if (head is Pred) head else LiteralImpl(head), then(::next) as LogicalFormula).apply { setAsTerm(isTerm) }
    }

    private fun event(): Trigger {
        val isTerm = flag()
        val operator = then { Trigger.TEOperator.valueOf(word(Char::isLetter)) }
        val type = then { Trigger.TEType.valueOf(word(Char::isLetter)) }
        val place = then(::place)
        val literal = then(::next) as Literal
        if (place != null && literal.srcInfo == null) literal.srcInfo = place
        return Trigger(operator, type, literal).apply { setAsTriggerTerm(isTerm) }
    }

    private fun body(): PlanBody {
        val isTerm = flag()
        val steps = ArrayList<PlanBodyImpl>()
        do {
            val type = then { PlanBody.BodyType.valueOf(word(Char::isLetter)) }
            val place = then(::place)
            val term = then { orNone(::next) }
            if (place != null && term != null) stand(term, place)
            val step = PlanBodyImpl(type, term, isTerm)
            step.srcInfo = place
            steps += step
        } while (peek() == ',')
        steps.zipWithNext { one, other -> one.bodyNext = other }
        return steps.first()
    }

    /** Copies of steps, comparisons and sums get their places from their terms. So gives [place] to the terms. */
    private fun stand(term: Term, place: SourceInfo) {
        if (term.srcInfo == null) term.srcInfo = place
        if (term is BinaryStructure || term is ArithExpr) term.terms.forEach { stand(it, place) }
    }

    private companion object {
        const val END = '\u0000'
        const val HEX = 4
        const val RADIX = 16
        val CONSTANTS = mapOf("true" to Literal.LTrue, "false" to Literal.LFalse, "default" to Literal.DefaultNS)
        val CONSTANT_NUMBERS =
            mapOf("NaN" to Double.NaN, "Infinity" to Double.POSITIVE_INFINITY, "-Infinity" to Double.NEGATIVE_INFINITY)
        val LOGICAL = listOf(LogExpr.LogicalOp.and, LogExpr.LogicalOp.or)

        val RELATIONAL = RelExpr.RelationalOp.entries.filter { "$it".isNotEmpty() }.sortedByDescending { "$it".length }
        val ARITHMETIC = ArithExpr.ArithmeticOp.entries.filter { "$it".isNotEmpty() }.sortedByDescending { "$it".length }
    }
}
