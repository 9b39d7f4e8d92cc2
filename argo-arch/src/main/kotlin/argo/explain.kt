package argo

import argo.boundary.InternalCall
import argo.calls.wrongArgument
import argo.perception.EnvironmentFilter
import jason.asSemantics.DefaultInternalAction
import jason.asSemantics.TransitionSystem
import jason.asSemantics.Unifier
import jason.asSyntax.ASSyntax
import jason.asSyntax.Literal
import jason.asSyntax.Term

/**
 * The internal action `argo.explain(Percept, Why)`: unifies Why with a text that explains whether the active filter drops Percept, and by
 * which rule: the filter of the board in whose namespace Percept is. It may be used in the context of a plan, and also by agents without
 * [Arch].
 *
 * Fails the plan with `error(wrong_arguments)`.
 */
@Suppress("ClassName")
open class explain : DefaultInternalAction() {
    override fun getMinArgs() = 2

    override fun getMaxArgs() = 2

    override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any =
        ts.boundary.call(InternalCall("argo.explain", args, un)) { answer(ts, un, args) }

    private fun answer(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any {
        checkArguments(args)
        val percept = args[0] as? Literal
        if (percept == null || percept.isVar || percept.isList) {
            throw wrongArgument("a percept is a literal such as dist(f,38), not ${args[0]}").of("argo.explain(${args.joinToString(",")})")
        }
        val archs = architectures(ts)
        val why = archOf(ts)?.io?.explain(percept)
            ?: archs.filterIsInstance<EnvironmentFilter>().firstOrNull()?.explain(percept)
            ?: "$percept is kept: there is no filter"
        return un.unifies(args[1], ASSyntax.createString(why))
    }
}
