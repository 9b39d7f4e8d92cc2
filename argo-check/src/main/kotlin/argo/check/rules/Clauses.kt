package argo.check.rules

import argo.check.syntax.Belief
import argo.check.syntax.Component
import argo.check.syntax.Directive
import argo.check.syntax.Plan

/** Returns the plans, beliefs and rules in [component]. Each has its own variable scope. */
internal fun clauses(component: Component): List<Component> = when (component) {
    is Directive -> component.components.orEmpty().flatMap(::clauses)
    is Plan, is Belief -> listOf(component)
    else -> emptyList()
}
