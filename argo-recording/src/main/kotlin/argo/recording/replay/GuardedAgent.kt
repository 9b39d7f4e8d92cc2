package argo.recording.replay

import argo.recording.agent.CallWatch
import argo.recording.agent.WatchedCode
import jason.asSemantics.Agent
import jason.asSemantics.ArithFunction
import jason.asSemantics.InternalAction
import jason.util.Config

/**
 * The agent of a replay, or a file that it includes, which Jason makes. [watch] is asked about the calls of all that it looks up, as Jason
 * reads it and while it runs, as for a term that it has made of a text, and no class is touched that is no internal action.
 */
internal class GuardedAgent(private val watch: LateWatch) : Agent() {
    private var code: WatchedCode? = null // null: it is being read

    /** It has been read, and [asked] is asked about its [code] from now on. */
    fun begin(code: WatchedCode, asked: CallWatch) {
        this.code = code
        watch.watch = asked
    }

    /** Without Jason's server that shows agents. */
    override fun initAg() {
        val config = Config.get()
        val before: Any? = config.setProperty(Config.START_WEB_MI, "false")
        try {
            super.initAg()
        } finally {
            if (before == null) config.remove(Config.START_WEB_MI) else config[Config.START_WEB_MI] = before
        }
    }

    override fun getIA(name: String): InternalAction {
        requireCode(if (name.startsWith('.')) "jason.stdlib$name" else name)
        return WatchedCode.watched(name, super.getIA(name), watch)
    }

    override fun getFunction(name: String, arity: Int): ArithFunction? =
        super.getFunction(name, arity)?.let { WatchedCode.watched(it, watch) }

    /** Blocks of what it includes are read by agents of Jason's own. */
    override fun importComponents(included: Agent) {
        super.importComponents(included)
        code?.run {
            included()
            watchAdded()
        }
    }

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
