/** The one place of this module that knows Jason's terms. */
@file:JvmName("JasonLiterals")

package argo.filters

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
 * [percept] is only read. Never throws.
 */
fun PerceptMatcher.drops(percept: Literal): Boolean {
    val predicate = predicateOf(percept) ?: return false
    return dropping(predicate) { condition ->
        when (condition) {
            is Condition.Argument -> condition.index < percept.arity && meets(condition.test, valueOf(percept.getTerm(condition.index), 0))
            is Condition.Annotation -> percept.hasAnnot() && percept.annots.any { meets(condition, valueOf(it, 0)) }
        }
    }
}

private fun predicateOf(literal: Literal): Predicate? {
    if (literal.isVar || literal.ns.isVar || !Syntax.isFunctor(literal.functor)) return null
    return Predicate(literal.functor, literal.negated(), literal.ns.functor)
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
