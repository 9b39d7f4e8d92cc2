package argo.check.rules

import argo.check.project.Mention
import argo.check.project.Role
import argo.check.syntax.Component
import argo.check.syntax.Variable
import argo.check.syntax.clauses
import argo.check.syntax.withDescendants

/** Finds variables without a value in arguments of goals or rules that need a value: see [RequiredArguments]. */
internal object RequiredArgumentRules : Rule {
    override fun check(scene: Scene, report: Report) {
        scene.program.program.components.flatMap(::clauses).forEach { clause(it, scene, report) }
    }

    private fun clause(clause: Component, scene: Scene, report: Report) {
        val first by lazy { clause.withDescendants().filterIsInstance<Variable>().distinctBy { it.name.text }.toSet() }
        val areGoalsKnown = !scene.hasUnknownPlans && !scene.isOpen(Role.HANDLED)
        for (use in scene.program.mentions.within(clause.span)) {
            if (use.role == Role.POSTED && !areGoalsKnown) continue
            for (index in scene.facts.requiredArguments.of(use)) {
                val argument = use.literal.arguments[index]
                if (argument is Variable && argument in first && !argument.name.text.startsWith("_")) tell(use, index, argument, report)
            }
        }
    }

    private fun tell(use: Mention, index: Int, argument: Variable, report: Report) = report.warning(
        "variable-unbound", argument.span,
        "$argument has no value yet, and argument ${index + 1} of ${use.literal.indicator} needs one",
        "each of its ${if (use.role == Role.POSTED) "plans" else "rules"} compares it or takes it apart",
        "bind it before, or correct the order of the arguments",
    )
}
