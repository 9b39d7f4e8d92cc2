package argo.filters.matching

import argo.filters.PerceptionFilter
import argo.filters.PerceptionFilter.OnSwitch

/**
 * Applies one agent's filters over time: remembers which percepts were let through, held back and frozen, and the last percepts of each
 * sensor.
 *
 * [P] is the form of the percepts: texts for [FilterSession.ofTexts], Jason literals for `argo.filters.jason.literalSession()`. The caller
 * passes the time in milliseconds of a clock that never goes back. Not safe for use by several threads at once.
 */
class FilterSession<P : Any> internal constructor(private val textOf: (P) -> String, private val annotated: (P) -> P) {
    private var matcher: PerceptMatcher? = null
    private var rates = RateMemory<P>(null)
    private var smoother: Smoother<P>? = null
    private var latches: Latches? = null
    private var picture = Picture<P>()
    private var last = FilteredPercepts<P>(emptyList(), emptyList(), emptyList(), emptyList(), null)
    private var frozen: Map<String, P> = emptyMap()

    /** The active filter; null: everything is kept. */
    val filter: PerceptionFilter?
        get() = matcher?.filter

    /**
     * Makes [filter] the active one from the next perception on; null: no filter.
     *
     * A freezing filter keeps those percepts of the last perception that it hides. Every perception contains these frozen percepts until
     * the next change of filters. A frozen percept ends earlier when a percept is let through that differs from it only in numbers. The
     * session also [forgets][forget] earlier percepts, but critical rules that both filters have go on to hold until their second limits.
     */
    fun switchTo(filter: PerceptionFilter?) {
        val next = filter?.let { PerceptMatcher(it, matcher) }
        val held = latches
        frozen = if (next != null && filter.onSwitch == OnSwitch.FREEZE) hiddenBy(next) else emptyMap()
        matcher = next
        forget()
        if (latches != null && held != null) latches = held
    }

    /**
     * Forgets the percepts that rates held back, and the last percepts of each sensor. Call this if later percepts come at another time or
     * from another board, and must not be compared with earlier ones.
     */
    fun forget() {
        rates = RateMemory(filter)
        smoother = matcher?.takeIf { it.filter.smoothing.isNotEmpty() }?.let { Smoother(it, textOf, annotated) }
        latches = if (matcher?.hasLatches == true) Latches() else null
        picture = Picture()
        last = FilteredPercepts(last.received, last.kept, last.seen, last.critical, null)
    }

    /**
     * Returns the agent's perception at [nowMs], if [percepts] are its whole picture of the world. Text that is not a percept is kept.
     *
     * @param old percepts whose sensors have not been read since the last picture, so that smoothing rules do not count them again
     */
    @JvmOverloads
    fun perceive(percepts: List<P>, nowMs: Long, old: Set<P> = emptySet()): FilteredPercepts<P> {
        val received = java.util.List.copyOf(percepts)
        picture = smoother?.picture(received, nowMs, old) ?: picture.also { it.begin(received) }
        latches?.let(::note)
        return decided(nowMs)
    }

    private fun note(latches: Latches) {
        latches.begin()
        for (place in picture.received.indices) matcher?.note(textOf(picture.received[place]), textOf(picture.standing(place)), latches)
    }

    /**
     * Returns the agent's perception at [nowMs] if no newer percepts have come but held-back ones are due; null if none is due. The result
     * is the last perception, with each due percept put in the place of its predecessor.
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
        val replacement = if (matcher.isCritical(text, latches)) null else smoother?.replacement(percept, nowMs)
        if (replacement == null || replacement.standing === percept) return explain(matcher, received, received, percept, nowMs)
        val standing = PerceptText.of(textOf(replacement.standing)) ?: received
        return Explanation.replaced(
            matcher, received, replacement.rule, replacement.reason, explain(matcher, received, standing, replacement.standing, nowMs),
        )
    }

    /** Explains what becomes of [percept] with the text [standing], which the agent gets in place of a percept with the text [received]. */
    private fun explain(matcher: PerceptMatcher, received: PerceptText, standing: PerceptText, percept: P, nowMs: Long): Explanation {
        val isCritical = matcher.criticalRules(received, standing, latches).isNotEmpty()
        val hold = if (isCritical) null else rates.holds(matcher.rulesMetBy(standing, latches), standing, percept, nowMs).firstOrNull()
        return if (hold == null) Explanation.of(matcher, received, standing, latches)
        else Explanation.heldBack(matcher, standing, hold, nowMs)
    }

