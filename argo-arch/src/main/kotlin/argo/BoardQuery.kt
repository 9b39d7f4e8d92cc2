package argo

import argo.boundary.InternalCall
import argo.calls.Failure
import argo.calls.wrongArgument
import jason.JasonException
import jason.asSemantics.DefaultInternalAction
import jason.asSemantics.TransitionSystem
import jason.asSemantics.Unifier
import jason.asSyntax.InternalActionLiteral
import jason.asSyntax.PlanBody
import jason.asSyntax.Term
import jason.asSyntax.VarTerm

/** The base of ARGO's internal actions that only ask. Contexts of plans may contain these actions. */
abstract class BoardQuery internal constructor(private val name: String, private val arguments: Int) : DefaultInternalAction() {
    final override fun getMinArgs() = arguments

    final override fun getMaxArgs() = arguments

    final override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any =
        ts.boundary.call(InternalCall(name, args, un)) {
            checkArguments(args)
            answer(Call(ts, un, args))
        }

    /** Returns the result, see [jason.asSemantics.InternalAction.execute]. Called by the agent's thread. */
    internal abstract fun answer(call: Call): Any

    internal inner class Call(val ts: TransitionSystem, val un: Unifier, val args: Array<Term>) {
        val arch: Arch get() = archOf(ts) ?: throw failure(notArgo(ts))

        fun wrong(cause: String): JasonException = failure(wrongArgument(cause))

        /** Handles a call that has no answer. Returns false in a context. If the call is a step of a plan, fails the plan with [why]. */
        inline fun unanswered(why: () -> Failure): Boolean = if (isStep()) throw failure(why()) else false

        fun failure(failure: Failure): JasonException = failure.of("$name(${args.joinToString(",")})")

        /** Returns true if the call is a step of a plan. A step uses the plan's unifier; a call in a context uses another unifier. */
        fun isStep(): Boolean {
            val means = ts.c.selectedIntention?.takeUnless { it.isFinished }?.peek() ?: return false
            val step = means.currentStep ?: return false
            val called = step.bodyTerm.let { if (it is VarTerm) un[it] else it }
            return means.unif === un && step.bodyType != PlanBody.BodyType.test &&
                this@BoardQuery.javaClass.isInstance((called as? InternalActionLiteral)?.getIA(ts.ag))
        }
    }
}
