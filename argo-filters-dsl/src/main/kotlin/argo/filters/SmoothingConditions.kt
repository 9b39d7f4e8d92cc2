package argo.filters

/**
 * The conditions of a smoothing rule under construction. The rule smooths one argument.
 *
 * ```kotlin
 * smooth("dist") { argument(0) eq "front"; argument(1).outliers(3); argument(1) median 5 }
 * ```
 */
class SmoothingConditions internal constructor() : RuleConditions() {
    private var argument: Int? = null
    private var maxRate: Double? = null
    private var outliers: Outliers? = null
    private var median: Int? = null
    private var annotates = false

    /**
     * Selects the middle one of the last [count] credible percepts: `argument(1) median 5`. See [SmoothingRule.median].
     *
     * @throws IllegalArgumentException if the rule already has another median, or smooths another argument
     */
    infix fun AnyArgument.median(count: Int) {
        this@SmoothingConditions.specify(this)
        this@SmoothingConditions.median(index, count)
    }

    /**
     * Treats a percept as not credible if its number changes by more than [perSecond] a second: `argument(1) maxRate 200`. See
     * [SmoothingRule.maxRate].
     *
     * @throws IllegalArgumentException if the rule already has another greatest rate, or smooths another argument
     */
    infix fun AnyArgument.maxRate(perSecond: Number) {
        this@SmoothingConditions.specify(this)
        this@SmoothingConditions.maxRate(index, perSecond)
    }

    /**
     * Treats a percept as not credible if its number is more than [deviations] deviations from the median of the last [among] numbers:
     * `argument(1).outliers(3)`. See [Outliers].
     *
     * @throws IllegalArgumentException if the rule already has other outliers, or smooths another argument
     */
    fun AnyArgument.outliers(deviations: Number, among: Int = Outliers.AMONG) {
        this@SmoothingConditions.specify(this)
        this@SmoothingConditions.outliers(index, deviations, among)
    }

    /** Adds the annotation `smoothed` to selected percepts. An agent then believes `dist(f,30)[smoothed]`. */
    fun annotate() {
        annotates = true
    }

    internal fun median(argument: Int, count: Int) {
        median = only(median, count, "the median of", argument)
    }

    internal fun maxRate(argument: Int, perSecond: Number) {
        maxRate = only(maxRate, perSecond.toDouble(), "the greatest rate", argument)
    }

    internal fun outliers(argument: Int, deviations: Number, among: Int) {
        outliers = only(outliers, Outliers(deviations.toDouble(), among), "the", argument)
    }

    private fun <V> only(before: V?, value: V, what: String, argument: Int): V {
        require(before == null || before == value) { "the rule has $what $before already; write another rule for $value" }
        require(this.argument == null || this.argument == argument) {
            "the rule smooths argument ${this.argument} already; write another rule for argument $argument"
        }
        this.argument = argument
        return value
    }

    internal fun smoothingRule(predicate: Predicate): SmoothingRule {
        val rule = rule(predicate)
        val argument = requireNotNull(argument) {
            "the smoothing rule on $predicate smooths nothing; expected a median, outliers or a greatest rate of an argument"
        }
        return SmoothingRule(rule, argument, maxRate, outliers, median, annotates)
    }
}
