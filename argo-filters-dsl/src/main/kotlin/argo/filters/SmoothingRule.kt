package argo.filters

/**
 * A rule for percepts of noisy sensors. The rule replaces a percept by one of the sensor's last percepts: the newest credible one, or the
 * middle one. A smoothing rule drops nothing. The filter's other rules then decide about the selected percept. Critical rules decide
 * about the selected percept only if they are [smoothed][CriticalRule.smoothed].
 *
 * Percepts that differ only in [argument] come from one sensor. If argument 1 is smoothed, `dist(f,30)` and `dist(f,31)` come from one
 * sensor, and `dist(b,30)` from another. A percept without a number in [argument] is not replaced. The rule applies [maxRate] first, then
 * [outliers], then [median].
 *
 * Only an [argo.filters.matching.FilterSession] smooths, because only a session knows the time and the earlier percepts.
 *
 * @property rule the rule that the percepts meet. The rule has no rate, and no condition with a [second limit][Condition.Argument.until]
 * @property argument the position of the smoothed number, counted from 0
 * @property maxRate the most by which the number can change in a second; null: no limit. A percept is not credible if its number differs
 *     more from that of the last credible percept. Three such percepts in a row confirm each other if each can follow the previous one:
 *     the third is then credible
 * @property outliers the test for numbers far from most others, which are not credible; null: no such test
 * @property median the odd number of last credible percepts from which the middle one is selected; null: the newest is selected. While
 *     there are fewer percepts, the middle one of these is selected. If there are two middle ones, the newer one is selected
 * @property annotates true if selected percepts get the annotation `smoothed`: `dist(f,30)[smoothed]`
 * @throws IllegalArgumentException if the rule smooths nothing, or if a number has no meaning
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

    /** Returns the rule in words: `dist where argument 0 is f, by the median of the last 5 of argument 1`. */
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
 * The test for outliers. An outlier's number is more than [deviations] deviations from the median of the sensor's last numbers, including
 * the number itself. A deviation is 1.4826 times the median of the distances to that median. For normal noise, this is the standard
 * deviation. A deviation is at least one unit of the number's last digit. The first two percepts of a sensor are never outliers.
 *
 * @property deviations the greatest distance from the median, in deviations
 * @property among the odd number of last percepts for the median
 * @throws IllegalArgumentException if [deviations] is not a finite number of at least 1, or [among] is no odd number from 3 to
 *     [SmoothingRule.MAX_WINDOW]
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
