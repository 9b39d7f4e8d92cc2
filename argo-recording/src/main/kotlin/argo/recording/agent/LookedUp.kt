package argo.recording.agent

import argo.insides.Insides
import jason.asSemantics.Agent
import jason.asSemantics.InternalAction

/**
 * The actions that an agent has looked up, by their classes, in the place of Jason's table: [found] says what each name stands for from
 * now on, also if a term asks for it that the agent has made of a text.
 */
internal class WatchedActions private constructor(private val agent: Agent, private val found: (String, InternalAction) -> InternalAction) :
    HashMap<String, InternalAction>() {
    private var lookedUp: String? = null

    override fun get(key: String): InternalAction? {
        super.get(key)?.let { return it }
        if (key == lookedUp) return null // Jason makes it now, and puts it here
        lookedUp = key
        try {
            agent.getIA(key)
        } finally {
            lookedUp = null
        }
        return super.get(key)
    }

    override fun put(key: String, value: InternalAction): InternalAction? = super.put(key, found(key, value))

    /** A program may write its agent: without who watches it. */
    private fun writeReplace(): Any = HashMap(this)

    companion object {
        /** Has [found] asked about what [agent] has looked up, and what it will. */
        fun install(agent: Agent, found: (String, InternalAction) -> InternalAction) {
            val before = Insides.actions[agent]
            Insides.actions[agent] = WatchedActions(agent, found).apply { before.forEach { (name, action) -> put(name, action) } }
        }
    }
}

/** Jason's functions for all agents, in the texts that agents make terms of. */
internal object WatchedFunctions {
    /** Has the agent's watch asked about those that draw or read a clock, for the whole program. */
    @Synchronized
    fun install() = Insides.functions[null].replaceAll { _, function -> WatchedCode.watched(function, NobodyWatches) }
}
