package argo.filters.matching

import argo.filters.CriticalPercept
import argo.filters.CriticalRule
import argo.filters.PerceptionFilter
import argo.filters.PerceptionFilter.OnSwitch

/**
 * What one agent's filters need to remember from one perception to the next: what was let through when, what is held back, what is frozen.
 *
 * [P] is the form in which percepts come: [FilterSession.ofTexts] takes them as they came off the line, `literalSession()` takes Jason
 * literals. Time is the caller's: milliseconds of any clock that never goes back. Not safe for use by several threads at once.
 */
class FilterSession<P : Any> internal constructor(
    private val formOf: (P) -> PerceptForm?,
    private val drops: (PerceptMatcher, P) -> Boolean,
    private val criticalRules: (PerceptMatcher, P) -> List<CriticalRule>,
) {
    private var matcher: PerceptMatcher? = null
    private var rates = RateMemory<P>(null)
    private var snapshot: List<P> = emptyList()
    private var delivered: List<P> = emptyList()
    private var frozen: Map<String, P> = emptyMap()

    /** The active filter, or null: everything is kept. */
    val filter: PerceptionFilter?
        get() = matcher?.filter

    /**
     * Of the last perception, the percepts that stand in the picture it was made of: all but those that are frozen and those that stand for
     * percepts that are held back.
     */
    var seen: List<P> = emptyList()
        private set

    /** The percepts that the last perception was made of and that critical rules meet, once for each such rule. */
    var critical: List<CriticalPercept<P>> = emptyList()
        private set

    /** When the next percept that is held back is to be delivered, in the clock's milliseconds; null: none is held back. */
    var nextDueMs: Long? = null
        private set

    /**
     * Makes [filter] the active one from the next perception on; null: none.
     *
     * If it says so, those percepts of the last perception that it hides are frozen: they are delivered with every perception until another
     * change, or until a percept that differs from them in numbers only is let through. What rates held back is forgotten.
     */
    fun switchTo(filter: PerceptionFilter?) {
        val next = filter?.matcher()
        frozen = if (next != null && filter.onSwitch == OnSwitch.FREEZE) hiddenBy(next) else emptyMap()
        rates = RateMemory(filter)
        matcher = next
        nextDueMs = null
    }

    /**
     * What the agent perceives when the board sends [percepts], its whole picture of the world, at [nowMs].
     *
     * For a percept that is held back the one that was let through last stands in the result, so that the agent goes on believing it.
     * The order is that of [percepts]; frozen percepts follow. Text that is not a percept is kept. The result cannot be changed.
     */
    fun perceive(percepts: List<P>, nowMs: Long): List<P> {
        nextDueMs = null
        critical = criticalOf(percepts)
        delivered = java.util.List.copyOf(decide(percepts, nowMs))
        snapshot = if (nextDueMs == null) emptyList() else java.util.List.copyOf(percepts)
        return delivered
    }

    /**
     * What the agent perceives at [nowMs] if no newer percepts have come and something that is held back is due; null if nothing is.
     * It is the last perception with what is due in place of what was let through before.
     */
    fun due(nowMs: Long): List<P>? {
        val due = nextDueMs ?: return null
        return if (nowMs < due) null else perceive(snapshot, nowMs)
    }

    /** Why the filter would keep, drop or hold back [percept] at [nowMs], without doing it. */
    fun explain(percept: P, nowMs: Long): Explanation {
        val matcher = matcher ?: return Explanation.noFilter(percept.toString())
        val form = formOf(percept) ?: return Explanation.noPercept(percept.toString(), matcher.filter)
        val isCritical = matcher.criticalRules(form).isNotEmpty()
        val hold = if (isCritical) null else rates.holds(matcher.rulesThatMeet(form), form, percept, nowMs).firstOrNull()
        return if (hold == null) Explanation.of(matcher, form) else Explanation.heldBack(matcher, form, hold, nowMs)
    }

    private fun criticalOf(percepts: List<P>): List<CriticalPercept<P>> {
        val matcher = matcher?.takeUnless { it.filter.critical.isEmpty() } ?: return emptyList()
        return percepts.distinct().flatMap { percept -> criticalRules(matcher, percept).map { CriticalPercept(it, percept) } }
    }

    private fun decide(percepts: List<P>, nowMs: Long): List<P> {
        val matcher = matcher ?: return percepts.also { seen = it }
        val passed = if (rates.isEmpty) percepts.filterNot { drops(matcher, it) } else percepts.mapNotNull { decide(matcher, it, nowMs) }.distinct()
        seen = if (nextDueMs == null) passed else passed.filter(percepts.toHashSet()::contains)
        return if (frozen.isEmpty()) passed else passed + stillFrozen(passed)
    }

    private fun decide(matcher: PerceptMatcher, percept: P, nowMs: Long): P? {
        val form = formOf(percept) ?: return percept
        val met = matcher.rulesThatMeet(form)
        if (matcher.criticalRules(form).isEmpty()) {
            val holds = rates.holds(met, form, percept, nowMs)
            if (holds.isNotEmpty()) return holdBack(holds, nowMs)
            if (matcher.drops(met)) return null
        }
        rates.letThrough(met, form, percept, nowMs)
        return percept
    }

    private fun holdBack(holds: List<Hold<P>>, nowMs: Long): P {
        holds.forEach { it.begin(nowMs) }
        nextDueMs = minOf(nextDueMs ?: Long.MAX_VALUE, holds.first().dueMs)
        return holds.first().lastPercept
    }

    private fun hiddenBy(next: PerceptMatcher): Map<String, P> =
        delivered.mapNotNull { percept -> formOf(percept)?.takeIf(next::drops)?.let { it.key(RateMemory.ANY_NUMBER) to percept } }.toMap()

    private fun stillFrozen(passed: List<P>): Collection<P> {
        val renewed = passed.mapNotNull { formOf(it)?.key(RateMemory.ANY_NUMBER) }.toSet()
        frozen = frozen - renewed
        return frozen.values
    }

    companion object {
        /** A session over percepts as they came off the line, without a filter at first. */
        fun ofTexts(): FilterSession<String> = FilterSession({ TextForm.of(it) }, { matcher, percept -> matcher.drops(percept) }, { matcher, percept -> matcher.criticalRules(percept) })
    }
}
