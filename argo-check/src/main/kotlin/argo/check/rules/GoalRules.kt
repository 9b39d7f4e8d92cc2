package argo.check.rules

import argo.check.project.Mention
import argo.check.project.Role

/** Finds goals without a plan, and plans for goals that nothing posts. */
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
        val others = handled.map { it.functor }.toSet() + scene.facts.postedOften + if (scene.hasUnknownPlans) OF_JASON else emptySet()
        val names = SimilarNames(others)
        val indicators = handled.map { it.literal.indicator }.toSet()
        val arities = aritiesIn(handled)
        for (goal in scene.program.mentions[Role.POSTED]) {
            if (goal.literal.indicator in indicators) continue
            val handledWith = arities[goal.functor]
            val meant = names.near(goal.functor)
            val isKnown = scene.isAgent && !scene.hasUnknownPlans && scene.program.program.errors.isEmpty()
            val what = "no plan is for the goal ${goal.literal.indicator}"
            val why = "the plan that posts it fails there with error(no_relevant)"
            when {
                handledWith != null -> report.warning("goal-arity", goal.span, "$what: the plans are for ${forms(goal, handledWith)}", why,
                    "correct the arguments")
                meant != null -> report.warning("goal-without-plan", goal.span, what, why, "did you mean $meant?")
                isKnown -> report.warning("goal-without-plan", goal.span, what, why, "write a plan +!${goal.functor}, or remove the goal")
            }
        }
    }

    private fun sentWithoutPlan(scene: Scene, report: Report) {
        val handled = scene.facts.often(Role.HANDLED).keys
        report.slips("goal-without-plan", scene.program.mentions[Role.SENT_GOAL], handled, scene, "the receiver fails") {
            "no agent of the project has a plan for ${it.literal.indicator}"
        }
    }

    private fun namedWithoutPlan(scene: Scene, report: Report) {
        val goals = scene.mentions(Role.HANDLED, Role.POSTED, Role.FAILURE_HANDLED).map { it.functor }.toSet()
        report.slips("goal-unknown", scene.program.mentions[Role.NAMED_GOAL], goals, scene, "this has no effect") {
            "the agent has no goal ${it.literal.indicator}"
        }
    }

    private fun withoutCause(scene: Scene, report: Report) {
        if (scene.isOpen(Role.POSTED, Role.SENT_GOAL)) return
        val posted = scene.mentions(Role.POSTED, Role.SENT_GOAL)
        val indicators = posted.map { it.literal.indicator }.toSet()
        val arities = aritiesIn(posted)
        val names = posted.map { it.functor }.toSet() + USUAL + if (scene.facts.isOfJaCaMo) scene.project.operations else emptySet()
        val plans = scene.mentions(Role.HANDLED).groupingBy { it.functor }.eachCount()
        val namesOfMore = HashMap<Int, SimilarNames>()
        for (plan in scene.program.mentions[Role.HANDLED] + scene.program.mentions[Role.FAILURE_HANDLED]) {
            if (plan.literal.indicator in indicators || scene.isKnownElsewhere(plan)) continue
            val others = plans.getOrDefault(plan.functor, 0) - if (plan.role == Role.HANDLED) 1 else 0
            val meant = namesOfMore.getOrPut(others) { SimilarNames(names + plans.filter { it.value > others }.keys) }.near(plan.functor)
            val postedWith = arities[plan.functor]
            val what = "nothing in the project posts the goal ${plan.literal.indicator}"
            val why = "this plan is never used, unless a message from elsewhere posts the goal"
            when {
                postedWith != null ->
                    report.warning("plan-arity", plan.span, "$what, only ${forms(plan, postedWith)}", why, "correct the arguments")
                meant != null -> report.warning("plan-without-cause", plan.span, what, why, "did you mean $meant?")
                scene.isClosed && plan.span.start !in scene.program.goalsOfTests ->
                    report.hint("plan-without-cause", plan.span, what, why, "post the goal, or remove the plan")
            }
        }
    }

    /** A goal of [OF_JASON] whose arguments may have any order. */
    const val SYMMETRIC = "assert_equals"

    /** Goals of the test plans in Jason's jar. */
    val OF_JASON = setOf(SYMMETRIC, "assert_true", "assert_false", "assert_contains", "force_pass", "force_failure")

    /** Goals that usually come from outside the project. */
    private val USUAL = setOf("start", "kqml_received")

    fun aritiesIn(mentions: List<Mention>): Map<String, List<Int>> =
        mentions.groupBy({ it.functor }, { it.arity }).mapValues { (_, all) -> all.distinct() }

    fun forms(mention: Mention, arities: List<Int>) = arities.sorted().joinToString(" and ") { "${mention.functor}/$it" }
}
