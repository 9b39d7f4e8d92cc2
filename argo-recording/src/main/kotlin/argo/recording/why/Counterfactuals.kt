package argo.recording.why

import argo.recording.agent.literalOf
import argo.recording.agent.termOf
import jason.asSyntax.Literal
import jason.asSyntax.NumberTerm
import jason.asSyntax.NumberTermImpl
import java.math.BigDecimal
import kotlin.math.abs

/**
 * Finds other numbers for the percepts of [cause] by trials. Searches for the nearest numbers with which the agent would not have sent the
 * command. [had] replays the agent with another percept in place of a percept of the cause.
 */
internal class Counterfactuals(private val cause: StepCause, private val had: (Literal, PerceptCause) -> Had?) {
    private var tries = 0

    /** Returns the nearest value found for each percept with a number that a condition compares. */
    fun find(): List<Had> = cause.percepts().filter { !it.isGone && it.frame != null }.mapNotNull(::flipped)

    private fun flipped(percept: PerceptCause): Had? {
        val literal = literalOf(percept.belief)
        return candidates(literal).firstNotNullOfOrNull { candidate ->
            if (tries++ >= MAX_TRIES) null else had(candidate, percept)?.takeIf { !it.isSent }
        }
    }

    private fun candidates(literal: Literal): List<Literal> = (0 until literal.arity).flatMap { place ->
        val number = (literal.getTerm(place) as? NumberTerm)?.solve() ?: return@flatMap emptyList()
        limits.filter { (one, _) -> one == number }.flatMap { (_, limit) -> around(limit) }.filter { it != number }
            .map { it to place }
    }.distinct().sortedBy { (value, place) -> abs(value - (literal.getTerm(place) as NumberTerm).solve()) }
        .map { (value, place) -> literal.copy().apply { setTerm(place, NumberTermImpl(value)) } }

    /** The pairs of numbers that the conditions of the command's plans compare, each in both orders. */
    private val limits = conditions(cause).flatMap { comparedIn(it.value) }.distinct()

    private fun conditions(of: Cause): List<Condition> = when (of) {
        is StepCause -> of.tests
        is PlanCause -> of.conditions
        else -> emptyList()
    }.let { found -> found + of.causes.flatMap(::conditions) }

    private fun comparedIn(value: String): List<Pair<Double, Double>> {
        val sides = value.split(COMPARISON).takeIf { it.size == 2 } ?: return emptyList()
        val (left, right) = sides.map { numberOf(it) ?: return emptyList() }
        return listOf(left to right, right to left)
    }

    private fun numberOf(text: String): Double? = try {
        (termOf(text.trim()) as? NumberTerm)?.takeIf { it.isGround }?.solve()
    } catch (_: IllegalArgumentException) {
        null
    } catch (_: RuntimeException) {
        null // the formula adds terms that are no numbers
    }

    private fun around(limit: Double): List<Double> {
        val exact = BigDecimal.valueOf(limit).stripTrailingZeros()
        val step = BigDecimal.ONE.movePointLeft(maxOf(exact.scale(), 0))
        return listOf(exact, exact + step, exact - step).map { it.toDouble() }
    }

    private companion object {
        const val MAX_TRIES = 12
        val COMPARISON = Regex("""\s*(?:<=|>=|\\==|==|<|>)\s*""")
    }
}
