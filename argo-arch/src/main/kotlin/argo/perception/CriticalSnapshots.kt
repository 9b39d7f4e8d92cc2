package argo.perception

import argo.filters.CriticalRule
import jason.asSyntax.Literal
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/**
 * The snapshots with critical percepts that are new to the agent, in their order. One waits until it is taken or a newer one meets the
 * same critical rules, so there are never more than there are rules. Safe for use by several threads.
 */
internal class CriticalSnapshots {
    private val lock = ReentrantLock()
    private val waiting = ArrayDeque<Snapshot>()
    private var known: Set<Literal> = emptySet()
    private val earlyRules = HashSet<CriticalRule>()

    /** Takes [snapshot] if it has a critical percept that was not in the agent's last one; returns true if it did. */
    fun put(snapshot: Snapshot): Boolean = lock.withLock {
        val isNews = snapshot.critical.any { it.percept !in known }
        if (isNews) {
            val met = rules(snapshot)
            waiting.removeAll { met.containsAll(rules(it)) }
            waiting.addLast(snapshot)
        }
        isNews
    }

    /** Returns the next one, or null. */
    fun first(): Snapshot? = lock.withLock { waiting.firstOrNull() }

    /** Returns true if [snapshot] meets a rule that has not let a snapshot pass early since one was taken in its turn. */
    fun mayBeEarly(snapshot: Snapshot): Boolean = lock.withLock { rules(snapshot).any { it !in earlyRules } }

    /** Takes the next one, [inTurn] or early; null if there is none. */
    fun take(inTurn: Boolean): Snapshot? = lock.withLock {
        val snapshot = waiting.removeFirstOrNull() ?: return null
        if (inTurn) earlyRules.clear() else earlyRules += rules(snapshot)
        known = percepts(snapshot)
        snapshot
    }

    /** Notes that the agent took [snapshot], which is none of these, in its turn. */
    fun tookOther(snapshot: Snapshot) = lock.withLock {
        earlyRules.clear()
        known = percepts(snapshot)
    }

    /** Takes all of them out. */
    fun drain(): List<Snapshot> = lock.withLock { waiting.toList().also { waiting.clear() } }

    /** Forgets all. */
    fun clear() = lock.withLock {
        waiting.clear()
        earlyRules.clear()
        known = emptySet()
    }

    private fun rules(snapshot: Snapshot) = snapshot.critical.mapTo(HashSet()) { it.rule }

    private fun percepts(snapshot: Snapshot) = snapshot.critical.mapTo(HashSet()) { it.percept }
}
