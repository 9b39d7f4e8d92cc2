package argo.check.rules

import argo.check.project.Mention
import argo.check.project.Role
import argo.check.syntax.Belief
import argo.check.syntax.EventKind
import argo.check.syntax.ListTerm
import argo.check.syntax.Literal
import argo.check.syntax.Node
import argo.check.syntax.Operation
import argo.check.syntax.Plan
import argo.check.syntax.Term
import argo.check.syntax.Variable
import argo.check.syntax.withDescendants

/**
 * Finds arguments that need a value. An argument needs a value if all plans for the goal, or all rules for the literal, compare it,
 * calculate with it or require a list.
 *
 * @param clauses the plans, beliefs and rules of a project
 * @param believed for each indicator of a literal, the number of its additions, tells and rule heads
 */
internal class RequiredArguments(clauses: List<Node>, believed: Map<String, Int>) {
    private val ofGoals = common(
        clauses.filterIsInstance<Plan>().filter { it.trigger.kind == EventKind.ACHIEVE && it.trigger.operator == "+" }
            .mapNotNull { plan -> (plan.trigger.term as? Literal)?.let { it to plan.context } },
    ) { true }

    private val ofRules = common(
        clauses.filterIsInstance<Belief>().mapNotNull { rule -> (rule.head as? Literal)?.let { it to rule.condition } },
    ) {
        it.size == believed[it.first().first.indicator] && it.any { (_, condition) -> condition != null }
    }

    /** Returns the indices, counted from 0, of the arguments of [use] that need a value. */
    fun of(use: Mention): Set<Int> = when (use.role) {
        Role.POSTED -> ofGoals[use.literal.indicator]
        Role.READ -> ofRules[use.literal.indicator]
        else -> null
    }.orEmpty()

    private fun common(heads: List<Pair<Literal, Term?>>, areAll: (List<Pair<Literal, Term?>>) -> Boolean): Map<String, Set<Int>> =
        heads.groupBy { it.first.indicator }.filterValues(areAll).mapValues { (_, same) -> comparedOf(same) + listOf(same) }

    private fun comparedOf(same: List<Pair<Literal, Term?>>): Set<Int> = same.map { (head, condition) ->
        val compared = condition?.let(::comparedIn).orEmpty()
        indicesOf(head) { it is Variable && it.name.text in compared }
    }.reduce(Set<Int>::intersect)

    /**
     * Returns the argument that is a list in all plans. Returns nothing if there are several, since a plan may make one list from another.
     */
    private fun listOf(same: List<Pair<Literal, Term?>>): Set<Int> =
        same.map { (head, _) -> indicesOf(head) { it is ListTerm } }.reduce(Set<Int>::intersect).takeIf { it.size == 1 }.orEmpty()

    private fun indicesOf(head: Literal, isWanted: (Term) -> Boolean): Set<Int> =
        head.arguments.indices.filter { isWanted(head.arguments[it]) }.toSet()

    /** Returns the variables that [condition] compares or calculates with before they have a value. */
    private fun comparedIn(condition: Term): Set<String> {
        val bound = HashSet<String>()
        val compared = HashSet<String>()
        for (node in condition.withDescendants()) {
            when {
                node is Operation && node.isOf("|") -> return emptySet()
                node is Operation && isComparison(node) -> compared += variablesOf(node) - bound
                node is Literal || node is Operation && node.isOf("=") -> bound += variablesOf(node)
            }
        }
        return compared
    }

    private fun isComparison(node: Operation) = node.isArithmetic || node.operators.all { it.text in COMPARISONS }

    private fun variablesOf(node: Node) = node.withDescendants().filterIsInstance<Variable>().map { it.name.text }.toSet()

    private companion object {
        val COMPARISONS = setOf("<", "<=", ">", ">=", "==", "\\==")
    }
}
