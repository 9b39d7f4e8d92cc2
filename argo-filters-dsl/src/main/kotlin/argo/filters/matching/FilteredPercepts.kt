package argo.filters.matching

import argo.filters.CriticalRule
import java.util.Collections

/**
 * The percepts of one picture of the world that reach an agent. The lists cannot be changed.
 *
 * @property received the percepts of the picture, as they came
 * @property kept the percepts that the agent perceives: in the order of [received], each percept that passed and, in place of each that is
 * held back, the one of its kind that was let through last; then the frozen percepts
 * @property seen the percepts of [kept] that came and passed: without the replacements of held-back percepts and the frozen ones
 * @property critical the percepts of [received] that meet critical rules, once for each such rule
 * @property nextDueMs when the next percept that is held back is to be delivered, in milliseconds of the caller's clock; null: no percept
 * is held back
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

/**
 * A percept that meets a critical rule.
 *
 * @property rule the rule
 * @property percept the percept as it came
 */
data class CriticalPercept<P>(val rule: CriticalRule, val percept: P)
