package argo.filters.matching

import argo.filters.PerceptionFilter
import argo.filters.PerceptionFilter.OnSwitch

/**
 * Applies one agent's filters over time: remembers which percepts were let through, held back and frozen.
 *
 * [P] is the form of the percepts: texts for [FilterSession.ofTexts], Jason literals for `argo.filters.jason.literalSession()`. The caller
 * passes the time in milliseconds of a clock that never goes back. Not safe for use by several threads at once.
 */
class FilterSession<P : Any> internal constructor(private val textOf: (P) -> String) {
    private var matcher: PerceptMatcher? = null
    private var rates = RateMemory<P>(null)
    private var last = FilteredPercepts<P>(emptyList(), emptyList(), emptyList(), emptyList(), null)
    private var frozen: Map<String, P> = emptyMap()

    /** The active filter; null: everything is kept. */
    val filter: PerceptionFilter?
        get() = matcher?.filter

    /**
     * Makes [filter] the active one from the next perception on; null: no filter.
     *
     * A freezing filter keeps those percepts of the last perception that it hides. Every perception contains them until the next change of
     * filters. A frozen percept ends earlier when a percept is let through that differs from it only in numbers. The session forgets the
     * percepts that rates hold back.
     */
    fun switchTo(filter: PerceptionFilter?) {
        val next = filter?.matcher()
        frozen = if (next != null && filter.onSwitch == OnSwitch.FREEZE) hiddenBy(next) else emptyMap()
        rates = RateMemory(filter)
        matcher = next
        last = FilteredPercepts(last.received, last.kept, last.seen, last.critical, null)
    }

    /** Returns the agent's perception at [nowMs]. The [percepts] replace all earlier ones. Text that is no percept is kept. */
    fun perceive(percepts: List<P>, nowMs: Long): FilteredPercepts<P> {
        last = perceive(java.util.List.copyOf(percepts), matcher, nowMs)
        return last
    }

    /**
     * Returns the agent's perception at [nowMs] if no newer percepts have come but held-back ones are due; null if none is due. The result
     * is the last perception with each due percept in the place of its predecessor.
     */
    fun due(nowMs: Long): FilteredPercepts<P>? {
        val due = last.nextDueMs ?: return null
        return if (nowMs < due) null else perceive(last.received, nowMs)
    }

    /** Explains why the filter would keep, drop or hold back [percept] at [nowMs]. Changes nothing. */
    fun explain(percept: P, nowMs: Long): Explanation {
        val text = textOf(percept)
        val matcher = matcher ?: return Explanation.noFilter(text)
        val found = PerceptText.of(text) ?: return Explanation.noPercept(text, matcher.filter)
        val isCritical = matcher.criticalRules(found).isNotEmpty()
        val hold = if (isCritical) null else rates.holds(matcher.rulesMetBy(found), found, percept, nowMs).firstOrNull()
        return if (hold == null) Explanation.of(matcher, found) else Explanation.heldBack(matcher, found, hold, nowMs)
    }

    private fun perceive(percepts: List<P>, matcher: PerceptMatcher?, nowMs: Long): FilteredPercepts<P> {
        if (matcher == null) return FilteredPercepts(percepts, percepts, percepts, emptyList(), null)
        val holds = ArrayList<Hold<P>>()
        val passed =
            if (rates.isEmpty) percepts.filterNot { matcher.drops(textOf(it)) }
            else percepts.mapNotNull { decide(matcher, it, nowMs, holds) }.distinct()
        val seen = if (holds.isEmpty()) passed else passed.filter(percepts.toHashSet()::contains)
        val kept = if (frozen.isEmpty()) passed else passed + stillFrozen(passed)
        return FilteredPercepts(percepts, kept, seen, criticalOf(percepts, matcher), holds.minOfOrNull { it.dueMs })
    }

    private fun criticalOf(percepts: List<P>, matcher: PerceptMatcher): List<CriticalPercept<P>> {
        if (matcher.filter.critical.isEmpty()) return emptyList()
        return percepts.distinct().flatMap { percept -> matcher.criticalRules(textOf(percept)).map { CriticalPercept(it, percept) } }
    }

    /**
     * Returns the percept that the agent perceives for [percept]; null: none. Adds the hold that keeps [percept] back, if any, to [holds].
     */
    private fun decide(matcher: PerceptMatcher, percept: P, nowMs: Long, holds: MutableList<Hold<P>>): P? {
        val found = PerceptText.of(textOf(percept)) ?: return percept
        val met = matcher.rulesMetBy(found)
        if (matcher.criticalRules(found).isEmpty()) {
            val holding = rates.holds(met, found, percept, nowMs)
            if (holding.isNotEmpty()) {
                holding.forEach { it.last.heldSinceMs = it.last.heldSinceMs ?: nowMs }
                return holding.first().also(holds::add).last.percept
            }
            if (matcher.drops(met)) return null
        }
        rates.letThrough(met, found, percept, nowMs)
        return percept
    }

    private fun hiddenBy(next: PerceptMatcher): Map<String, P> =
        last.kept.filter { next.drops(textOf(it)) }.mapNotNull { percept -> key(percept)?.let { it to percept } }.toMap()

    private fun stillFrozen(passed: List<P>): Collection<P> {
        frozen = frozen - passed.mapNotNull(::key).toSet()
        return frozen.values
    }

    private fun key(percept: P): String? = PerceptText.of(textOf(percept))?.key(RateMemory.ANY_NUMBER)

    companion object {
        /** Makes a session for percepts in the text of the line. The session begins without a filter. */
        fun ofTexts(): FilterSession<String> = FilterSession { it }
    }
}