    private fun decided(nowMs: Long): FilteredPercepts<P> {
        last = matcher?.let { decided(it, nowMs) } ?: picture.received.let { FilteredPercepts(it, it, it, emptyList(), null) }
        return last
    }

    private fun decided(matcher: PerceptMatcher, nowMs: Long): FilteredPercepts<P> {
        val holds = ArrayList<Hold<P>>()
        val all = ArrayList<P>(picture.received.size)
        val seenNow = if (picture.hasDoubted) ArrayList<P>(picture.received.size) else null
        for (place in picture.received.indices) {
            val percept = decided(matcher, place, nowMs, holds) ?: continue
            all += percept
            if (!picture.isDoubted(place) || percept === picture.received[place]) seenNow?.add(percept)
        }
        val passed = if (rates.isEmpty) all else all.distinct()
        val seen = if (holds.isEmpty()) seenNow ?: passed else passed.filter(picture.seen()::contains)
        val kept = if (frozen.isEmpty()) passed else passed + stillFrozen(passed)
        return FilteredPercepts(picture.received, kept, seen, criticalOf(matcher), holds.minOfOrNull { it.dueMs })
    }

    /**
     * Returns the percept that the agent perceives for the percept at [place]; null: it perceives none. Adds rules that hold it back to
     * [holds].
     */
    private fun decided(matcher: PerceptMatcher, place: Int, nowMs: Long, holds: MutableList<Hold<P>>): P? {
        val received = picture.received[place]
        val isStandIn = picture.standing(place) !== received && !matcher.isCritical(textOf(received), latches)
        val percept = if (isStandIn) picture.standing(place) else received
        if (!rates.isEmpty) return rated(matcher, received, percept, nowMs, holds)
        val text = textOf(percept)
        return if (matcher.drops(text, 0, text.length, isStandIn, latches)) null else percept
    }

    /** Like [decided], for a filter with rates. [percept] stands for [received]. */
    private fun rated(matcher: PerceptMatcher, received: P, percept: P, nowMs: Long, holds: MutableList<Hold<P>>): P? {
        val found = PerceptText.of(textOf(percept)) ?: return percept
        val met = matcher.rulesMetBy(found, latches)
        if (matcher.criticalRules(receivedText(received, found, percept), found, latches).isEmpty()) {
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

    private fun criticalOf(matcher: PerceptMatcher): List<CriticalPercept<P>> {
        if (matcher.filter.critical.isEmpty()) return emptyList()
        return picture.received.indices.flatMap { criticalOf(matcher, picture.received[it], picture.standing(it)) }.distinct()
    }

    private fun criticalOf(matcher: PerceptMatcher, received: P, percept: P): List<CriticalPercept<P>> {
        val standing = PerceptText.of(textOf(percept)) ?: return emptyList()
        val rules = matcher.criticalRules(receivedText(received, standing, percept), standing, latches)
        val perceived = if (rules.all { it.smoothed }) percept else received
        return rules.map { CriticalPercept(it, perceived) }
    }

    /** Returns the text of [received]. [standing] is the text of [percept], which stands for [received]. */
    private fun receivedText(received: P, standing: PerceptText, percept: P): PerceptText =
        if (received === percept) standing else PerceptText.of(textOf(received)) ?: standing

    private fun hiddenBy(next: PerceptMatcher): Map<String, P> =
        last.kept.filter { next.drops(textOf(it)) }.mapNotNull { percept -> key(percept)?.let { it to percept } }.toMap()

    private fun stillFrozen(passed: List<P>): Collection<P> {
        frozen = frozen - passed.mapNotNull(::key).toSet()
        return frozen.values
    }

    private fun key(percept: P): String? = PerceptText.of(textOf(percept))?.key(RateMemory.ANY_NUMBER)

    companion object {
        /** Makes a session for percepts in the text of the line. The session begins without a filter. */
        fun ofTexts(): FilterSession<String> = FilterSession({ it }, ::withSmoothed)
    }
}
