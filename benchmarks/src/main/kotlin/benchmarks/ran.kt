package benchmarks

import jason.asSemantics.DefaultInternalAction
import jason.asSemantics.TransitionSystem
import jason.asSemantics.Unifier
import jason.asSyntax.NumberTerm
import jason.asSyntax.Term

/** The internal action `benchmarks.ran(Agent, N, What)`: reports the state of an agent's nth action, `begun`, `done` or `failed`. */
@Suppress("ClassName") // Jason finds it by this name
class ran : DefaultInternalAction() {
    override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any {
        heard((args[0] as NumberTerm).solve().toInt(), (args[1] as NumberTerm).solve().toInt(), "${args[2]}")
        return true
    }

    companion object {
        /** Receives the agent, the action and its outcome, from the agent's thread; set by the running benchmark. */
        @Volatile
        var heard: (Int, Int, String) -> Unit = { _, _, _ -> }
    }
}
