package argo.check

import argo.check.findings.Finding
import argo.check.project.AgentProgram
import argo.check.project.Project
import argo.check.rules.ActionRules
import argo.check.rules.ArgoCallRules
import argo.check.rules.ArgumentOrderRules
import argo.check.rules.BeliefRules
import argo.check.rules.FilterRules
import argo.check.rules.GoalRules
import argo.check.rules.InternalActionRules
import argo.check.rules.PerceptFileRules
import argo.check.rules.PlanOrderRules
import argo.check.rules.ProjectFileRules
import argo.check.rules.Report
import argo.check.rules.RobotRules
import argo.check.rules.Rule
import argo.check.rules.Scene
import argo.check.rules.SyntaxRules
import argo.check.rules.VariableKindRules
import argo.check.rules.VariableRules

/** Checks a project's files without running anything. */
object ProjectCheck {
    private val RULES: List<Rule> = listOf(
        SyntaxRules, GoalRules, BeliefRules, VariableRules, InternalActionRules, ActionRules, PlanOrderRules, ArgumentOrderRules,
        VariableKindRules, ArgoCallRules, FilterRules,
        RobotRules,
    )

    /** Returns the findings in all files of [project]: programs first, the findings of each in the order of its text. */
    fun check(project: Project): List<Finding> = project.programs.values.flatMap { check(project, it) } + checkFiles(project)

    /** Returns the findings in the files of [project] that are not programs: project files, filters and descriptions of percepts. */
    fun checkFiles(project: Project): List<Finding> =
        ProjectFileRules.check(project) + FilterRules.check(project) + PerceptFileRules.check(project)

    /** Returns the findings in [program], a program of [project], in the order of its text. */
    fun check(project: Project, program: AgentProgram): List<Finding> {
        val report = Report(program::place)
        val scene = Scene(project, program)
        RULES.forEach { it.check(scene, report) }
        return report.findings.filterNot { program.isIgnored(it.place.begin.line) }.distinct().sortedBy { it.place.begin }
    }
}
