package argo.filters

/**
 * A rule for percepts of noisy sensors. A percept that meets the rule is replaced by one of the last percepts of the same sensor: the
 * newest credible one, or the middle one. A smoothing rule drops nothing. The filter's other rules then decide about the selected percept;
 * critical rules do so only if they are [smoothed][CriticalRule.smoothed].
 *
 * Percepts that differ only in [argument] come from one sensor: `dist(f,30)` and `dist(f,31)` if argument 1 is smoothed, but not
 * `dist(b,30)`. A percept without a number in [argument] is not replaced. The rule applies [maxRate] first, then [outliers], then [median].
 *
 * Only an [argo.filters.matching.FilterSession] smooths, since it knows the time and the earlier percepts.
 *
 * @property rule the rule that the percepts meet; it has no rate, and no condition with a [second limit][Condition.Argument.until]
 * @property argument the position of the number that is smoothed, counted from 0
 * @property maxRate the most by which the number can change in a second; null: there is no limit. A percept whose number differs more from
 * that of the last credible percept is not credible. Of three percepts in a row whose numbers change too much, the third is credible again
 * if each can follow the one before
 * @property outliers which percepts are not credible because they are far from most others; null: there is no such test
 * @property median the middle one of so many last credible percepts is selected; the number is odd. Null: the newest is selected. While
 * there are fewer percepts, the middle one of these is selected; of two middle ones, the newer one
 * @property annotates true if selected percepts get the annotation `smoothed`, as in `dist(f,30)[smoothed]`
 * @throws IllegalArgumentException if nothing is to be smoothed, or a number has no meaning
 */
data class SmoothingRule(
    val rule: Rule,
    val argument: Int,
    val maxRate: Double? = null,
    val outliers: Outliers? = null,
    val median: Int? = null,
    val annotates: Boolean = false,
) {
    init {
        requireIndex(argument)
        require(maxRate != null || outliers != null || median != null) {
            "a smoothing rule needs a greatest rate, outliers or a median for its argument"
        }
        require(maxRate == null || maxRate > 0 && maxRate.isFinite()) {
            "a greatest rate of $maxRate a second means nothing; expected a finite number above 0"
        }
        median?.let { requireWindow(it) }
        require(rule.rate == null) { "a smoothing rule delays no percepts, so it has neither everyMs nor a deadband" }
        require(rule.conditions.none { it is Condition.Argument && it.until != null }) {
            "the condition of a smoothing rule has one limit; write the second one into a rule behind it"
        }
    }

    /** The rule in words: `dist where argument 0 is f, by the median of the last 5 of argument 1`. */
    override fun toString(): String {
        val words = listOfNotNull(
            maxRate?.let { "a change of at most ${GroundTerm.Number(it)} a second" },
            outliers?.let { "leaving out $it" },
            median?.let { "the median of the last $it" },
        )
        return "$rule, by ${words.joinToString(", ")} of argument $argument" + if (annotates) ", annotated" else ""
    }

    companion object {
        /** The largest number of percepts for a median. */
        const val MAX_WINDOW: Int = 99

        internal fun isWindow(size: Int) = size in 3..MAX_WINDOW && size % 2 == 1

        internal fun requireWindow(size: Int) = require(isWindow(size)) { "a median of $size; expected $WINDOW" }

        internal const val WINDOW = "an odd number of percepts from 3 to $MAX_WINDOW"
    }
}

/**
 * Percepts whose number is more than [deviations] deviations from the median of their sensor's last numbers, including their own number. A
 * deviation is 1.4826 times the median of the distances to that median; for normal noise, this is the standard deviation. A deviation is at
 * least one unit of the percept's last digit. The first two percepts of a sensor are never outliers.
 *
 * @property deviations the greatest distance from the median, in deviations
 * @property among the number of last percepts for the median; it is odd
 * @throws IllegalArgumentException if [deviations] is not a finite number from 1, or [among] is no odd number from 3 to
 * [SmoothingRule.MAX_WINDOW]
 */
data class Outliers(val deviations: Double, val among: Int = AMONG) {
    init {
        require(deviations >= 1 && deviations.isFinite()) {
            "outliers of $deviations deviations are ordinary percepts; expected a number from 1, as in 3"
        }
        SmoothingRule.requireWindow(among)
    }

    override fun toString(): String = "outliers of ${GroundTerm.Number(deviations)} deviations among the last $among"

    companion object {
        /** The default number of percepts for the median. */
        const val AMONG: Int = 5
    }
}
