package argo.debug

import jason.NoValueException
import jason.asSemantics.Agent
import jason.asSemantics.Unifier
import jason.asSyntax.ASSyntax
import jason.asSyntax.LogicalFormula
import jason.asSyntax.NumberTerm
import jason.asSyntax.Structure
import jason.asSyntax.Term
import jason.asSyntax.VarTerm
import jason.asSyntax.parser.ParseException
import jason.asSyntax.parser.TokenMgrError

/**
 * Evaluates [expression] for [agent]. Returns the value of a variable or an arithmetic expression, or the solutions of a formula as in a
 * plan's context. Call this function on the agent's thread.
 *
 * @param un the values of a plan's variables; null if there is no plan
 * @throws DebugException if [expression] is none of these, or contains an internal action
 */
internal fun valueOf(expression: String, agent: Agent, un: Unifier?): String {
    val known = un?.clone() ?: Unifier()
    val term = parsed(expression) { ASSyntax.parseFormula(it) }
    return when {
        term is VarTerm -> known.get(term)?.let { "${it.capply(known)}" } ?: "no value"
        term is NumberTerm -> numberOf(term.capply(known))
        else -> solutions(requirePure(term), expression, agent, known)
    }
}

private fun numberOf(term: Term) = try {
    "${ASSyntax.createNumber((term as NumberTerm).solve())}"
} catch (without: NoValueException) {
    throw DebugException(without.message.orEmpty())
}

private fun solutions(formula: LogicalFormula, expression: String, agent: Agent, un: Unifier): String {
    val names = VARIABLE.findAll(expression).map { it.value }.distinct().filter { un.get(it) == null }.toList()
    val found = formula.logicalConsequence(agent, un).asSequence().take(MOST + 1).toList()
    val texts = found.take(MOST).map { names.joinToString(", ") { name -> "$name = ${it.get(name)?.capply(it) ?: "_"}" } }
    return when {
        found.isEmpty() -> "false"
        names.isEmpty() -> "true"
        else -> texts.distinct().joinToString("; ") + if (found.size > MOST) "; …" else ""
    }
}

/** Refuses internal actions, since they may act, and since their results would be missing in a recording. */
private fun requirePure(formula: LogicalFormula): LogicalFormula {
    val action = actionIn(formula) ?: return formula
    throw DebugException("$action is an internal action, which may act; ask for beliefs, such as dist(front,X) & X < 40")
}

private fun actionIn(term: Term): Term? =
    term.takeIf { it.isInternalAction } ?: (term as? Structure)?.takeIf { it.hasTerm() }?.terms?.firstNotNullOfOrNull(::actionIn)

private inline fun <T> parsed(text: String, parse: (String) -> T): T = try {
    parse(text)
} catch (wrong: ParseException) {
    throw unreadable(text, wrong)
} catch (wrong: TokenMgrError) {
    throw unreadable(text, wrong)
}

private fun unreadable(text: String, wrong: Throwable) =
    DebugException("$text is no formula, such as dist(front,X) & X < 40: ${wrong.message.orEmpty().lineSequence().first()}")

private val VARIABLE = Regex("""\b[A-Z]\w*""")

/** The largest number of solutions that are shown. */
private const val MOST = 20
