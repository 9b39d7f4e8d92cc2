@file:Suppress("ClassName")

package argo.tools.replay

import jason.asSemantics.DefaultInternalAction
import jason.asSemantics.TransitionSystem
import jason.asSemantics.Unifier
import jason.asSyntax.NumberTermImpl
import jason.asSyntax.Term

class ticks : DefaultInternalAction() {
    override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any =
        un.unifies(args[0], NumberTermImpl(System.nanoTime().toDouble()))
}
