package benchmarks

import jason.asSemantics.DefaultInternalAction
import jason.asSemantics.TransitionSystem
import jason.asSemantics.Unifier
import jason.asSyntax.NumberTerm
import jason.asSyntax.Term

/** The internal action `benchmarks.acts(N)`: reports that an intention acts now on the board's nth answer. */
@Suppress("ClassName") // Jason finds it by this name
class acts : DefaultInternalAction() {
    override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any {
        heard((args[0] as NumberTerm).solve().toInt(), System.nanoTime())
        return true
    }

    companion object {
        /** Receives the answer's number and the time in ns, from the agent's thread; set by the running benchmark. */
        @Volatile
        var heard: (Int, Long) -> Unit = { _, _ -> }
    }
}
