package argo.recording.agent

import argo.platform.Plans
import jason.asSemantics.Agent
import jason.asSyntax.Plan
import jason.asSyntax.PlanBody
import jason.asSyntax.Rule
import java.util.IdentityHashMap

/**
 * Numbers the plans, steps and rules in the program of [agent]. A program gets equal numbers at each reading. Make this object before the
 * agent's first cycle, since the agent may get other plans and rules later.
 */
internal class ProgramParts(val agent: Agent) {
    private val numbers = IdentityHashMap<Any, Int>()
    private val parts = ArrayList<Any>()

    val plans: List<Plan> = Plans.of(agent).all.toList()

    val rules: List<Rule> = agent.bb.filterIsInstance<Rule>()

    init {
        visit(Plans.of(agent))
        rules.forEach(::note)
    }

    private val places = plans.map { it.srcInfo }

    val size: Int get() = parts.size

    /** Removes plans from the program's parts if a reload has changed their lines. */
    fun forgetMoved() = plans.indices.filter { plans[it].srcInfo !== places[it] }.forEach { forget(plans[it]) }

    private fun forget(plan: Plan) {
        numbers -= plan
        generateSequence(plan.body) { it.bodyNext }.forEach(numbers::remove)
        Plans.within(plan)?.all?.forEach(::forget)
    }

    private fun visit(plans: Plans) {
        note(plans.library)
        for (plan in plans.all) {
            note(plan)
            generateSequence(plan.body) { it.bodyNext }.forEach(::note)
            Plans.within(plan)?.let(::visit)
        }
    }

    private fun note(part: Any) {
        if (numbers.putIfAbsent(part, parts.size) == null) parts += part
    }

    fun numberOf(part: Any): Int? = numbers[part]

    fun part(number: Int): Any = parts[number]

    fun hasPlans(): Boolean =
        Plans.of(agent).all.let { now -> now.size == plans.size && now.indices.all { now[it] === plans[it] && now[it] in numbers } }

    companion object {
        fun mayBePart(one: Any): Boolean = one is Plan || one is PlanBody || Plans.isLibrary(one) || one is Rule
    }
}
