package argo.recording.agent

import argo.boundary.InternalCall
import argo.insides.Insides
import jason.asSemantics.Agent
import jason.asSemantics.ArithFunction
import jason.asSemantics.InternalAction
import jason.asSemantics.TransitionSystem
import jason.asSemantics.Unifier
import jason.asSyntax.Term
import jason.stdlib.random
import java.io.Serializable

/** Replaces [code], an internal action or a function. If a program serializes its plans, [code] is written instead of this object. */
internal sealed interface Watched : Serializable {
    val code: Any
}

/** Wraps the internal action [code], which the program calls [name]. Asks the agent's watch about each call. */
internal class WatchedAction(private val name: String, override val code: InternalAction, private val watch: CallWatch) :
    InternalAction by code, Watched {
    private val isOfProject = !JasonActions.isOwn(code.javaClass)
    private var isWaiting = false

    private fun writeReplace(): Any =
        if (code is OfInfrastructure) JasonActions.typeOf(code.javaClass).getConstructor().newInstance() else code

    /** Suspends the intention if the watch suspends the call. A replay suspends it if the recorded intention waited for other computers. */
    override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any {
        isWaiting = false
        val call = InternalCall(name, args, un) {
            AwaitedOutside.begin(ts)
            isWaiting = true
        }
        return current(watch).call(call, kind()) { code.execute(ts, it, args) }
    }

    override fun suspendIntention() = isWaiting || code.suspendIntention()

    private fun kind() = when {
        JasonActions.natureOf(code.javaClass) == Nature.SENDING -> WatchedKind.SENDING
        !isOfProject -> WatchedKind.OUTSIDE
        code.suspendIntention() -> WatchedKind.SUSPENDING
        else -> WatchedKind.PROJECT
    }
}

/**
 * Wraps `.random`, and passes calls to [watched]. Extends Jason's class, since `.set_random_seed` casts to Jason's class and takes its
 * generator.
 */
internal class WatchedRandom(override val code: random, private val watched: WatchedAction) : random(), Watched {
    private fun writeReplace(): Any = code

    override fun getRandomGenerator(): java.util.Random = code.randomGenerator

    override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any = watched.execute(ts, un, args)
}

/** Wraps the function [code]. Asks the calling agent's watch about each call. If that agent has no watch, asks [watch]. */
internal class WatchedFunction(override val code: ArithFunction, val watch: CallWatch) : ArithFunction by code, Watched {
    private val isOfProject = !JasonActions.isOwn(code.javaClass)

    private fun writeReplace(): Any = code

    override fun evaluate(ts: TransitionSystem?, args: Array<Term>): Double =
        current(watch).evaluate(code.name, args, isOfProject) { code.evaluate(ts, args) }
}

internal object NobodyWatches : CallWatch {
    override fun call(call: InternalCall, code: WatchedKind, live: (Unifier) -> Any): Any = live(call.un)

    override fun evaluate(name: String, args: Array<Term>, isOfProject: Boolean, live: () -> Double): Double = live()
}

/**
 * Returns the calling agent's watch. If that agent has no watch, returns [own]. The calling agent may have got the code in a plan that
 * another agent sent.
 */
private fun current(own: CallWatch) = Keeper.current as? CallWatch ?: own

/**
 * Replaces Jason's table of the actions that an agent has looked up. From now on [found] chooses the action for each name, even for a term
 * that the agent makes from a text.
 */
internal class WatchedActions private constructor(private val agent: Agent, private val found: (String, InternalAction) -> InternalAction) :
    HashMap<String, InternalAction>() {
    private var lookedUp: String? = null

    override fun get(key: String): InternalAction? {
        super.get(key)?.let { return it }
        if (key == lookedUp) return null // Jason now makes the action and puts it into this table
        lookedUp = key
        try {
            agent.getIA(key)
        } finally {
            lookedUp = null
        }
        return super.get(key)
    }

    override fun put(key: String, value: InternalAction): InternalAction? = super.put(key, found(key, value))

    private fun writeReplace(): Any = HashMap(this)

    companion object {
        /** Replaces each action that [agent] has looked up, or will look up, by the result of [found]. */
        fun install(agent: Agent, found: (String, InternalAction) -> InternalAction) {
            val before = Insides.actions[agent]
            Insides.actions[agent] = WatchedActions(agent, found).apply { before.forEach { (name, action) -> put(name, action) } }
        }
    }
}

/** Jason's functions for all agents. Terms that agents make from texts use these functions. */
internal object WatchedFunctions {
    /** From now on the functions that draw a number or read a clock ask the calling agent's watch, in the whole program. */
    @Synchronized
    fun install() = Insides.functions[null].replaceAll { _, function -> WatchedCode.watched(function, NobodyWatches) }
}
