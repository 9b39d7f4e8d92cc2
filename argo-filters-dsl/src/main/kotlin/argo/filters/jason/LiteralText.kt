package argo.filters.jason

import argo.filters.GroundTerm
import argo.filters.GroundTermReader
import argo.filters.matching.FilterSession
import jason.asSyntax.ASSyntax
import jason.asSyntax.ArithExpr
import jason.asSyntax.ArithFunctionTerm
import jason.asSyntax.BinaryStructure
import jason.asSyntax.CyclicTerm
import jason.asSyntax.InternalActionLiteral
import jason.asSyntax.ListTerm
import jason.asSyntax.Literal
import jason.asSyntax.NumberTermImpl
import jason.asSyntax.Plan
import jason.asSyntax.PlanBody
import jason.asSyntax.Rule
import jason.asSyntax.StringTerm
import jason.asSyntax.Term
import jason.asSyntax.Trigger

/** Makes a session for percepts that are Jason literals, as from a Jason environment. The session begins without a filter. */
fun literalSession(): FilterSession<Literal> = FilterSession(::perceptText) { percept ->
    val annotation = ASSyntax.createAtom("smoothed")
    if (percept.hasAnnot(annotation)) percept else percept.copy().apply { addAnnot(annotation) }
}

/**
 * Returns the text of [percept] in the form that boards send, for filters. Never throws.
 *
 * Unlike `toString`, this function escapes quotes and line breaks in strings. If a term is nested too deep for filters, this function
 * writes a variable in place of the term.
 */
fun perceptText(percept: Literal): String = text(percept, 0)

private fun text(term: Term, depth: Int): String = when {
    depth > GroundTermReader.MAX_DEPTH -> NO_VALUE
    term.isVar -> term.toString() // first: in Jason, a variable is also a list, a string and a number
    term is StringTerm -> term.string?.let { "${GroundTerm.Text(it)}" } ?: NO_VALUE
    term is NumberTermImpl -> number(term.solve())
    term is ArithExpr && term.arity == 1 -> "(${term.functor}${text(term.getTerm(0), depth + 1)})"
    term is ListTerm -> if (term.tail == null) term.asList.joinToString(",", "[", "]") { text(it, depth + 1) } else NO_VALUE
    term is Literal && isPlain(term) -> structure(term, depth)
    else -> term.toString()
}

private fun number(number: Double) = if (number.isNaN()) NO_VALUE else GroundTerm.Number(number).toString()

private fun structure(literal: Literal, depth: Int): String = buildString {
    if (literal.ns != Literal.DefaultNS) append(literal.ns).append("::")
    if (literal.negated()) append('~')
    append(literal.functor)
    if (literal.hasTerm()) literal.terms.joinTo(this, ",", "(", ")") { text(it, depth + 1) }
    if (literal.hasAnnot()) literal.annots.asList.joinTo(this, ",", "[", "]") { text(it, depth + 1) }
}

private fun isPlain(literal: Literal) = when (literal) {
    is BinaryStructure, is ArithFunctionTerm, is InternalActionLiteral, is PlanBody, is Plan, is Trigger, is Rule, is CyclicTerm -> false
    else -> true
}

/** A variable, on which every condition is false. */
private const val NO_VALUE = "_"
