package benchmarks

import jason.asSemantics.DefaultInternalAction
import jason.asSemantics.TransitionSystem
import jason.asSemantics.Unifier
import jason.asSyntax.Term

/** The internal action `benchmarks.say(W)`: the agent's [SingleThread] writes W. */
@Suppress("ClassName") // Jason finds it by this name
class say : DefaultInternalAction() {
    override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any {
        generateSequence(ts.agArch) { it.nextAgArch }.filterIsInstance<SingleThread>().first().say("${args[0]}")
        return true
    }
}
