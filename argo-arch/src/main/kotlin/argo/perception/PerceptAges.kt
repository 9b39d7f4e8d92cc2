package argo.perception

import jason.asSemantics.Unifier
import jason.asSyntax.Literal
import jason.bb.BeliefBase
import jason.bb.StructureWrapperForLiteral
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/**
 * The times at which a message of a board last contained each percept. Holds at most about twice as many percepts as the agent believes and
 * is about to believe. Safe for use by several threads.
 *
 * @param believed returns the board's percepts that the agent believes now; called by any thread
 */
internal class PerceptAges(private val believed: () -> Collection<Literal>) {
    private val lock = ReentrantLock()
    private val lastSeen = HashMap<StructureWrapperForLiteral, Long>()

    /**
     * Notes that a message arrived at [atNanos], by the platform's clock.
     *
     * @param seen the message's percepts that the filter lets through
     * @param delivered all percepts that the agent will believe after the message, even those from earlier messages
     */
    fun seen(seen: Collection<Literal>, delivered: Collection<Literal>, atNanos: Long) = lock.withLock {
        for (percept in seen) {
            lastSeen.merge(StructureWrapperForLiteral(percept), atNanos) { before, now -> if (now - before > 0) now else before }
        }
        if (lastSeen.size > 2 * delivered.size + SPARE) {
            lastSeen.keys.retainAll((delivered + believed()).mapTo(HashSet(), ::StructureWrapperForLiteral))
        }
    }

    /** Returns when [percept] was last seen, by the platform's clock; null if no message has contained it. Ignores annotations. */
    fun lastSeenNanos(percept: Literal): Long? = lock.withLock { lastSeen[StructureWrapperForLiteral(percept)] }

    /**
     * Returns the percept in [beliefs] that unifies with [percept] under [un] and was seen last, with the time; null if none unifies.
     * Called by the agent's thread.
     *
     * @param nowNanos the time by the platform's clock
     */
    fun youngest(beliefs: BeliefBase, percept: Literal, un: Unifier, nowNanos: Long): Pair<Literal, Long>? =
        beliefs.getCandidateBeliefs(percept, un)?.asSequence().orEmpty()
            .filter { !it.isRule && it.hasSource(BeliefBase.APercept) && un.clone().unifiesNoUndo(percept, it) }
            .mapNotNull { belief -> lastSeenNanos(belief)?.let { belief to it } }
            .minByOrNull { (_, seenNanos) -> nowNanos - seenNanos }

    fun size(): Int = lock.withLock { lastSeen.size }

    private companion object {
        const val SPARE = 64
    }
}
