package argo.recording.agent

import argo.boundary.InternalCall
import jason.asSemantics.ArithFunction
import jason.asSemantics.InternalAction
import jason.asSemantics.TransitionSystem
import jason.asSemantics.Unifier
import jason.asSyntax.Term
import jason.stdlib.random
import java.io.Serializable

/** Stands in the place of [code], an internal action or a function, and is written as that: a program may write its plans. */
internal sealed interface Watched : Serializable {
    val code: Any
}

/** [code], which the program calls [name]; the agent's watch is asked about its calls. */
internal class WatchedAction(private val name: String, override val code: InternalAction, private val watch: CallWatch) :
    InternalAction by code, Watched {
    private val isOfProject = !JasonCode.isOwn(code.javaClass)

    private fun writeReplace(): Any = code

    override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any =
        current(watch).call(InternalCall(name, args, un), kind()) { code.execute(ts, it, args) }

    private fun kind() = when {
        !isOfProject -> WatchedKind.OUTSIDE
        code.suspendIntention() -> WatchedKind.SUSPENDING
        else -> WatchedKind.PROJECT
    }
}

/** `.random`, called as [watched] is; `.set_random_seed` casts it to Jason's class, and takes the generator of [code]. */
internal class WatchedRandom(override val code: random, private val watched: WatchedAction) : random(), Watched {
    private fun writeReplace(): Any = code

    override fun getRandomGenerator(): java.util.Random = code.randomGenerator

    override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any = watched.execute(ts, un, args)
}

/** The function [code]; the agent's watch is asked about its calls, and [watch] if it has none. */
internal class WatchedFunction(override val code: ArithFunction, val watch: CallWatch) : ArithFunction by code, Watched {
    private val isOfProject = !JasonCode.isOwn(code.javaClass)

    private fun writeReplace(): Any = code

    override fun evaluate(ts: TransitionSystem?, args: Array<Term>): Double =
        current(watch).evaluate(code.name, args, isOfProject) { code.evaluate(ts, args) }
}

/** Has all code carried out. */
internal object NobodyWatches : CallWatch {
    override fun call(call: InternalCall, code: WatchedKind, live: (Unifier) -> Any): Any = live(call.un)

    override fun evaluate(name: String, args: Array<Term>, isOfProject: Boolean, live: () -> Double): Double = live()
}

/** Who watches the agent that calls: a plan that one agent tells another comes with the code of the first. */
private fun current(own: CallWatch) = Keeper.current as? CallWatch ?: own
