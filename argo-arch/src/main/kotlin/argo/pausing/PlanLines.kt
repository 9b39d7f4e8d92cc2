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

/** A line at which an agent can be paused: the line of a trigger or a step of [plan]. [number] is its index among the lines of [plan]. */
private class PlanLine(val plan: Plan, val number: Int, val text: String, val place: SourceLine)

/**
 * The lines of an agent's plans at which it can be paused: the lines of triggers and of steps. An object keeps its lines when plans are
 * exchanged. Any thread may call the functions.
 */
internal class PlanLines(agent: Agent) {
    private val lines = Plans.of(agent).copy().flatMap(::linesOf)
    private val plans: Set<Plan> = lines.mapTo(Collections.newSetFromMap(IdentityHashMap())) { it.plan }
    private val source = agent.aslSrc

    /** The names, without folders, of the files with these lines. The file of Jason's own plans for messages is left out. */
    val files: Set<String> get() = lines.mapTo(LinkedHashSet()) { File(it.place.file).name } - "kqmlPlans.asl"

    fun has(file: String): Boolean = lines.any { isSameFile(it.place.file, file) }

    /** Returns the first of these lines that is in [file], at or after [line]; null if there is none. */
    fun from(file: String, line: Int): Int? = of(file).filter { it.place.line >= line }.minOfOrNull { it.place.line }

    /** Returns the time at which [file] was last saved; null if it is not on a disk. */
    fun savedAt(file: String): FileTime? = (of(file).map { it.place.file } + listOfNotNull(source)).distinct()
        .filter { isSameFile(it, file) }.mapNotNull(::pathOf).filter { it.isRegularFile() }
        .maxOfOrNull { it.getLastModifiedTime() }

    /**
     * Returns the line to which the trigger or step at [line] of [file] has moved. [now] are the lines after an exchange. Searches the plan
     * of [line]. If this plan is gone, searches the most similar new plan for its goal or belief. Returns null if no new plan is similar.
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

/** Returns the steps of [body], and the steps inside its loops and conditions. */
private fun stepsIn(body: PlanBody?): List<PlanBody> =
    generateSequence(body) { it.bodyNext }.filterNot { it.isEmptyBody }.flatMap { listOf(it) + within(it.bodyTerm) }.toList()

private fun within(term: Term?): List<PlanBody> = when {
    term is PlanBody -> stepsIn(term)
    term is ListTermImpl -> term.asList.flatMap(::within) // for a list, term.terms would make Jason log a warning
    term is Structure -> term.terms.orEmpty().flatMap(::within) // a trigger's list of terms is null
    else -> emptyList()
}

/** A variable without a name. Each reading gives it another number. */
private val UNNAMED = Regex("""\b_\d+\w*""")
