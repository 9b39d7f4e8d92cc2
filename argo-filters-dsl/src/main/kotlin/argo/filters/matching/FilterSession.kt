package argo.filters.matching

import argo.filters.PerceptionFilter
import argo.filters.PerceptionFilter.OnSwitch

/**
 * Applies one agent's filters over time. Remembers which percepts were let through, held back and frozen, and the last percepts of each
 * sensor.
 *
 * [P] is the type of the percepts: texts for [FilterSession.ofTexts], Jason literals for `argo.filters.jason.literalSession()`. The
 * caller passes the time in milliseconds of a clock that never goes back. Not thread-safe.
 */
class FilterSession<P : Any> internal constructor(private val textOf: (P) -> String, private val annotated: (P) -> P) {
    private var matcher: PerceptMatcher? = null
    private var rates = RateMemory<P>(null)
    private var smoother: Smoother<P>? = null
    private var hysteresis: Hysteresis? = null
    private var picture = Picture<P>()
    private var last = FilteredPercepts<P>(emptyList(), emptyList(), emptyList(), emptyList(), null)
    private var frozen: Map<String, List<P>> = emptyMap() // key: the percepts' text without numbers

    /** The active filter. Null: all percepts are kept. */
    val filter: PerceptionFilter?
        get() = matcher?.filter

    /**
     * Makes [filter] the active filter from the next perception on. Null: no filter.
     *
     * If [filter] freezes beliefs, the session freezes the percepts of the last perception that [filter] hides. Until the next change of
     * filters, every perception contains these frozen percepts. A frozen percept ends when a percept that differs only in numbers is let
     * through. The session also [forgets][forget] earlier percepts. Exception: if both filters have a critical rule, its conditions
     * continue to hold until their second limits.
     */
    fun switchTo(filter: PerceptionFilter?) {
        val next = filter?.let { PerceptMatcher(it, matcher) }
        val held = hysteresis
        frozen = if (next != null && filter.onSwitch == OnSwitch.FREEZE) hiddenBy(next) else emptyMap()
        matcher = next
        forget()
        if (hysteresis != null && held != null) hysteresis = held
    }

    /**
     * Forgets the held-back percepts and the last percepts of each sensor. Call this if later percepts must not be compared with earlier
     * ones, for example after a change of boards.
     */
    fun forget() {
        rates = RateMemory(filter)
        smoother = matcher?.takeIf { it.filter.smoothing.isNotEmpty() }?.let { Smoother(it, textOf, annotated) }
        hysteresis = if (matcher?.hasHysteresis == true) Hysteresis() else null
        picture = Picture()
        last = FilteredPercepts(last.received, last.kept, last.seen, last.critical, null)
    }

    /**
     * Returns the agent's perception at [nowMs]. [percepts] are all percepts received now. Keeps text that is not a percept.
     *
     * @param old percepts whose sensors were not read since the last call. Smoothing rules do not count these percepts again
     */
    @JvmOverloads
    fun perceive(percepts: List<P>, nowMs: Long, old: Set<P> = emptySet()): FilteredPercepts<P> {
        val received = java.util.List.copyOf(percepts)
        picture = smoother?.picture(received, nowMs, old) ?: picture.also { it.begin(received) }
        hysteresis?.begin()
        return decided(nowMs)
    }

    /**
     * Returns the agent's perception at [nowMs] if held-back percepts are due and no newer percepts have come. Returns null if none is
     * due. The result is the last perception, in which each due percept replaces the previous percept of its kind.
     */
    fun due(nowMs: Long): FilteredPercepts<P>? {
        val due = last.nextDueMs ?: return null
        return if (nowMs < due) null else decided(nowMs)
    }

    /** Explains why the filter would keep, drop, replace or hold back [percept] at [nowMs]. Changes nothing. */
    fun explain(percept: P, nowMs: Long): Explanation {
        val text = textOf(percept)
        val matcher = matcher ?: return Explanation.noFilter(text)
        val received = PerceptText.of(text) ?: return Explanation.noPercept(text, matcher.filter)
        val isCritical = matcher.criticalRules(received, received, hysteresis?.ofNext()).any { !it.smoothed }
        val replacement = if (isCritical) null else smoother?.replacement(percept, nowMs)
        if (replacement == null || replacement.standing === percept) return explain(matcher, received, received, percept, nowMs)
        val standing = PerceptText.of(textOf(replacement.standing)) ?: received
        return Explanation.replaced(
            matcher, received, replacement.rule, replacement.reason, explain(matcher, received, standing, replacement.standing, nowMs),
        )
    }

    /**
     * Explains what happens to [percept], which replaces a received percept. [standing] is its text, and [received] is the text of the
     * received percept.
     */
    private fun explain(matcher: PerceptMatcher, received: PerceptText, standing: PerceptText, percept: P, nowMs: Long): Explanation {
        val hysteresis = hysteresis?.ofNext()
        val isCritical = matcher.criticalRules(received, standing, hysteresis).isNotEmpty()
        val met = matcher.rulesMetBy(standing, hysteresis)
        val hold = if (isCritical) null else rates.holds(met, rates.known(percept, standing), nowMs).firstOrNull()
        return if (hold == null) Explanation.of(matcher, received, standing, hysteresis)
        else Explanation.heldBack(matcher, standing, hold, nowMs)
    }

