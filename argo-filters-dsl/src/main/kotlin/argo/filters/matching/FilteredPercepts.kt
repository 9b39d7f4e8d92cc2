package argo.filters.matching

import argo.filters.CriticalRule
import java.util.Collections

/**
 * The percepts of one perception that reach an agent. The lists are immutable.
 *
 * @property received the unchanged percepts
 * @property kept the percepts that the agent perceives, in the order of [received], with frozen percepts at the end. In place of a
 *     held-back percept, it has the last percept of its kind that was let through.
 * @property seen the percepts of [kept] that came now, without replacements of held-back percepts and without frozen percepts
 * @property critical the percepts of [received] that meet critical rules, once for each rule
 * @property nextDueMs the time in ms, by the caller's clock, at which the next held-back percept is due; null: no percept is held back
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

/** A [percept] and the critical [rule] that it meets. */
data class CriticalPercept<P>(val rule: CriticalRule, val percept: P)
