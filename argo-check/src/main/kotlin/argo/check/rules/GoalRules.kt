package argo.check.rules

import argo.check.project.Mention
import argo.check.project.Role

/** Goals that no plan handles, and plans for goals that nothing posts. */
internal object GoalRules : Rule {
    override fun check(scene: Scene, report: Report) {
        withoutPlan(scene, report)
        sentWithoutPlan(scene, report)
        namedWithoutPlan(scene, report)
        withoutCause(scene, report)
    }

    private fun withoutPlan(scene: Scene, report: Report) {
        if (scene.isOpen(Role.HANDLED)) return
        val handled = scene.mentions(Role.HANDLED, Role.FAILURE_HANDLED)
        val others = handled.map { it.functor }.toSet() + scene.postedOften + if (scene.hasUnknownPlans) OF_JASON else emptySet()
        val indicators = handled.map { it.literal.indicator }.toSet()
        for (goal in scene.program.mentions[Role.POSTED]) {
            if (goal.literal.indicator in indicators) continue
            val arities = handled.filter { it.functor == goal.functor }.map { it.arity }.distinct()
            val meant = Names.near(goal.functor, others)
            val isKnown = scene.isAgent && !scene.hasUnknownPlans && scene.program.program.errors.isEmpty()
            val what = "no plan is for the goal ${goal.literal.indicator}"
            val why = "the plan that posts it fails there with error(no_relevant)"
            when {
                arities.isNotEmpty() -> report.warning("goal-arity", goal.span, "$what: the plans are for ${forms(goal, arities)}", why,
                    "correct the arguments")
                meant != null -> report.warning("goal-without-plan", goal.span, what, why, "did you mean $meant?")
                isKnown -> report.warning("goal-without-plan", goal.span, what, why, "write a plan +!${goal.functor}, or remove the goal")
            }
        }
    }

    private fun sentWithoutPlan(scene: Scene, report: Report) {
        val handled = scene.everyMention(Role.HANDLED).map { it.functor }.toSet()
        for (goal in scene.program.mentions[Role.SENT_GOAL]) {
            if (goal.functor in handled || scene.isKnownElsewhere(goal)) continue
            val meant = Names.near(goal.functor, handled) ?: continue
            report.warning("goal-without-plan", goal.span, "no agent of the project has a plan for ${goal.literal.indicator}",
                "the receiver fails", "did you mean $meant?")
        }
    }

    private fun namedWithoutPlan(scene: Scene, report: Report) {
        val goals = scene.mentions(Role.HANDLED, Role.POSTED, Role.FAILURE_HANDLED).map { it.functor }.toSet()
        for (goal in scene.program.mentions[Role.NAMED_GOAL]) {
            if (goal.functor in goals || scene.isKnownElsewhere(goal)) continue
            val meant = Names.near(goal.functor, goals) ?: continue
            report.warning("goal-unknown", goal.span, "the agent has no goal ${goal.literal.indicator}", "this has no effect",
                "did you mean $meant?")
        }
    }

    private fun withoutCause(scene: Scene, report: Report) {
        if (scene.isOpen(Role.POSTED, Role.SENT_GOAL)) return
        val posted = scene.mentions(Role.POSTED, Role.SENT_GOAL)
        val indicators = posted.map { it.literal.indicator }.toSet()
        for (plan in scene.program.mentions[Role.HANDLED] + scene.program.mentions[Role.FAILURE_HANDLED]) {
            if (plan.literal.indicator in indicators || scene.isKnownElsewhere(plan)) continue
            val plans = scene.mentions(Role.HANDLED).filter { it !== plan }.groupingBy { it.functor }.eachCount()
            val more = plans.filter { it.value > plans.getOrDefault(plan.functor, 0) }.keys
            val meant = Names.near(plan.functor, posted.map { it.functor }.toSet() + more + USUAL)
            val others = posted.filter { it.functor == plan.functor }.map { it.arity }.distinct()
            val what = "nothing in the project posts the goal ${plan.literal.indicator}"
            val why = "this plan is never used, unless a message from elsewhere posts the goal"
            when {
                others.isNotEmpty() ->
                    report.warning("plan-arity", plan.span, "$what, only ${forms(plan, others)}", why, "correct the arguments")
                meant != null -> report.warning("plan-without-cause", plan.span, what, why, "did you mean $meant?")
            }
        }
    }

    /** Goals of the plans for tests that Jason's jar has for agents to include. */
    val OF_JASON = setOf("assert_equals", "assert_true", "assert_false", "assert_contains", "force_pass", "force_failure")

    /** Goals that come from elsewhere in many projects. */
    private val USUAL = setOf("start", "kqml_received")

    private fun forms(mention: Mention, arities: List<Int>) = arities.sorted().joinToString(" and ") { "${mention.functor}/$it" }
}
