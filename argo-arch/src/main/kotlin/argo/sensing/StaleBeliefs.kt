package argo.sensing

import argo.connecting.OpenPort
import argo.connecting.PortOptions
import jason.asSyntax.ASSyntax
import jason.asSyntax.Literal
import jason.asSyntax.Term

/**
 * The beliefs `stale(P)`, one for each name of the port in use, while no message has come from the port for too long. These beliefs change
 * only in [update], on the agent's thread; any thread may read.
 * @param nowMs a clock in ms that never goes back
 * @param listened returns the port whose messages the agent perceives now; null: none
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

    /** Begins the wait for the next message: a message has come, or the agent begins to listen. */
    fun renew() {
        freshMs = nowMs()
    }

    /** Returns the ms until the port in use is stale; 0: it is stale; null: the agent does not listen, or the board may be silent. */
    fun dueInMs(): Long? = listened()?.let { limitMs(it.options, intervalMs()) }?.let { maxOf(0, freshMs + it - nowMs()) }

    /** Recomputes the beliefs; returns true if they changed. */
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
         * Returns the ms without a message after which `stale(Port)` is believed; null: never. By default a board may miss one answer, but
         * not two in a row. By default a board that sends only news is never stale.
         * @param intervalMs the sensing interval in ms
         */
        fun limitMs(options: PortOptions, intervalMs: Int): Long? = with(options) {
            if (staleMs != null) staleMs.toLong().takeIf { it > 0 } else (intervalMs + 2L * timeoutMs).takeUnless { listens }
        }
    }
}
