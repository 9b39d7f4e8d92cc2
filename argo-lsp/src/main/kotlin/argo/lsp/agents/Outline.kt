package argo.lsp.agents

import argo.check.syntax.Belief
import argo.check.syntax.Component
import argo.check.syntax.Directive
import argo.check.syntax.EventKind
import argo.check.syntax.InitialGoal
import argo.check.syntax.Plan
import argo.check.syntax.Program
import argo.check.syntax.Span
import argo.check.syntax.Unread
import argo.lsp.text.Text
import org.eclipse.lsp4j.DocumentSymbol
import org.eclipse.lsp4j.SymbolKind

/** Returns the beliefs, goals, plans and directives of [program], which is the program in [text]. */
internal fun outlineOf(program: Program, text: Text): List<DocumentSymbol> = program.components.mapNotNull { outline(it, text) }

private fun outline(component: Component, text: Text): DocumentSymbol? = when (component) {
    is Belief -> symbol(text, component, component.head.span, if (component.condition == null) SymbolKind.Field else SymbolKind.Function)
    is InitialGoal -> symbol(text, component, component.goal.span, SymbolKind.Event, "!")
    is Plan -> plan(component, text)
    is Directive -> component.call?.let { call ->
        symbol(text, component, call.span, SymbolKind.Namespace, inner = component.components.orEmpty().mapNotNull { outline(it, text) })
    }
    is Unread -> null
}

private fun plan(plan: Plan, text: Text): DocumentSymbol? {
    val kind = if (plan.trigger.kind == EventKind.BELIEF) SymbolKind.Event else SymbolKind.Method
    return symbol(text, plan, plan.trigger.span, kind, inner = plan.plans.mapNotNull { outline(it, text) })
        ?.apply { detail = plan.context?.let { text.content.substring(it.span.start, it.span.end) } }
}

/** Returns null if [shown] is empty, as in an unfinished program. The protocol requires a name. */
private fun symbol(
    text: Text,
    component: Component,
    shown: Span,
    kind: SymbolKind,
    prefix: String = "",
    inner: List<DocumentSymbol> = emptyList(),
): DocumentSymbol? {
    val name = text.content.substring(shown.start, shown.end).takeIf { it.isNotBlank() } ?: return null
    return DocumentSymbol(prefix + name, kind, text.range(component.span + shown), text.range(shown), null, inner)
}
