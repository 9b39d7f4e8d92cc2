package argo.check.rules

import argo.check.syntax.Directive
import argo.check.syntax.ListTerm
import argo.check.syntax.Literal
import argo.check.syntax.Plan
import argo.check.syntax.Variable

/** Finds plans that never run because an earlier plan for the event always applies. */
internal object PlanOrderRules : Rule {
    override fun check(scene: Scene, report: Report) {
        if (scene.agents.any { it.hasOwnClass }) return
        val components = scene.program.program.components.flatMap { if (it is Directive) it.components.orEmpty() else listOf(it) }
        val plans = components.filterIsInstance<Plan>()
        plans.filter { it.trigger.term is Literal }.groupBy(::eventOf).values.forEach { same ->
            val always = same.firstOrNull(::alwaysApplies) ?: return@forEach
            same.dropWhile { it !== always }.drop(1).forEach {
                val line = scene.program.program.lines.position(always.trigger.span.start).line
                report.warning(
                    "plan-unreachable", it.trigger.span, "the plan in line $line always applies to this event, and comes first",
                    "this plan is never used", "move it up, or give the other a context",
                )
            }
        }
    }

    private fun eventOf(plan: Plan): List<String> {
        val literal = plan.trigger.term as Literal
        return listOf(plan.trigger.operator, plan.trigger.kind.symbol, "${literal.isNegated}", literal.namespace?.toString().orEmpty(),
            literal.indicator)
    }

    private fun alwaysApplies(plan: Plan): Boolean {
        val literal = plan.trigger.term as Literal
        val variables = literal.arguments.map { it as? Variable ?: return false }.filterNot { it.name.text == "_" }
        val isAnyEvent = variables.distinctBy { it.name.text }.size == variables.size && literal.annotations == null &&
            variables.all { it.annotations == null }
        val isAnyContext = plan.context == null || plan.context is Literal && plan.context.functor == "true"
        return isAnyEvent && isAnyContext && plan.goalCondition == null && !hasAnnotations(plan.label?.annotations)
    }

    /** Returns true if there is an annotation other than `atomic`. Annotations other than `atomic` may change the order of plans. */
    private fun hasAnnotations(annotations: ListTerm?) = annotations?.items.orEmpty().any { (it as? Literal)?.functor != "atomic" }
}
