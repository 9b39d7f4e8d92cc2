package argo.recording.replay

import argo.recording.agent.WatchedCode
import jason.asSemantics.Agent
import jason.asSemantics.ArithFunction
import jason.asSemantics.InternalAction

/**
 * The agent of a replay, which Jason makes. What it looks up while it runs, as for a term that it has made of a text, is watched as the
 * code of its program is, and no class is touched that is no internal action.
 */
internal class GuardedAgent : Agent() {
    /** Its code; null: it is being read. */
    var code: WatchedCode? = null

    override fun getIA(name: String): InternalAction {
        requireCode(if (name.startsWith('.')) "jason.stdlib$name" else name)
        return super.getIA(name).let { code?.watched(name, it) ?: it }
    }

    override fun getFunction(name: String, arity: Int): ArithFunction? = super.getFunction(name, arity)?.let { code?.watched(it) ?: it }

    companion object {
        /**
         * Refuses the class [name] if it is something else than an internal action or a function; where there is none, Jason says so.
         * @throws RecordingException if it is
         */
        fun requireCode(name: String) {
            val type = classOrNull(name) ?: return
            if (!InternalAction::class.java.isAssignableFrom(type) && !ArithFunction::class.java.isAssignableFrom(type)) {
                throw RecordingException("the recorded program calls $name, a class that is neither an internal action nor a function")
            }
        }
    }
}
