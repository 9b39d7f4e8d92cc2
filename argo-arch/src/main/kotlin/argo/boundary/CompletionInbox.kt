package argo.boundary

import java.util.concurrent.ConcurrentLinkedQueue

/**
 * A queue for the ends of work that an agent has started outside of its thread. The ends wait here, in order, for the agent's next cycle.
 * @param wake wakes the agent until its argument returns true: the agent has seen the end
 */
class CompletionInbox<T : Any>(private val wake: (seen: () -> Boolean) -> Unit) {
    private val waiting = ConcurrentLinkedQueue<T>()

    /** Returns true if nothing waits. Any thread. */
    fun isEmpty(): Boolean = waiting.isEmpty()

    /** Keeps [end] for the agent and wakes it. Any thread; never waits. */
    fun put(end: T) {
        waiting += end
        wake { end !in waiting }
    }

    /** Takes out all waiting ends. Called by the agent's thread. */
    fun takeAll(): List<T> = generateSequence(waiting::poll).toList()
}
