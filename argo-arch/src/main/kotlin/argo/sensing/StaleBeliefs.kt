package argo.sensing

import argo.ports.OpenPort
import jason.asSyntax.ASSyntax
import jason.asSyntax.Literal
import jason.asSyntax.Term

/**
 * What an agent believes of the port from which nothing has come for too long: `stale(P)`, for each name that it has for it.
 *
 * What it believes changes on the agent's thread only; any may ask.
 *
 * @param nowMs a clock in ms that never goes back
 * @param listened the port whose board the agent listens to now; null: none
 * @param intervalMs the sensing interval
 */
internal class StaleBeliefs(nowMs: () -> Long, private val listened: () -> OpenPort?, private val intervalMs: () -> Int) {
    private val staleness = Staleness(nowMs)

    @Volatile
    private var believed: Set<Term> = emptySet()

    /** A message has come, or only now is one awaited. */
    fun renew() = staleness.renew()

    /** In how many ms the board will have been silent for too long, 0: it has; null: it is not listened to, or may be silent. */
    fun dueInMs(): Long? = listened()?.options?.staleAfterMs(intervalMs())?.let(staleness::dueInMs)

    /** Makes up the agent's mind, and says whether that is news. */
    fun update(): Boolean {
        val now = silent()
        return (now != believed).also { believed = now }
    }

    /** Whether the agent believes it of [port]. */
    fun isStale(port: Term): Boolean = port in believed

    /** Whether [update] would be news. */
    fun hasNews(): Boolean = silent() != believed

    /** Whether the agent believes nothing of the kind. */
    fun isEmpty(): Boolean = believed.isEmpty()

    /** The beliefs. */
    fun beliefs(): List<Literal> = believed.map { ASSyntax.createLiteral(FUNCTOR, it) }

    private fun silent(): Set<Term> = if (dueInMs() == 0L) listened()?.terms.orEmpty().toSet() else emptySet()

    companion object {
        /** The functor of these beliefs. */
        const val FUNCTOR = "stale"
    }
}
