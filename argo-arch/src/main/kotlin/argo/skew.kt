package argo

import argo.boundary.InternalCall
import argo.calls.Failure
import argo.calls.isStepOf
import argo.calls.wrongArgument
import jason.asSemantics.DefaultInternalAction
import jason.asSemantics.TransitionSystem
import jason.asSemantics.Unifier
import jason.asSyntax.ASSyntax
import jason.asSyntax.NumberTerm
import jason.asSyntax.Term

/**
 * The internal action `argo.skew(Ms)`: unifies Ms with the time in ms between the oldest and the newest of the boards' readings that the
 * agent believes now; 0 with one board. Boards that are off, have not answered in time or are stale do not count. It may be used in the
 * context of a plan: `+!go : argo.skew(Ms) & Ms < 20`.
 *
 * If no board's readings are believed, the action is false in a context; as a step of a plan it fails the plan with
 * `error(not_perceived)`. Fails the plan also with `error(wrong_arguments)` or `error(not_argo)`.
 */
@Suppress("ClassName")
open class skew : DefaultInternalAction() {
    override fun getMinArgs() = 1

    override fun getMaxArgs() = 1

    override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any =
        ts.boundary.call(InternalCall("argo.skew", args, un)) { answer(ts, un, args) }

    private fun answer(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any {
        checkArguments(args)
        val call = "argo.skew(${args[0]})"
        if (!args[0].isVar && args[0] !is NumberTerm) throw wrongArgument("a skew is a number of milliseconds, not ${args[0]}").of(call)
        val arch = archOf(ts) ?: throw notArgo(ts).of(call)
        val skewMs = arch.io.skewMs() ?: return if (isStepOf<skew>(ts, un)) throw notPerceived().of(call) else false
        return un.unifies(args[0], ASSyntax.createNumber(skewMs.toDouble()))
    }

    private fun notPerceived() = Failure("not_perceived", "no readings of a board are believed now")
}
