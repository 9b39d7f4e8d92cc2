package argo.filters.matching

import argo.filters.CriticalRule
import java.util.Collections

/**
 * The percepts of one perception that reach an agent. The lists are immutable.
 *
 * @property received the percepts as they came
 * @property kept the percepts that the agent perceives, in the order of [received], with the frozen ones at the end. A held-back percept is
 * replaced by the last percept of the same kind that was let through.
 * @property seen the percepts of [kept] that came now: no replacements of held-back percepts, no frozen ones
 * @property critical the percepts of [received] that meet critical rules, once for each such rule
 * @property nextDueMs the time at which the next held-back percept is due, by the caller's clock, in ms; null: no percept is held back
 */
class FilteredPercepts<P> internal constructor(
    val received: List<P>,
    kept: List<P>,
    seen: List<P>,
    critical: List<CriticalPercept<P>>,
    val nextDueMs: Long?,
) {
    val kept: List<P> = Collections.unmodifiableList(kept)
    val seen: List<P> = if (seen === kept) this.kept else Collections.unmodifiableList(seen)
    val critical: List<CriticalPercept<P>> = Collections.unmodifiableList(critical)
}

/** A [percept] as it came, and the critical [rule] that it meets. */
data class CriticalPercept<P>(val rule: CriticalRule, val percept: P)
