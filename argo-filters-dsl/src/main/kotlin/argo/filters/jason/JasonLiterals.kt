/** What filters see of Jason's terms. */
@file:JvmName("JasonLiterals")

package argo.filters.jason

import argo.filters.CriticalRule
import argo.filters.Predicate
import argo.filters.Syntax
import argo.filters.Value
import argo.filters.ValueReader
import argo.filters.matching.CompiledCondition
import argo.filters.matching.Explanation
import argo.filters.matching.FilterSession
import argo.filters.matching.PerceptForm
import argo.filters.matching.PerceptMatcher
import jason.asSyntax.ArithExpr
import jason.asSyntax.ArithFunctionTerm
import jason.asSyntax.BinaryStructure
import jason.asSyntax.CyclicTerm
import jason.asSyntax.InternalActionLiteral
import jason.asSyntax.ListTerm
import jason.asSyntax.Literal
import jason.asSyntax.NumberTerm
import jason.asSyntax.NumberTermImpl
import jason.asSyntax.Plan
import jason.asSyntax.PlanBody
import jason.asSyntax.Rule
import jason.asSyntax.StringTerm
import jason.asSyntax.Term
import jason.asSyntax.Trigger

/**
 * Whether the filter drops [percept]: the same decision as over the percept's text.
 *
 * [percept] is only read. Never throws. A literal that no text could stand for (a variable, say) is kept.
 */
fun PerceptMatcher.drops(percept: Literal): Boolean = LiteralForm.of(percept)?.let(::drops) ?: false

/** The critical rules that [percept] meets, in the order of the filter. */
fun PerceptMatcher.criticalRules(percept: Literal): List<CriticalRule> = LiteralForm.of(percept)?.let(::criticalRules).orEmpty()

/** Why the filter keeps or drops [percept]. */
fun PerceptMatcher.explain(percept: Literal): Explanation =
    LiteralForm.of(percept)?.let { Explanation.of(this, it) } ?: Explanation.noPercept(percept.toString(), filter)

/** A session over percepts that are Jason literals, as they come from a Jason environment; without a filter at first. */
fun literalSession(): FilterSession<Literal> = FilterSession(
    { LiteralForm.of(it) },
    { matcher, percept -> matcher.drops(percept) },
    { matcher, percept -> matcher.criticalRules(percept) },
)

/** A percept that is a Jason literal. */
internal class LiteralForm private constructor(private val literal: Literal, override val predicate: Predicate) : PerceptForm {
    override val arity: Int
        get() = literal.arity

    override fun meets(condition: CompiledCondition): Boolean = when {
        condition.argument >= arity -> false
        condition.argument >= 0 -> condition.meets(valueOf(literal.getTerm(condition.argument), 0))
        else -> literal.hasAnnot() && literal.annots.any { condition.meetsAnnotation(valueOf(it, 0)) }
    }

    override fun number(index: Int): Double? = (valueOf(literal.getTerm(index), 0) as? Value.Number)?.value

    override fun key(number: String): String = (0 until arity).joinToString(",", "$predicate(", ")") {
        val term = literal.getTerm(it)
        when (val value = valueOf(term, 0)) {
            null -> term.toString()
            is Value.Number -> number
            else -> value.toString()
        }
    }

    override fun toString(): String = literal.toString()

    companion object {
        fun of(literal: Literal): LiteralForm? = predicateOf(literal)?.let { LiteralForm(literal, it) }
    }
}

private fun predicateOf(literal: Literal): Predicate? {
    if (literal.isVar || literal.ns.isVar) return null
    return Predicate.ofOrNull(literal.functor, literal.negated(), literal.ns.functor)
}

/** The value that [term] is, or null for what has none: variables, expressions, plans, objects, strings that no text could hold. */
private fun valueOf(term: Term, depth: Int): Value? = when {
    depth > ValueReader.MAX_DEPTH || term.isVar -> null
    term is ListTerm -> list(term, depth)
    term is NumberTerm -> number(term)?.let(Value::Number)
    term is StringTerm -> term.string?.let(Value.Text::ofOrNull)
    term is Literal && isPlain(term) -> structure(term, depth)
    else -> null
}

/** Jason reads `-5` as an expression of one operand; expressions of two operands are no numbers to a filter. */
private fun number(term: Term): Double? = when {
    term is NumberTermImpl -> term.solve().takeUnless(Double::isNaN)
    term is ArithExpr && term.arity == 1 -> number(term.getTerm(0))?.let { if (term.functor == "-") -it else it }
    else -> null
}

private fun list(list: ListTerm, depth: Int): Value? {
    val items = ArrayList<Value>()
    var rest = list
    if (rest.isTail) return null
    while (!rest.isEmpty()) {
        items += valueOf(rest.term, depth + 1) ?: return null
        if (rest.isTail) return null
        rest = rest.next as ListTerm
    }
    return Value.Sequence(items)
}

private fun structure(literal: Literal, depth: Int): Value? {
    val predicate = predicateOf(literal) ?: return null
    if (Syntax.isDotted(literal.functor, 0, literal.functor.length)) return null
    val arguments = values(if (literal.hasTerm()) literal.terms else emptyList(), depth) ?: return null
    val annotations = values(if (literal.hasAnnot()) literal.annots else emptyList(), depth) ?: return null
    return Value.Structure(predicate, arguments, annotations.toSet())
}

private fun values(terms: List<Term>, depth: Int): List<Value>? = terms.map { valueOf(it, depth + 1) ?: return null }

private fun isPlain(literal: Literal) = when (literal) {
    is BinaryStructure, is ArithFunctionTerm, is InternalActionLiteral, is PlanBody, is Plan, is Trigger, is Rule, is CyclicTerm -> false
    else -> true
}
