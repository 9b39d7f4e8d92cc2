@file:Suppress("ktlint:standard:filename")

package argo.recording

import jason.asSemantics.DefaultInternalAction
import jason.asSemantics.TransitionSystem
import jason.asSemantics.Unifier
import jason.asSyntax.Term
import jason.infra.local.LocalAgArch

/** Stops the agent within a cycle, as the end of its program may do. The recording is closed before the cycle ends. */
@Suppress("ClassName")
class stopping : DefaultInternalAction() {
    override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any {
        generateSequence(ts.agArch) { it.nextAgArch }.filterIsInstance<LocalAgArch>().first().stopAg()
        return true
    }
}
