package argo.recording.replay

import argo.boundary.InternalCall
import argo.recording.agent.CallWatch
import argo.recording.agent.JasonActions
import argo.recording.agent.Nature
import argo.recording.agent.WatchedAction
import argo.recording.agent.WatchedCode
import argo.recording.agent.WatchedKind
import jason.asSemantics.Agent
import jason.asSemantics.ArithFunction
import jason.asSemantics.InternalAction
import jason.asSemantics.Unifier
import jason.asSyntax.Term

/**
 * The agent of a replay, or an agent that Jason makes for an included file. Asks [watch] about each call of looked-up code, even while
 * Jason reads the program. This includes code in terms that the agent makes from texts. The agent uses only classes that are internal
 * actions or functions.
 */
internal class GuardedAgent(private val watch: LateWatch) : Agent() {
    private var code: WatchedCode? = null // null while the program is read

    /** From now on asks [asked] about the calls of the agent's [code]. Called when Jason has read the program. */
    fun begin(code: WatchedCode, asked: CallWatch) {
        this.code = code
        watch.watch = asked
    }

    override fun getIA(name: String): InternalAction {
        requireCode(if (name.startsWith('.')) "jason.stdlib$name" else name)
        val action = super.getIA(name)
        if (JasonActions.natureOf(action.javaClass) == Nature.SENDING) return WatchedAction(JasonActions.nameOf(action), action, watch)
        return WatchedCode.watched(name, action, watch)
    }

    override fun getFunction(name: String, arity: Int): ArithFunction? =
        super.getFunction(name, arity)?.let { WatchedCode.watched(it, watch) }

    /** Watches included code again, since Jason's own agents read the blocks of an included file. */
    override fun importComponents(included: Agent) {
        super.importComponents(included)
        code?.run {
            included()
            watchAdded()
        }
    }

    companion object {
        /**
         * Refuses the class [name] if it is neither an internal action nor a function. Ignores a missing class, since Jason reports it.
         *
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
 * Asks [watch] about each call of code that Jason has looked up while it read a program. While [watch] is null, carries out only Jason's
 * functions and, if [isCarryingOut] is true, the project's own code.
 */
internal class LateWatch(private val isCarryingOut: Boolean) : CallWatch {
    /** The watch to ask; null while the program is read. */
    var watch: CallWatch? = null

    override fun call(call: InternalCall, code: WatchedKind, live: (Unifier) -> Any): Any =
        watch?.call(call, code, live) ?: if (isCarryingOut && code.isOfProject) live(call.un) else false

    override fun evaluate(name: String, args: Array<Term>, isOfProject: Boolean, live: () -> Double): Double =
        watch?.evaluate(name, args, isOfProject, live) ?: if (isOfProject && !isCarryingOut) Double.NaN else live()
}
