package argo.recording.agent

import argo.insides.Insides
import jason.asSemantics.Agent
import jason.asSemantics.InternalAction

/**
 * Replaces Jason's table of the actions that an agent has looked up. [found] gives the action for each name from now on, also if a term
 * that the agent has made from a text asks for it.
 */
internal class WatchedActions private constructor(private val agent: Agent, private val found: (String, InternalAction) -> InternalAction) :
    HashMap<String, InternalAction>() {
    private var lookedUp: String? = null

    override fun get(key: String): InternalAction? {
        super.get(key)?.let { return it }
        if (key == lookedUp) return null // Jason makes the action now, and puts it here
        lookedUp = key
        try {
            agent.getIA(key)
        } finally {
            lookedUp = null
        }
        return super.get(key)
    }

    override fun put(key: String, value: InternalAction): InternalAction? = super.put(key, found(key, value))

    /** Leaves the watch out if the program writes its agent. */
    private fun writeReplace(): Any = HashMap(this)

    companion object {
        /** Asks [found] for each action that [agent] has looked up or will look up. */
        fun install(agent: Agent, found: (String, InternalAction) -> InternalAction) {
            val before = Insides.actions[agent]
            Insides.actions[agent] = WatchedActions(agent, found).apply { before.forEach { (name, action) -> put(name, action) } }
        }
    }
}

/** Jason's functions for all agents; the terms that agents make from texts get them. */
internal object WatchedFunctions {
    /** Makes the functions that draw a number or read a clock ask the watch of the calling agent, for the whole program. */
    @Synchronized
    fun install() = Insides.functions[null].replaceAll { _, function -> WatchedCode.watched(function, NobodyWatches) }
}
