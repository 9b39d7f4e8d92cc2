package argo.check.rules

import argo.check.syntax.Belief
import argo.check.syntax.Directive
import argo.check.syntax.Node
import argo.check.syntax.Plan
import argo.check.syntax.Variable
import argo.check.syntax.withDescendants

/** Variables that a plan or a rule mentions once. */
internal object VariableRules : Rule {
    override fun check(scene: Scene, report: Report) {
        scene.program.program.components.flatMap(::scopes).forEach { scope(it, report) }
    }

    /** Returns the plans and rules in [node]. Each plan and each rule binds variables of its own. */
    private fun scopes(node: Node): List<Node> = when (node) {
        is Directive -> node.components.orEmpty().flatMap(::scopes)
        is Plan -> listOf(node)
        is Belief -> if (node.condition == null) emptyList() else listOf(node)
        else -> emptyList()
    }

    private fun scope(scope: Node, report: Report) {
        val variables = scope.withDescendants().filterIsInstance<Variable>().toList()
        val often = variables.groupingBy { it.name.text }.eachCount()
        for (variable in variables) {
            val name = variable.name.text
            if (name.startsWith("_") || often.getValue(name) > 1) continue
            val meant = Names.near(name, often.keys.filter { it.length >= LONG && it[0] != '_' }).takeIf { name.length >= LONG }
            val what = "the variable $name occurs once here"
            if (meant != null) {
                report.warning("variable-once", variable.name.span, what, "it is bound for nothing, or unbound where it is used",
                    "did you mean $meant?")
            } else {
                report.hint("variable-once", variable.name.span, what, "it is bound for nothing, or unbound where it is used",
                    "write _ if that is meant")
            }
        }
    }

    /** Shorter names are alike by chance. */
    private const val LONG = 4
}
