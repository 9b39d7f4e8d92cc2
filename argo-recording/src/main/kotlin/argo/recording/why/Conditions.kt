package argo.recording.why

import argo.recording.replay.normal
import jason.JasonException
import jason.asSemantics.Agent
import jason.asSemantics.Unifier
import jason.asSyntax.InternalActionLiteral
import jason.asSyntax.Literal
import jason.asSyntax.LogExpr
import jason.asSyntax.LogicalFormula
import jason.asSyntax.RelExpr
import jason.asSyntax.Rule

/**
 * Splits formulas of the program of [agent] into their parts, and evaluates the parts by the agent's current beliefs.
 *
 * @param originOf returns the cause of a belief of the agent
 * @param goneOf returns why the agent believes nothing that unifies with a literal; empty if this is not known
 */
internal class Conditions(
    private val agent: Agent,
    private val originOf: (Literal) -> Cause,
    private val goneOf: (Literal) -> List<Cause>,
) {
    /** Returns the parts of [formula], which is true under [un]. */
    fun holding(formula: LogicalFormula, un: Unifier, depth: Int = 0): List<Condition> = when {
        formula is LogExpr && formula.op == LogExpr.LogicalOp.and -> holding(left(formula), un, depth) + holding(right(formula), un, depth)
        formula is LogExpr && formula.op == LogExpr.LogicalOp.or -> either(formula, un, depth)
        formula is LogExpr -> listOf(absent(formula, un))
        formula is InternalActionLiteral || formula is RelExpr || formula !is Literal || !formula.isLiteral ->
            listOf(Condition(shown(formula), valued(formula, un)))
        else -> listOf(believed(formula, un, depth))
    }

    /**
     * Returns the parts of [formula], which is false under [un], up to the first part that fails. If several solutions of the earlier parts
     * lead to a failure, uses the first few solutions.
     */
    fun failing(formula: LogicalFormula, un: Unifier): List<Condition> {
        var ways = listOf(un)
        val held = ArrayList<Condition>()
        for (part in parts(formula)) {
            val next = ways.flatMap { solutions(part, it) }.take(MAX_WAYS)
            if (next.isEmpty()) return held + ways.take(MAX_SHOWN).map { failed(part, it) }.distinct()
            held += holding(part, next.first())
            ways = next
        }
        return held
    }

    fun solution(formula: LogicalFormula, un: Unifier): Unifier? = solutions(formula, un).firstOrNull()

    private fun solutions(formula: LogicalFormula, un: Unifier): List<Unifier> = try {
        formula.logicalConsequence(agent, un.clone())?.asSequence()?.take(MAX_WAYS)?.toList().orEmpty()
    } catch (_: JasonException) {
        emptyList() // an internal action in the formula failed
    } catch (_: RuntimeException) {
        emptyList() // the formula compares terms without a value
    }

    private fun failed(part: LogicalFormula, un: Unifier): Condition {
        val negated = (part as? LogExpr)?.takeIf { it.op == LogExpr.LogicalOp.not }?.let(::left)
        val causes = if (negated == null) goneOf(part, un)
        else solution(negated, un)?.let { holding(negated, it) }.orEmpty().flatMap { it.causes }
        return Condition(shown(part), valued(part, un), false, causes)
    }

    private fun goneOf(part: LogicalFormula, un: Unifier): List<Cause> {
        if (part !is Literal || !part.isLiteral || part is InternalActionLiteral) return emptyList()
        return (part.capply(un) as? Literal)?.let(goneOf).orEmpty()
    }

    private fun either(formula: LogExpr, un: Unifier, depth: Int): List<Condition> {
        val way = listOf(left(formula), right(formula)).firstNotNullOfOrNull { side -> solution(side, un)?.let { side to it } }
        return way?.let { (side, found) -> holding(side, found, depth) } ?: listOf(Condition(shown(formula), valued(formula, un)))
    }

    private fun absent(formula: LogExpr, un: Unifier): Condition {
        val negated = left(formula)
        return Condition(shown(formula), valued(formula, un), true, goneOf(negated, un))
    }

    private fun believed(literal: Literal, un: Unifier, depth: Int): Condition {
        val applied = literal.capply(un) as Literal
        val candidates = agent.bb.getCandidateBeliefs(applied, un)?.asSequence().orEmpty().toList()
        for (belief in candidates) {
            val causes = when {
                belief is Rule -> byRule(belief, applied, depth)
                Unifier().unifies(applied, belief) -> listOf(originOf(belief))
                else -> null
            } ?: continue
            return Condition(shown(literal), if (belief is Rule) normal("$applied") else keyOf(belief), true, causes)
        }
        return Condition(shown(literal), normal("$applied"))
    }

    /** Returns the causes by which [applied] follows from [rule]; null if [applied] does not follow. */
    private fun byRule(rule: Rule, applied: Literal, depth: Int): List<Cause>? {
        val un = Unifier()
        if (!un.unifies(applied.copy().makeVarsAnnon(), rule.headClone())) return null
        val way = solution(rule.body, un) ?: return null
        if (depth >= MAX_RULES) return emptyList()
        return holding(rule.body, way, depth + 1).flatMap { it.causes }
    }

    private fun parts(formula: LogicalFormula): List<LogicalFormula> =
        if (formula is LogExpr && formula.op == LogExpr.LogicalOp.and) parts(left(formula)) + parts(right(formula)) else listOf(formula)

    private fun valued(formula: LogicalFormula, un: Unifier) = unquoted(normal("${formula.capply(un)}"))

    private fun shown(formula: LogicalFormula) = unquoted(normal("$formula"))

    /** Removes the brackets that Jason writes around each operation. */
    private fun unquoted(text: String) = when {
        text.startsWith("(") && text.endsWith(")") -> text.substring(1, text.length - 1)
        text.startsWith("not (") && text.endsWith(")") -> "not " + text.substring("not (".length, text.length - 1)
        else -> text
    }

    private fun left(formula: LogExpr) = formula.lhs as LogicalFormula

    private fun right(formula: LogExpr) = formula.rhs as LogicalFormula

    private companion object {
        const val MAX_WAYS = 100
        const val MAX_SHOWN = 3
        const val MAX_RULES = 8 // belief rules applied within each other
    }
}
