package benchmarks

import jason.asSemantics.DefaultInternalAction
import jason.asSemantics.TransitionSystem
import jason.asSemantics.Unifier
import jason.asSyntax.NumberTerm
import jason.asSyntax.Term

/** The internal action `benchmarks.acts(N)`: an intention acts now on what the board said in its nth answer. */
@Suppress("ClassName") // Jason finds it by this name
class acts : DefaultInternalAction() {
    override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any {
        heard((args[0] as NumberTerm).solve().toInt(), System.nanoTime())
        return true
    }

    companion object {
        /** Is told the answer's number and the time in ns, by the agent's thread; set by the benchmark that is running. */
        @Volatile
        var heard: (Int, Long) -> Unit = { _, _ -> }
    }
}
