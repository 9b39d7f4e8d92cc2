package jason.planted

import jason.asSemantics.DefaultInternalAction
import jason.asSemantics.TransitionSystem
import jason.asSemantics.Unifier
import jason.asSyntax.ASSyntax
import jason.asSyntax.Term

/** An internal action that only a later version of Jason has. */
@Suppress("ClassName")
class unheard : DefaultInternalAction() {
    override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any = un.unifies(args[0], ASSyntax.createNumber(7.0))
}
