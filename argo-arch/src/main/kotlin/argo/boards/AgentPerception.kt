package argo.boards

import argo.filters.jason.perceptText
import argo.filters.matching.FilterSession
import argo.observing.RuleWatcher
import argo.observing.WatchedRule
import argo.platform.nowMs
import jason.asSemantics.Unifier
import jason.asSyntax.Literal
import jason.bb.BeliefBase
import java.util.concurrent.TimeUnit

/**
 * An agent's perception of its [boards]: the beliefs about the boards, the ages of these beliefs, and the decisions of filters. A function
 * without the note "Any thread" is for the agent's thread only.
 */
internal class AgentPerception(private val boards: AgentBoards) {
    private val platform = boards.platform
    private var newlyCritical: List<Literal> = emptyList()

    /** Takes in all news since the last call. Returns true if [beliefs] may have changed. */
    fun update(): Boolean {
        val areOthers = boards.perceiving()
        if (boards.isPerceiving) boards.current.forEach(Board::putDue)
        val snapshots = boards.ready.take()
        if (snapshots.isNotEmpty()) boards.forgetFormer()
        snapshots.forEach { snapshot -> boards.observers.each { it.messagePerceived(snapshot) } }
        newlyCritical = snapshots.flatMap { snapshot -> snapshot.critical.map { it.percept } }
        val isBoardNews = boards.current.count(Board::update) > 0 // count, not any: update must run for each board
        return areOthers || snapshots.isNotEmpty() || isBoardNews || boards.states.hasNews()
    }

    /** Returns the critical percepts of the snapshots that the last [update] took. The next call of this function returns none. */
    fun takeNewlyCritical(): List<Literal> = newlyCritical.also { newlyCritical = emptyList() }

    /** Returns the beliefs about the boards, about the ports, and about the outcomes of reflexes. */
    fun beliefs(): List<Literal> =
        boards.believed.flatMap { it.sensed } + boards.states.beliefs() + boards.current.flatMap(Board::metaBeliefs)

    /** Returns true if a call of [update] would take in news. Any thread. */
    fun hasNews(): Boolean =
        boards.areOthers || boards.states.hasNews() || boards.current.any(Board::hasNews) || boards.ready.areThere()

    /** Returns the youngest percept in [beliefs] that unifies with [percept] under [un], and its age in ms; null if none unifies. */
    fun youngest(beliefs: BeliefBase, percept: Literal, un: Unifier): Pair<Literal, Long>? {
        val now = platform.clock.nanos()
        return boards.believed.mapNotNull { it.youngest(beliefs, percept, un, now) }.minByOrNull { (_, seen) -> now - seen }
            ?.let { (belief, seen) -> belief to TimeUnit.NANOSECONDS.toMillis(now - seen) }
    }

    /**
     * Returns the ms between the oldest and the newest reading that the agent believes now; null if it believes none. A board does not
     * count if it is off, is stale, or has not answered in time. Any thread.
     */
    fun skewMs(): Long? {
        val readings = boards.current.filter { boards.answers(it.port) }.mapNotNull { it.sensedNanos }
        val first = readings.firstOrNull() ?: return null
        val offsets = readings.map { it - first }
        return TimeUnit.NANOSECONDS.toMillis(offsets.max() - offsets.min())
    }

    /** Explains why filters keep or drop [percept]. Only filters of boards in the namespace of [percept] count. Any thread. */
    fun explain(percept: Literal): String {
        val (own, unnamed) = boards.current.partition { it.namespace != null && it.namespace == percept.ns.functor }
        return if (own.isEmpty()) explain(perceptText(percept), unnamed.filter { it.namespace == null })
        else explain(perceptText(percept.cloneNS(Literal.DefaultNS) as Literal), own)
    }

    /**
     * Explains why the filters of [from] keep or drop [percept]. If a critical rule decides, says whether computer or board watches it. Any
     * thread.
     */
    fun explain(percept: String, from: List<Board> = boards.current): String {
        val reasons = from.map { it.term to it.explain(percept) }
        val different = reasons.distinctBy { (_, why) -> why }
        return when (different.size) {
            0 -> FilterSession.ofTexts().also { it.switchTo(boards.filter) }.explain(percept, platform.nowMs()).toString()
            1 -> different.single().second
            else -> reasons.joinToString("; ") { (port, why) -> "$port: $why" }
        }
    }

    /** Returns the critical rules of the active filters, each with its watcher, which is the computer or the board. Any thread. */
    fun criticalRules(): List<WatchedRule> = boards.current.flatMap { it.criticalRules() }.distinct()
        .ifEmpty { boards.filter?.critical.orEmpty().map { WatchedRule(it, RuleWatcher.COMPUTER) } }
}
