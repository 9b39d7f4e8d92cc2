package argo.check.rules

import argo.check.rules.KindOfUse.Companion.EITHER
import argo.check.rules.KindOfUse.Companion.LIST
import argo.check.rules.KindOfUse.Companion.NUMBER
import argo.check.rules.KindOfUse.Companion.STRING
import argo.check.syntax.ListTerm
import argo.check.syntax.Literal
import argo.check.syntax.Variable
import argo.check.syntax.withDescendants

/** Finds variables that a plan uses as terms of two kinds, for example as a list and as a number. */
internal object VariableKindRules : Rule {
    override fun check(scene: Scene, report: Report) = scene.program.program.components.forEach { component ->
        val uses = KindOfUse.within(component).filter { it.kind in KINDS }.toList().groupBy { it.variable }
        uses.values.forEach { same -> same.filter { it.call != null }.forEach { contradiction(it, same, report) } }
        val lists = uses.filterValues { same -> same.any { it.kind == LIST && it.call == null } }.keys
        component.withDescendants().filterIsInstance<Literal>().filter { it.indicator == ".member/2" }.forEach { member(it, lists, report) }
    }

    /** Reports a [call] of `.member` that looks for one of the [lists] in a variable that is no known list. */
    private fun member(call: Literal, lists: Set<String>, report: Report) {
        val (element, list) = call.arguments
        val isList = element is ListTerm && element.withDescendants().none { it is Variable } ||
            element is Variable && element.name.text in lists
        if (!isList || list !is Variable || list.name.text in lists) return
        report.warning(
            "internal-action-arguments", call.name.span, "argument 1 of .member is a list, and argument 2 the variable ${list.name}",
            "the first is looked for in the second", "correct the order of the arguments",
        )
    }

    private fun contradiction(use: KindOfUse, all: List<KindOfUse>, report: Report) {
        val others = all.filter { it.call !== use.call || it.call == null }.map { it.kind }.toSet() - EITHER
        val other = others.singleOrNull() ?: return
        if (other == use.kind || use.kind == EITHER && other != NUMBER || use.kind == NUMBER && other == STRING || use.kind == STRING &&
            other == NUMBER) return
        val (here, elsewhere) = listOf(use.kind, other).map(InternalAction.WORDS::getValue)
        report.warning(
            "internal-action-arguments", use.term.span,
            "${use.variable} is $elsewhere elsewhere in this plan, and this argument of ${use.call?.name} is $here",
            "the plan fails there", "correct the arguments, or their order",
        )
    }

    private val KINDS = setOf(LIST, NUMBER, STRING, EITHER)
}
