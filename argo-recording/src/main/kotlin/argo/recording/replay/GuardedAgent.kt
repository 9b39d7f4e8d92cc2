package argo.recording.replay

import argo.boundary.InternalCall
import argo.recording.agent.CallWatch
import argo.recording.agent.WatchedCode
import argo.recording.agent.WatchedKind
import jason.asSemantics.Agent
import jason.asSemantics.ArithFunction
import jason.asSemantics.InternalAction
import jason.asSemantics.Unifier
import jason.asSyntax.Term

/**
 * The agent of a replay, or an agent that Jason makes for an included file. It asks [watch] about each call of the code that it looks up,
 * as Jason reads the program and while the agent runs, also for a term that it has made from a text. It touches no class that is not an
 * internal action or a function.
 */
internal class GuardedAgent(private val watch: LateWatch) : Agent() {
    private var code: WatchedCode? = null // null: the program is being read

    /** Asks [asked] about the calls of the agent's [code] from now on. Called when Jason has read the program. */
    fun begin(code: WatchedCode, asked: CallWatch) {
        this.code = code
        watch.watch = asked
    }

    override fun getIA(name: String): InternalAction {
        requireCode(if (name.startsWith('.')) "jason.stdlib$name" else name)
        return WatchedCode.watched(name, super.getIA(name), watch)
    }

    override fun getFunction(name: String, arity: Int): ArithFunction? =
        super.getFunction(name, arity)?.let { WatchedCode.watched(it, watch) }

    /** Watches included code anew: agents of Jason's own read the blocks of an included file. */
    override fun importComponents(included: Agent) {
        super.importComponents(included)
        code?.run {
            included()
            watchAdded()
        }
    }

    companion object {
        /**
         * Refuses the class [name] if it is neither an internal action nor a function. Jason reports a class that does not exist.
         * @throws RecordingException if [name] is refused
         */
        fun requireCode(name: String) {
            val type = classOrNull(name) ?: return
            if (!InternalAction::class.java.isAssignableFrom(type) && !ArithFunction::class.java.isAssignableFrom(type)) {
                throw RecordingException("the recorded program calls $name, a class that is neither an internal action nor a function")
            }
        }
    }
}

/**
 * Asks [watch] about each call of the code that Jason has looked up as it read a program. As long as [watch] is null, it carries out no
 * code that touches the outside, except the project's own code if [isCarryingOut].
 */
internal class LateWatch(private val isCarryingOut: Boolean) : CallWatch {
    /** The watch that is asked; null: the program is being read. */
    var watch: CallWatch? = null

    override fun call(call: InternalCall, code: WatchedKind, live: (Unifier) -> Any): Any =
        watch?.call(call, code, live) ?: if (isCarryingOut && code != WatchedKind.OUTSIDE) live(call.un) else false

    override fun evaluate(name: String, args: Array<Term>, isOfProject: Boolean, live: () -> Double): Double =
        watch?.evaluate(name, args, isOfProject, live) ?: if (isOfProject && !isCarryingOut) Double.NaN else live()
}
