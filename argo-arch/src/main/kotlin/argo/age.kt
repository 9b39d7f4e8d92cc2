package argo

import argo.boundary.InternalCall
import argo.calls.Failure
import argo.calls.isStepOf
import argo.calls.wrongArgument
import jason.asSemantics.DefaultInternalAction
import jason.asSemantics.TransitionSystem
import jason.asSemantics.Unifier
import jason.asSyntax.ASSyntax
import jason.asSyntax.ListTerm
import jason.asSyntax.Literal
import jason.asSyntax.NumberTerm
import jason.asSyntax.Term

/**
 * The internal action `argo.age(Literal, Ms)`: unifies Ms with the age in ms of the percept belief that unifies with Literal. The age is
 * the time since the board's newest message that contained the percept, perceived already or not. So a percept that the board repeats is
 * young though it causes no event, and one that a filter freezes or holds back grows old. If several percepts match, the youngest is used,
 * and the variables in Literal are bound to its values. It may be used in the context of a plan:
 * `+!go : argo.age(dist(f,_), Ms) & Ms < 200`.
 *
 * If no believed percept of a board unifies with Literal, the action is false in a context; as a step of a plan it fails the plan with
 * `error(not_perceived)`. Fails the plan also with `error(wrong_arguments)` or `error(not_argo)`.
 */
@Suppress("ClassName")
open class age : DefaultInternalAction() {
    override fun getMinArgs() = 2

    override fun getMaxArgs() = 2

    override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any =
        ts.boundary.call(InternalCall("argo.age", args, un)) { answer(ts, un, args) }

    private fun answer(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any {
        checkArguments(args)
        val call = "argo.age(${args.joinToString(",")})"
        val percept = args[0] as? Literal
        if (percept == null || percept.isVar || percept is ListTerm) {
            throw wrongArgument("a percept is a literal such as dist(f,X), not ${args[0]}").of(call)
        }
        if (!args[1].isVar && args[1] !is NumberTerm) throw wrongArgument("an age is a number of milliseconds, not ${args[1]}").of(call)
        val arch = archOf(ts) ?: throw notArgo(ts).of(call)
        val (youngest, ageMs) = arch.youngest(percept, un)
            ?: return if (isStepOf<age>(ts, un)) throw notPerceived(percept).of(call) else false
        return un.unifies(percept, youngest) && un.unifies(args[1], ASSyntax.createNumber(ageMs.toDouble()))
    }

    private fun notPerceived(percept: Literal) =
        Failure("not_perceived", "no percept of a board that is believed now unifies with $percept")
}
