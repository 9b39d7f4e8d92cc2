package argo.sensing

import argo.connecting.OpenPort
import argo.connecting.PortOptions
import jason.asSyntax.ASSyntax
import jason.asSyntax.Literal
import jason.asSyntax.Term

/**
 * The beliefs `stale(P)`, one for each name of a board's port. The agent has these beliefs while no message has come from the port for too
 * long. Only [update] changes the beliefs, on the agent's thread. Any thread may read the beliefs.
 *
 * @param nowMs a clock in ms that never goes back
 * @param listened returns the port if the agent perceives its messages now, else null
 * @param intervalMs returns the sensing interval
 */
internal class StaleBeliefs(
    private val nowMs: () -> Long,
    private val listened: () -> OpenPort?,
    private val intervalMs: () -> Int,
) {
    @Volatile
    private var freshMs = nowMs()

    @Volatile
    private var believed: Set<Term> = emptySet()

    /** Restarts the wait for the next message. Called when a message has come or the agent begins to perceive. */
    fun renew() {
        freshMs = nowMs()
    }

    /** Returns the ms until the port is stale; 0 if it is stale, null if the agent does not perceive it or the board may be silent. */
    fun dueInMs(): Long? = listened()?.let { limitMs(it.options, intervalMs()) }?.let { maxOf(0, freshMs + it - nowMs()) }

    /** Recomputes the beliefs. Returns true if they have changed. */
    fun update(): Boolean {
        val now = silent()
        return (now != believed).also { believed = now }
    }

    fun isStale(port: Term): Boolean = port in believed

    /** Returns true if [update] would change the beliefs. */
    fun hasNews(): Boolean = silent() != believed

    fun isEmpty(): Boolean = believed.isEmpty()

    fun beliefs(): List<Literal> = believed.map { ASSyntax.createLiteral(FUNCTOR, it) }

    private fun silent(): Set<Term> = if (dueInMs() == 0L) listened()?.terms.orEmpty().toSet() else emptySet()

    companion object {
        const val FUNCTOR = "stale"

        /**
         * Returns the ms without a message after which `stale(Port)` is believed; null for never. By default a board may miss one answer,
         * but not two in a row. A board that sends without requests is never stale by default.
         *
         * @param intervalMs the sensing interval in ms
         */
        fun limitMs(options: PortOptions, intervalMs: Int): Long? = with(options) {
            if (staleMs != null) staleMs.toLong().takeIf { it > 0 } else (intervalMs + 2L * timeoutMs).takeUnless { listens }
        }
    }
}
