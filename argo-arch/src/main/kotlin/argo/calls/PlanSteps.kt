package argo.calls

import jason.asSemantics.InternalAction
import jason.asSemantics.TransitionSystem
import jason.asSemantics.Unifier
import jason.asSyntax.InternalActionLiteral
import jason.asSyntax.PlanBody
import jason.asSyntax.VarTerm

/**
 * Returns true if a call of the internal action [A] is a step of a plan: Jason passes the plan's unifier [un] then, and a context has its
 * own.
 */
internal inline fun <reified A : InternalAction> isStepOf(ts: TransitionSystem, un: Unifier): Boolean {
    val means = ts.c.selectedIntention?.takeUnless { it.isFinished }?.peek() ?: return false
    val step = means.currentStep ?: return false
    val called = step.bodyTerm.let { if (it is VarTerm) un[it] else it }
    return means.unif === un && step.bodyType != PlanBody.BodyType.test && (called as? InternalActionLiteral)?.getIA(ts.ag) is A
}