    private fun decided(nowMs: Long): FilteredPercepts<P> {
        last = matcher?.let { decided(it, nowMs) } ?: picture.received.let { FilteredPercepts(it, it, it, emptyList(), null) }
        return last
    }

    private fun decided(matcher: PerceptMatcher, nowMs: Long): FilteredPercepts<P> {
        val holds = ArrayList<Hold<P>>()
        val critical = if (matcher.filter.critical.isEmpty()) null else LinkedHashSet<CriticalPercept<P>>()
        val all = ArrayList<P>(picture.received.size)
        rates.begin()
        val seenNow = if (picture.hasDoubted) ArrayList<P>(picture.received.size) else null
        for (place in picture.received.indices) {
            val met = criticalAt(place, matcher)
            critical?.addAll(met)
            val percept = decided(matcher, picture.standing(place), met.firstOrNull()?.percept, nowMs, holds) ?: continue
            all += percept
            if (!picture.isDoubted(place) || percept === picture.received[place]) seenNow?.add(percept)
        }
        val passed = if (rates.isEmpty) all else all.distinct()
        val seen = if (holds.isEmpty()) seenNow ?: passed else passed.filter(picture.seen()::contains)
        val kept = if (frozen.isEmpty()) passed else passed + stillFrozen(passed)
        return FilteredPercepts(picture.received, kept, seen, critical?.toList().orEmpty(), holds.minOfOrNull { it.dueMs })
    }

    /**
     * Returns the percept that the agent perceives at index [place], once for each matching critical rule. Empty if no critical rule
     * matches.
     */
    private fun criticalAt(place: Int, matcher: PerceptMatcher): List<CriticalPercept<P>> {
        if (matcher.filter.critical.isEmpty()) return emptyList()
        val received = picture.received[place]
        val standing = picture.standing(place)
        val text = PerceptText.of(textOf(standing)) ?: return emptyList()
        val receivedText = if (received === standing) text else PerceptText.of(textOf(received)) ?: text
        val rules = matcher.criticalRules(receivedText, text, hysteresis)
        val perceived = if (rules.all { it.smoothed }) standing else received
        return rules.map { CriticalPercept(it, perceived) }
    }

    /**
     * Returns the agent's percept for [standing], the result of smoothing, or null if there is none. If a rule holds [standing] back,
     * adds the hold to [holds].
     *
     * @param critical the percept that the agent perceives because critical rules match; null: none matches
     */
    private fun decided(matcher: PerceptMatcher, standing: P, critical: P?, nowMs: Long, holds: MutableList<Hold<P>>): P? {
        if (!rates.isEmpty) return rated(matcher, standing, critical, nowMs, holds)
        val isDropped = matcher.drops(textOf(standing), hysteresis) // even if a critical rule keeps it: the hysteresis records it
        return critical ?: standing.takeUnless { isDropped }
    }

    /** Like [decided], for a filter with rates. */
    private fun rated(matcher: PerceptMatcher, standing: P, critical: P?, nowMs: Long, holds: MutableList<Hold<P>>): P? {
        val found = PerceptText.of(textOf(standing)) ?: return standing
        val met = matcher.rulesMetBy(found, hysteresis)
        val next = rates.next(standing, found)
        if (critical != null) return critical.also { letThrough(matcher, it, next.kind, nowMs) }
        val holding = rates.holds(met, next, nowMs)
        if (holding.isNotEmpty()) {
            holding.forEach { it.last.heldSinceMs = it.last.heldSinceMs ?: nowMs }
            return holding.first().also(holds::add).last.percept
        }
        if (matcher.drops(met)) return null
        rates.letThrough(met, next, nowMs)
        return standing
    }

    private fun letThrough(matcher: PerceptMatcher, critical: P, kind: String, nowMs: Long) {
        val found = PerceptText.of(textOf(critical)) ?: return
        rates.letThrough(matcher.rulesMetBy(found, hysteresis?.ofNext()), RatedPercept(critical, found, kind), nowMs)
    }

    private fun hiddenBy(next: PerceptMatcher): Map<String, List<P>> =
        last.kept.filter { next.drops(textOf(it)) }.groupBy { key(it).orEmpty() }

    private fun stillFrozen(passed: List<P>): List<P> {
        frozen = frozen - passed.mapNotNull(::key).toSet()
        return frozen.values.flatten()
    }

    private fun key(percept: P): String? = PerceptText.of(textOf(percept))?.key(RateMemory.ANY_NUMBER)

    companion object {
        /** Makes a session for percepts that are texts from boards. The session begins without a filter. */
        fun ofTexts(): FilterSession<String> = FilterSession({ it }, ::withSmoothed)
    }
}
