package argo.pausing

import argo.observing.SourceLine
import argo.observing.placeOf
import argo.platform.Plans
import argo.platform.isSameFile
import argo.platform.pathOf
import jason.asSemantics.Agent
import jason.asSyntax.ListTermImpl
import jason.asSyntax.Plan
import jason.asSyntax.PlanBody
import jason.asSyntax.Structure
import jason.asSyntax.Term
import java.io.File
import java.nio.file.attribute.FileTime
import java.util.Collections
import java.util.IdentityHashMap
import kotlin.io.path.getLastModifiedTime
import kotlin.io.path.isRegularFile
import kotlin.math.abs

/** A line at which an agent can be paused: that of the trigger of [plan], or that of the step with this [number]. */
private class PlanLine(val plan: Plan, val number: Int, val text: String, val place: SourceLine)

/**
 * The lines of an agent's plans at which it can be paused: the lines of triggers and of steps. They stay as they are when the plans are
 * exchanged. Any thread may call.
 */
internal class PlanLines(agent: Agent) {
    private val lines = Plans.of(agent).copy().flatMap(::linesOf)
    private val plans: Set<Plan> = lines.mapTo(Collections.newSetFromMap(IdentityHashMap())) { it.plan }
    private val source = agent.aslSrc

    /** The last part of the name of each file with such lines, except the file of Jason's own plans for messages. */
    val files: Set<String> get() = lines.mapTo(LinkedHashSet()) { File(it.place.file).name } - "kqmlPlans.asl"

    fun has(file: String): Boolean = lines.any { isSameFile(it.place.file, file) }

    /** Returns the first line of [file] from [line] on; null: there is none. */
    fun from(file: String, line: Int): Int? = of(file).filter { it.place.line >= line }.minOfOrNull { it.place.line }

    /** Returns the time at which [file] was saved; null: it is not on a disk. */
    fun savedAt(file: String): FileTime? = (of(file).map { it.place.file } + listOfNotNull(source)).distinct()
        .filter { isSameFile(it, file) }.mapNotNull(::pathOf).filter { it.isRegularFile() }
        .maxOfOrNull { it.getLastModifiedTime() }

    /**
     * Finds the part of a plan at [line] of [file] among the lines of an exchanged program, [now], and returns its line there: in the same
     * plan, or in the most similar one that has come in its place; null: there is none.
     */
    fun moved(file: String, line: Int, now: PlanLines): Int? {
        val part = of(file).find { it.place.line == line } ?: return now.from(file, line)
        val before = lines.filter { it.plan === part.plan }
        val plan = if (part.plan in now.plans) part.plan else now.successor(part.plan, before, plans) ?: return null
        val its = now.lines.filter { it.plan === plan }
        val same = its.filter { it.text == part.text }.minByOrNull { abs(it.number - part.number) }
        return (same ?: its.getOrNull(part.number) ?: its.last()).place.line
    }

    private fun successor(gone: Plan, its: List<PlanLine>, before: Set<Plan>): Plan? {
        val texts = its.map { it.text }
        val candidates = of(its.first().place.file).filter { it.plan !in before && isCalledAlike(it.plan, gone) }
        return candidates.groupBy { it.plan.label }.values.maxByOrNull { those -> those.count { it.text in texts } }?.first()?.plan
    }

    private fun of(file: String) = lines.filter { isSameFile(it.place.file, file) }
}

private fun isCalledAlike(one: Plan, other: Plan) = one.trigger.run {
    operator == other.trigger.operator && type == other.trigger.type && literal.functor == other.trigger.literal.functor
}

private fun linesOf(plan: Plan): List<PlanLine> {
    val trigger = placeOf(plan)?.let { "${plan.trigger} : ${plan.context}" to it }
    val steps = stepsIn(plan.body).mapNotNull { step -> placeOf(step, plan)?.let { "${step.bodyTerm}" to it } }
    return (listOfNotNull(trigger) + steps)
        .mapIndexed { number, (text, place) -> PlanLine(plan, number, text.replace(UNNAMED, "_"), place) }
}

/** Returns the steps of [body] and those in its loops and conditions. */
private fun stepsIn(body: PlanBody?): List<PlanBody> =
    generateSequence(body) { it.bodyNext }.filterNot { it.isEmptyBody }.flatMap { listOf(it) + within(it.bodyTerm) }.toList()

private fun within(term: Term?): List<PlanBody> = when {
    term is PlanBody -> stepsIn(term)
    term is ListTermImpl -> term.asList.flatMap(::within) // Jason logs a warning when the terms of a list are asked for
    term is Structure -> term.terms.orEmpty().flatMap(::within) // an event has terms, but no list of them
    else -> emptyList()
}

/** A variable without a name, whose number differs with each reading. */
private val UNNAMED = Regex("""\b_\d+\w*""")
