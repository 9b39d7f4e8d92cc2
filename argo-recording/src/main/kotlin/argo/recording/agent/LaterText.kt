package argo.recording.agent

import jason.asSyntax.ListTerm
import jason.asSyntax.Literal
import jason.asSyntax.MapTerm
import jason.asSyntax.ObjectTerm
import jason.asSyntax.PlanBody
import jason.asSyntax.SetTerm
import jason.asSyntax.Term
import jason.asSyntax.VarTerm

/**
 * Returns a function that makes the [text] of [terms] later, on any thread. If the terms may change, makes the text at once. This is so if
 * [mayChange] is true, or if a term contains a map, a set or a Java object, which Jason never copies.
 */
internal fun <T> laterText(terms: List<Term?>, mayChange: Boolean = false, text: () -> T): () -> T =
    if (mayChange || terms.any(::changes)) text().let { { it } } else text

private fun changes(term: Term?): Boolean = when (term) {
    is VarTerm -> false // checked first, since a variable is also a term of each other kind
    is ObjectTerm, is MapTerm, is SetTerm -> true
    is PlanBody -> changes(term.bodyTerm) || changes(term.bodyNext)
    is ListTerm -> term.asList.any(::changes)
    is Literal -> (0 until term.arity).any { changes(term.getTerm(it)) } || term.hasAnnot() && changes(term.annots)
    else -> false
}
