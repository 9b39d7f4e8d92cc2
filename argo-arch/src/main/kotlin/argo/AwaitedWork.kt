package argo

import java.util.concurrent.ConcurrentHashMap

/** The work outside of an agent that its suspended intentions wait for, if the work can be given up. Safe for use by several threads. */
internal class AwaitedWork {
    private val begun = ConcurrentHashMap<String, () -> Unit>()

    /** Adds work that the intention suspended under [key] waits for; [giveUp] ends the work early. */
    fun begin(key: String, giveUp: () -> Unit) {
        begun[key] = giveUp
    }

    fun end(key: String) {
        begun -= key
    }

    /** Gives up the work of intentions that are no longer suspended under [keys]: the agent has dropped them. */
    fun giveUpDropped(keys: Set<String>) = begun.keys.filter { it !in keys }.forEach { begun.remove(it)?.invoke() }
}
