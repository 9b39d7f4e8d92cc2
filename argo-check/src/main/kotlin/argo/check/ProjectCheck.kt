package argo.check

import argo.check.findings.Finding
import argo.check.findings.ignoredLines
import argo.check.project.AgentProgram
import argo.check.project.Project
import argo.check.rules.ActionRules
import argo.check.rules.ArgoCallRules
import argo.check.rules.ArgumentOrderRules
import argo.check.rules.BeliefRules
import argo.check.rules.Facts
import argo.check.rules.FilterRules
import argo.check.rules.GoalRules
import argo.check.rules.InternalActionRules
import argo.check.rules.PlanOrderRules
import argo.check.rules.ProjectFileRules
import argo.check.rules.Report
import argo.check.rules.RequiredArgumentRules
import argo.check.rules.RobotRules
import argo.check.rules.Rule
import argo.check.rules.Scene
import argo.check.rules.SingleNameRules
import argo.check.rules.SyntaxRules
import argo.check.rules.VariableKindRules
import argo.check.rules.VariableRules

/** Checks [project] without running it. Not safe for use by several threads at once. */
class ProjectCheck(private val project: Project) {
    private val facts by lazy { Facts(project) }

    /** Returns the findings in all files, programs first. Findings in a program have the order of its text. */
    fun findings(): List<Finding> = project.programs.values.flatMap(::findingsIn) + findingsInFiles()

    /** Returns the findings in project files, filters and percept files. */
    fun findingsInFiles(): List<Finding> =
        ProjectFileRules.check(project) + FilterRules.check(project) + ProjectFileRules.left(project)

    /** Returns the findings in [program] in the order of its text. [program] must belong to the project. */
    fun findingsIn(program: AgentProgram): List<Finding> {
        val report = Report(program::place)
        val scene = Scene(facts, program)
        RULES.forEach { it.check(scene, report) }
        val ignored = ignoredLines(program.program)
        return report.findings.filterNot { it.place.begin.line in ignored }.distinct().sortedBy { it.place.begin }
    }

    private companion object {
        val RULES: List<Rule> = listOf(
            SyntaxRules, GoalRules, BeliefRules, VariableRules, InternalActionRules, ActionRules, PlanOrderRules, ArgumentOrderRules,
            VariableKindRules, RequiredArgumentRules, ArgoCallRules, FilterRules, RobotRules, SingleNameRules,
        )
    }
}
