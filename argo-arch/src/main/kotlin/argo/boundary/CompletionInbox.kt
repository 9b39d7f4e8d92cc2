package argo.boundary

import java.util.concurrent.ConcurrentLinkedQueue

/**
 * A queue of orders, requests or completed work from other threads to an agent. The entries wait, in order, for the agent's next cycle.
 *
 * @param wake wakes the agent until `seen` returns true; `seen` tells whether the agent has taken the entry
 */
class CompletionInbox<T : Any>(private val wake: (seen: () -> Boolean) -> Unit) {
    private val waiting = ConcurrentLinkedQueue<T>()

    /** Returns true if no entry waits. Any thread may call this function. */
    fun isEmpty(): Boolean = waiting.isEmpty()

    /** Adds the entry [end] and wakes the agent. Never waits. Any thread may call this function. */
    fun put(end: T) {
        waiting += end
        wake { end !in waiting }
    }

    /** Removes and returns all entries. Called by the agent's thread. */
    fun takeAll(): List<T> = generateSequence(waiting::poll).toList()
}
