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

/**
 * A use that requires a variable to be of a certain kind.
 *
 * @property kind one of [InternalAction.WORDS]: [LIST], [NUMBER], [STRING], [ATOM] or [EITHER]
 * @property call the internal action with the variable as argument, or null for another use
 */
internal class KindOfUse(val variable: String, val kind: Char, val term: Term, val call: Literal?) {
    companion object {
        const val LIST = 'l'
        const val NUMBER = 'n'
        const val STRING = 's'
        const val ATOM = 'a'
        const val EITHER = 'e'
        private val KINDS = setOf(LIST, NUMBER, STRING, ATOM, EITHER)

        fun within(component: Node): Sequence<KindOfUse> = component.withDescendants().flatMap(::at)

        private fun at(node: Node): List<KindOfUse> = when {
            node is Literal && node.isInternal -> argumentsOf(node)
            node is Literal && node.indicator == "source/1" -> listOfNotNull(use(node.arguments.single(), ATOM))
            node is ListTerm -> listOfNotNull(node.tail?.let { use(it, LIST) })
            node is Operation && node.isArithmetic -> node.operands.mapNotNull { use(it, NUMBER) }
            node is Operation && node.operators.size == 1 ->
                node.operands.let { (left, right) -> listOfNotNull(compared(left, right, node), compared(right, left, node)) }
            else -> emptyList()
        }

        private fun argumentsOf(call: Literal): List<KindOfUse> {
            val kinds = InternalAction.ALL[call.functor]?.kinds.orEmpty()
            return kinds.zip(call.arguments).mapNotNull { (kind, argument) -> use(argument, kind, call) }
        }

        private fun compared(term: Term, with: Term, comparison: Operation): KindOfUse? = when (with) {
            is NumberTerm -> use(term, NUMBER)
            is Operation -> if (with.isArithmetic) use(term, NUMBER) else null
            is Literal -> if (with.functor in InternalAction.FUNCTIONS) use(term, NUMBER) else null
            is ListTerm -> if (comparison.isOf("=")) use(term, LIST) else null
            is StringTerm -> if (comparison.isOf("=")) use(term, STRING) else null
            else -> null
        }

        private fun use(term: Term, kind: Char, call: Literal? = null): KindOfUse? =
            if (term is Variable && kind in KINDS && !term.name.text.startsWith("_")) KindOfUse(term.name.text, kind, term, call) else null
    }
}
