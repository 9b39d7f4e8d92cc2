@file:Suppress("ktlint:standard:filename")

package argo.recording

import jason.asSemantics.DefaultInternalAction
import jason.asSemantics.TransitionSystem
import jason.asSemantics.Unifier
import jason.asSyntax.Term
import jason.infra.local.LocalAgArch

/** Ends the run of the agent as the end of its program does at any moment of a cycle, before the agent's resources are closed. */
@Suppress("ClassName")
class stopping : DefaultInternalAction() {
    override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any {
        val running = LocalAgArch::class.java.getDeclaredField("running").apply { isAccessible = true }
        generateSequence(ts.agArch) { it.nextAgArch }.filterIsInstance<LocalAgArch>().forEach { running.setBoolean(it, false) }
        return true
    }
}
