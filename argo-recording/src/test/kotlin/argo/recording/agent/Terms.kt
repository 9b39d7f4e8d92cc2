package argo.recording.agent

import io.kotest.property.Arb
import io.kotest.property.RandomSource
import io.kotest.property.arbitrary.arbitrary
import io.kotest.property.arbitrary.next
import jason.asSyntax.ArithExpr
import jason.asSyntax.ArithFunctionTerm
import jason.asSyntax.Atom
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
import kotlin.random.Random

/** Generates terms of all kinds that Jason has. */
internal fun Arb.Companion.terms(): Arb<Term> = arbitrary { DrawnTerms(it.random).term(4) }

/** Generates literals such as percepts and beliefs. */
internal fun Arb.Companion.literals(): Arb<Literal> = arbitrary {
    DrawnTerms(it.random).run { if (it.random.nextInt(5) == 0) Atom(functor()) else literal(3) }
}

private class DrawnTerms(private val random: Random) {
    private fun <T> oneOf(vararg values: T): T = values[random.nextInt(values.size)]

    private fun sometimes(oneIn: Int = 3) = random.nextInt(oneIn) == 0

    fun term(depth: Int): Term = when (random.nextInt(if (depth == 0) 4 else 16)) {
        0 -> number()
        1 -> StringTermImpl(text())
        2 -> oneOf<Term>(Atom(functor()), Literal.LTrue, Literal.LFalse, Literal.DefaultNS, Atom(functor()).cloneNS(Atom("ns")))
        3 -> variable(depth)
        4, 5, 6 -> literal(depth)
        7 -> list(depth)
        8 -> SetTermImpl().apply { repeat(random.nextInt(3)) { add(ground(depth)) } }
        9 -> MapTermImpl().apply { repeat(random.nextInt(3)) { put(ground(depth), term(depth - 1)) } }
        10 -> expression(depth)
        11 -> formula(depth)
        12 -> body(depth)
        13 -> event(depth)
        14 -> plan(depth)
        else -> Rule(literal(depth - 1), formula(depth - 1)).apply { setAsTerm(sometimes(2)) }
    }

    /** Generates an element of a set. Sets sort their elements, and Jason cannot compare terms of every kind. */
    private fun ground(depth: Int): Term = if (depth > 1 && sometimes()) Structure("f").addTerms(number(), Atom(functor())) else number()

    private fun number() = NumberTermImpl(
        oneOf(
            0.0, -0.0, 1.0, -1.0, 2.5, -2.5e-7, 1e15, -1e15, 1e300, Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY,
            Double.MIN_VALUE, Double.MAX_VALUE, random.nextInt().toDouble(), random.nextDouble(),
        ),
    )

    private fun text() = buildString {
        repeat(random.nextInt(6)) {
            append(oneOf('a', ' ', '"', '\\', '\n', '\r', '\t', '\'', '#', '(', ',', 'é', '\uD83D', '\u0000', '\u2028', 'n', 'u', '0'))
        }
    }

    fun functor(): String = oneOf("a", "front", "dist_2", "ação", "'Upper Case'", "Upper", "", "not", "true", "a.b", "mod", "_x", text())

    private fun variable(depth: Int): VarTerm {
        val space = if (sometimes(6)) Atom("ns") else Literal.DefaultNS
        val variable = when (random.nextInt(5)) {
            0 -> UnnamedVar(space, random.nextInt(1, 1000))
            1 -> UnnamedVar.create(space, random.nextInt(1, 1000), oneOf("_7", "_x", "_12Ag"))
            2 -> UnnamedVar.create(space, "_Ag")
            else -> VarTerm(space, oneOf("X", "Cm", "Älter", "_", "_5", "x y"))
        }
        if (sometimes(6)) variable.setNegated(Literal.LNeg)
        if (depth > 0 && sometimes(6)) variable.setAnnots(list(depth - 1))
        return variable
    }

    private fun list(depth: Int): ListTerm = ListTermImpl().apply {
        repeat(random.nextInt(4)) { append(term(maxOf(0, depth - 1))) }
        if (size > 0 && sometimes(4)) setTail(VarTerm("T"))
    }

    fun literal(depth: Int): Literal {
        val space = if (sometimes(5)) oneOf(Atom("ns"), Atom("N s"), VarTerm("NS")) else Literal.DefaultNS
        if (sometimes(8)) return InternalActionLiteral(space, structure(oneOf(".print", "argo.act", "my.own.action"), depth), null)
        if (sometimes(8)) return structure(functor(), depth)
        if (sometimes(10)) return Pred(functor()).apply { setAnnots(list(0)) }
        if (sometimes(10)) return Pred.createSource(Atom("boss"))
        val literal = LiteralImpl(space, !sometimes(4), functor())
        repeat(random.nextInt(4)) { literal.addTerm(term(maxOf(0, depth - 1))) }
        if (depth > 0 && sometimes()) literal.setAnnots(list(depth - 1))
        return literal
    }

    private fun structure(functor: String, depth: Int) = Structure(functor).apply {
        repeat(random.nextInt(3)) { addTerm(term(maxOf(0, depth - 1))) }
    }

    private fun expression(depth: Int): NumberTerm = when (random.nextInt(if (depth == 0) 2 else 5)) {
        0 -> number()
        1 -> variable(0)
        2 -> ArithExpr(oneOf(ArithExpr.ArithmeticOp.minus, ArithExpr.ArithmeticOp.plus), expression(depth - 1))
        3 -> ArithFunctionTerm(FunctionRegister.getFunction("math.max", 2))
            .apply { terms = listOf(expression(depth - 1), expression(depth - 1)) }
        else -> ArithExpr(
            expression(depth - 1), ArithExpr.ArithmeticOp.entries.filter { "$it".isNotEmpty() }.random(random), expression(depth - 1),
        )
    }

