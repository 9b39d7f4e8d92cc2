@file:Suppress("ClassName") // Jason finds internal actions by these names

package benchmarks

import jason.asSemantics.DefaultInternalAction
import jason.asSemantics.TransitionSystem
import jason.asSemantics.Unifier
import jason.asSyntax.NumberTerm
import jason.asSyntax.Term

/**
 * The internal action `benchmarks.acts(N)` reports an intention that acts on the board's Nth answer. `benchmarks.acts(N, Agent, What)` also
 * reports the agent's number. `What` is `begun`, `done` or `failed`, the state of the agent's Nth action.
 */
class acts : DefaultInternalAction() {
    override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any {
        heard((args[0] as NumberTerm).solve().toInt(), System.nanoTime(), args)
        return true
    }

    companion object {
        /**
         * Gets the number of the answer, the time in ns and all arguments, on the agent's thread. The running benchmark sets this function.
         */
        @Volatile
        var heard: (number: Int, nanos: Long, arguments: Array<Term>) -> Unit = { _, _, _ -> }
    }
}

/** The internal action `benchmarks.say(W)` makes the agent's [SingleThread] write W. */
class say : DefaultInternalAction() {
    override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any {
        generateSequence(ts.agArch) { it.nextAgArch }.filterIsInstance<SingleThread>().first().say("${args[0]}")
        return true
    }
}
