package argo.check.rules

import argo.check.syntax.Belief
import argo.check.syntax.ListTerm
import argo.check.syntax.Literal
import argo.check.syntax.Node
import argo.check.syntax.Term
import argo.check.syntax.Variable
import argo.check.syntax.clauses
import argo.check.syntax.withDescendants

/** Finds variables that a plan or rule mentions only once, and variables that an internal action reads before they have a value. */
internal object VariableRules : Rule {
    override fun check(scene: Scene, report: Report) {
        scene.program.program.components.flatMap(::clauses).filterNot { it is Belief && it.condition == null }.forEach { scope(it, report) }
    }

    private fun scope(scope: Node, report: Report) {
        val variables = scope.withDescendants().filterIsInstance<Variable>().toList()
        val often = variables.groupingBy { it.name.text }.eachCount()
        val unbound = unboundInputs(scope, variables)
        val names by lazy { SimilarNames(often.keys.filter { it.length >= LONG && it[0] != '_' }) }
        for (variable in variables) {
            val name = variable.name.text
            val isOnce = often.getValue(name) == 1 && !name.startsWith("_")
            val meant = if (isOnce && name.length >= LONG) names.near(name) else null
            val reader = unbound[variable]
            when {
                meant != null -> report.warning("variable-once", variable.name.span, "the variable $name occurs once here", WHY,
                    "did you mean $meant?")
                reader != null -> report.warning("variable-unbound", variable.name.span,
                    "$name has no value yet, and ${reader.name} needs one", "the plan fails there",
                    "bind it before, or correct the order of the arguments")
                isOnce -> report.hint("variable-once", variable.name.span, "the variable $name occurs once here", WHY,
                    "write _ if that is meant")
            }
        }
    }

    /** Returns the variables that first occur as an input of an internal action, with that action. */
    private fun unboundInputs(scope: Node, variables: List<Variable>): Map<Variable, Literal> {
        val first = variables.distinctBy { it.name.text }.toSet()
        return scope.withDescendants().filterIsInstance<Literal>().flatMap { call ->
            val inputs = InternalAction.of(call)?.inputs.orEmpty()
            call.arguments.filterIndexed { index, _ -> index in inputs }.flatMap(::members).filter { it in first }
                .map { it as Variable to call }
        }.toMap()
    }

    private fun members(argument: Term): List<Term> = if (argument is ListTerm) argument.items + argument else listOf(argument)

    private const val WHY = "it is bound for nothing, or unbound where it is used"

    /** Shorter names often resemble others by chance. */
    private const val LONG = 4
}