    private fun formula(depth: Int): LogicalFormula = when (random.nextInt(if (depth <= 0) 1 else 4)) {
        0 -> literal(0)
        1 -> LogExpr(LogExpr.LogicalOp.not, formula(depth - 1))
        2 -> LogExpr(formula(depth - 1), oneOf(LogExpr.LogicalOp.and, LogExpr.LogicalOp.or), formula(depth - 1))
        else -> RelExpr(term(0), RelExpr.RelationalOp.entries.filter { "$it".isNotEmpty() }.random(random), term(depth - 1))
    }

    private fun event(depth: Int): Trigger {
        val literal = literal(depth - 1).apply { if (sometimes(2)) srcInfo = SourceInfo(oneOf(null, "file:a.asl"), 3, 5) }
        return Trigger(Trigger.TEOperator.entries.random(random), Trigger.TEType.entries.random(random), literal)
            .apply { setAsTriggerTerm(sometimes(2)) }
    }

    private fun body(depth: Int): PlanBody {
        val isTerm = sometimes(2)
        if (sometimes(5)) return PlanBodyImpl(PlanBody.BodyType.none, isTerm)
        val steps = List(random.nextInt(1, 4)) {
            PlanBodyImpl(PlanBody.BodyType.entries.random(random), literal(depth - 1), isTerm)
                .apply { if (sometimes(2)) srcInfo = SourceInfo("file:a.asl", random.nextInt(100)) }
        }
        steps.zipWithNext { one, other -> one.bodyNext = other }
        return steps.first()
    }

    private fun plan(depth: Int): Plan {
        val label = if (sometimes(2)) Pred("l1").apply { setAnnots(list(0)) } else null
        return Plan(label, event(depth), if (sometimes(2)) formula(depth - 1) else null, body(depth)).apply {
            setAsPlanTerm(sometimes(2))
            sourceFile = oneOf("", "file:a.asl")
            if (sometimes()) goalCondition = formula(depth - 1)
            if (sometimes()) srcInfo = SourceInfo("file:a.asl", 7, 9)
        }
    }
}

internal fun differences(one: Any?, other: Any?): List<String> {
    fun <T : Any> differing(what: String, of: T.() -> Any?): List<String> {
        @Suppress("UNCHECKED_CAST")
            val (before, after) = (one as T).of() to (other as T).of()
        val isPart = before is Term || after is Term
        if (isPart) return differences(before, after)
        return if (before == after) emptyList() else listOf("$what of $one: $before, not $after")
    }
    if (one == null && other == null) return emptyList()
    if (one == null || other == null || classOf(one) != classOf(other)) {
        return listOf("$one is of ${one?.javaClass}, not of ${other?.javaClass}")
    }
    if (one is Atom && one === Literal.DefaultNS) return if (one === other) emptyList() else listOf("$one, not $other")
    return when (one) {
        is NumberTermImpl -> differing<NumberTermImpl>("value") { solve().toRawBits() }
        is StringTermImpl -> differing<StringTermImpl>("text") { string }
        is SetTermImpl -> of(one.toList(), (other as SetTermImpl).toList())
        is MapTermImpl -> of(one.keys().toList(), (other as MapTermImpl).keys().toList()) +
            of(one.values().toList(), other.values().toList())
        is Plan -> differing<Plan>("term") { isPlanTerm } + differing<Plan>("source") { sourceFile } +
            differing<Plan>("place") { "$srcInfo" } +
            differing<Plan>("label") { label } + differing<Plan>("trigger") { trigger } + differing<Plan>("context") { context } +
            differing<Plan>("condition") { goalCondition } + differing<Plan>("body") { body }
        is PlanBodyImpl -> differing<PlanBodyImpl>("type") { bodyType } + differing<PlanBodyImpl>("term") { isBodyTerm } +
            differing<PlanBodyImpl>("place") { "$srcInfo" } + differing<PlanBodyImpl>("step") { bodyTerm } +
            differing<PlanBodyImpl>("next") { bodyNext }
        is Trigger -> differing<Trigger>("text") { "$this".take(2) } + differing<Trigger>("type") { type } +
            differing<Trigger>("operator") { operator } + differing<Trigger>("literal") { literal } +
            differing<Trigger>("place") { "${literal.srcInfo}" }
        is ListTermImpl -> of(one.asList, (other as ListTermImpl).asList) + differences(one.tail, other.tail)
        is Literal -> literalDifferences(one, other as Literal)
        else -> if (one == other) emptyList() else listOf("$one, not $other")
    }
}

private fun literalDifferences(one: Literal, other: Literal): List<String> {
    val own = when (one) {
        is UnnamedVar -> if (one.myId == (other as UnnamedVar).myId) emptyList() else listOf("number of $one")
        is Rule -> differences(one.body, (other as Rule).body) + if (one.isTerm == other.isTerm) emptyList() else listOf("term of $one")
        else -> emptyList()
    }
    val named = if (one.functor == other.functor && one.negated() == other.negated()) emptyList() else listOf("$one, not $other")
    return own + named + differences(one.ns, other.ns) + of(one.terms.orEmpty(), other.terms.orEmpty()) +
        differences(one.annots.takeIf { one.hasAnnot() }, other.annots.takeIf { other.hasAnnot() })
}

private fun of(one: List<Term>, other: List<Term>): List<String> =
    if (one.size != other.size) listOf("$one, not $other") else one.zip(other).flatMap { (a, b) -> differences(a, b) }

/**
 * Returns the class of [term]. Jason's anonymous class for an annotation behaves like a literal, so for it returns the class of literals.
 */
private fun classOf(term: Any): Class<*> = if (term is Pred && term.javaClass.isAnonymousClass) LiteralImpl::class.java else term.javaClass
