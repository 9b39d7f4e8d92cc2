package argo

import argo.perception.EnvironmentFilter
import jason.asSyntax.ASSyntax
import jason.asSyntax.Literal

/**
 * The internal action `argo.explain(Percept, Why)`: unifies Why with a text that says whether the active filter drops Percept, and by which
 * rule. The namespace of Percept selects the board and its filter. Contexts of plans may contain the action. Agents without [Arch] may also
 * use the action.
 *
 * Fails the plan with `error(wrong_arguments)`.
 */
@Suppress("ClassName")
open class explain : BoardQuery("argo.explain", 2) {
    override fun answer(call: Call): Any {
        val (percept, explanation) = call.args
        if (percept !is Literal || percept.isVar || percept.isList) {
            throw call.wrong("a percept is a literal such as dist(f,38), not $percept")
        }
        val why = archOf(call.ts)?.perception?.explain(percept)
            ?: architectures(call.ts).filterIsInstance<EnvironmentFilter>().firstOrNull()?.explain(percept)
            ?: "$percept is kept: there is no filter"
        return call.un.unifies(explanation, ASSyntax.createString(why))
    }
}
