package argo.check.rules

import argo.check.syntax.ListTerm
import argo.check.syntax.Literal
import argo.check.syntax.Node
import argo.check.syntax.NumberTerm
import argo.check.syntax.Operation
import argo.check.syntax.StringTerm
import argo.check.syntax.Term
import argo.check.syntax.Variable
import argo.check.syntax.withDescendants

/** Variables of two kinds of term in a plan. For example, an internal action needs a list, but the rest of the plan uses a number. */
internal object VariableKindRules : Rule {
    override fun check(scene: Scene, report: Report) = scene.program.program.components.forEach { component ->
        val uses = component.withDescendants().flatMap(::usesIn).toList().groupBy { it.variable }
        uses.values.forEach { same -> same.filter { it.call != null }.forEach { contradiction(it, same, report) } }
    }

    /** @property call the internal action that has [term] as an argument; null: the term stands elsewhere */
    private class Use(val variable: String, val kind: Char, val term: Term, val call: Literal?)

    private fun usesIn(node: Node): List<Use> = when {
        node is Literal && node.isInternal -> argumentsOf(node)
        node is ListTerm -> listOfNotNull(node.tail?.let { use(it, LIST) })
        node is Operation && node.operators.all { it.text in ARITHMETIC } -> node.operands.mapNotNull { use(it, NUMBER) }
        node is Operation && node.operators.size == 1 ->
            node.operands.let { (left, right) -> listOfNotNull(compared(left, right, node), compared(right, left, node)) }
        else -> emptyList()
    }

    private fun argumentsOf(call: Literal): List<Use> {
        val kinds = InternalAction.ALL[call.functor]?.kinds.orEmpty()
        return kinds.zip(call.arguments).mapNotNull { (kind, argument) -> use(argument, kind, call) }
    }

    private fun compared(term: Term, with: Term, comparison: Operation): Use? = when (with) {
        is NumberTerm -> use(term, NUMBER)
        is ListTerm -> if (comparison.isOf("=")) use(term, LIST) else null
        is StringTerm -> if (comparison.isOf("=")) use(term, STRING) else null
        else -> null
    }

    private fun use(term: Term, kind: Char, call: Literal? = null): Use? =
        if (term is Variable && kind in KINDS && !term.name.text.startsWith("_")) Use(term.name.text, kind, term, call) else null

    private fun contradiction(use: Use, all: List<Use>, report: Report) {
        val others = all.filter { it.call !== use.call || it.call == null }.map { it.kind }.toSet() - EITHER
        val other = others.singleOrNull() ?: return
        if (other == use.kind || use.kind == EITHER && other != NUMBER || use.kind == NUMBER && other == STRING || use.kind == STRING &&
            other == NUMBER) return
        report.warning(
            "internal-action-arguments", use.term.span,
            "${use.variable} is ${WORDS[other]} elsewhere in this plan, and this argument of ${use.call?.name} is ${WORDS[use.kind]}",
            "the plan fails there", "correct the arguments, or their order",
        )
    }

    private const val LIST = 'l'
    private const val NUMBER = 'n'
    private const val STRING = 's'

    private const val EITHER = 'e'
    private val KINDS = setOf(LIST, NUMBER, STRING, EITHER)
    private val WORDS = mapOf(LIST to "a list", NUMBER to "a number", STRING to "a string", EITHER to "a list or a string")
    private val ARITHMETIC = setOf("+", "-", "*", "/", "div", "mod", "**")
}
