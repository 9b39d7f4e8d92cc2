package argo.pausing

import argo.observing.SourceLine
import argo.observing.placeOf
import argo.platform.Plans
import argo.platform.isSameFile
import jason.asSemantics.Agent
import jason.asSyntax.Plan
import jason.asSyntax.PlanBody
import jason.asSyntax.Structure
import jason.asSyntax.Term
import java.io.File

/** The lines of an agent's plans at which it can stand: the lines of triggers and of steps. Any thread may call. */
internal class PlanLines(agent: Agent) {
    private val lines = Plans.of(agent).copy().flatMap(::linesOf).distinct()

    /** The last part of the name of each file with such lines, except the file of Jason's own plans for messages. */
    val files: Set<String> get() = lines.mapTo(LinkedHashSet()) { File(it.file).name } - "kqmlPlans.asl"

    fun has(file: String): Boolean = lines.any { isSameFile(it.file, file) }

    /** Returns the first line of [file] from [line] on; null: there is none. */
    fun from(file: String, line: Int): Int? = lines.filter { it.line >= line && isSameFile(it.file, file) }.minOfOrNull { it.line }
}

private fun linesOf(plan: Plan): List<SourceLine> = listOfNotNull(placeOf(plan)) + stepsIn(plan.body).mapNotNull { placeOf(it, plan) }

/** Returns the steps of [body] and those in its loops and conditions. */
private fun stepsIn(body: PlanBody?): List<PlanBody> =
    generateSequence(body) { it.bodyNext }.filterNot { it.isEmptyBody }.flatMap { listOf(it) + within(it.bodyTerm) }.toList()

private fun within(term: Term?): List<PlanBody> = when {
    term is PlanBody -> stepsIn(term)
    term is Structure && term.hasTerm() -> term.terms.flatMap(::within)
    else -> emptyList()
}
