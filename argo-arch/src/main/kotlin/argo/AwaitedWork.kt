package argo

import java.util.concurrent.ConcurrentHashMap

/** The work of other threads for which an agent's suspended intentions wait. Safe for several threads. */
internal class AwaitedWork {
    private val begun = ConcurrentHashMap<String, () -> Unit>()

    /** Adds the work for which the intention suspended under [key] waits. [giveUp] ends the work early. */
    fun begin(key: String, giveUp: () -> Unit) {
        begun[key] = giveUp
    }

    fun end(key: String) {
        begun -= key
    }

    /** Gives up the work for dropped intentions. [keys] are the keys of all intentions that are still suspended. */
    fun giveUpDropped(keys: Set<String>) = begun.keys.filter { it !in keys }.forEach { begun.remove(it)?.invoke() }
}
