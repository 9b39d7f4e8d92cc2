package argo.filters

import argo.filters.PerceptionFilter.Mode
import argo.filters.PerceptionFilter.OnSwitch

/** Marks the receivers of filters in Kotlin, so that each function compiles only in the block to which it belongs. */
@DslMarker
annotation class FilterDsl

/**
 * Makes a filter that drops the percepts that meet its rules and keeps all others.
 *
 * ```kotlin
 * val frontDistance = dropFilter("frontDistance") {
 *     drop("temperature")
 *     drop("light")
 *     drop("distance") { argument(0) ne "front" }
 * }
 * ```
 *
 * @param name the name by which agents call the filter
 * @param onSwitch whether beliefs that the filter hides are forgotten or frozen when an agent changes to the filter
 * @throws IllegalArgumentException if [name] cannot be a filter's name, or a predicate, a value or a pattern cannot be read
 */
fun dropFilter(name: String, onSwitch: OnSwitch = OnSwitch.FORGET, rules: DropRules.() -> Unit): PerceptionFilter =
    DropRules().apply(rules).let { PerceptionFilter(usableName(name), it.rules, Mode.DROP, onSwitch, it.critical, it.smoothing) }

/**
 * Makes a filter that keeps the percepts that meet its rules and drops all others.
 *
 * ```kotlin
 * val frontDistance = keepFilter("frontDistance") {
 *     keep("distance") { argument(0) eq "front" }
 * }
 * ```
 *
 * Parameters and errors are those of [dropFilter].
 */
fun keepFilter(name: String, onSwitch: OnSwitch = OnSwitch.FORGET, rules: KeepRules.() -> Unit): PerceptionFilter =
    KeepRules().apply(rules).let { PerceptionFilter(usableName(name), it.rules, Mode.KEEP, onSwitch, it.critical, it.smoothing) }

/** The rules of a filter under construction. */
@FilterDsl
sealed class RuleList(private val mode: Mode) {
    internal val rules = ArrayList<Rule>()
    internal val critical = ArrayList<CriticalRule>()
    internal val smoothing = ArrayList<SmoothingRule>()

    /**
     * Adds all rules of [other], as if they were written here.
     *
     * ```kotlin
     * dropFilter("night") { include(frontDistance); drop("light") }
     * ```
     *
     * @throws IllegalArgumentException if one of the two filters drops the percepts that meet its rules and the other filter keeps them
     */
    fun include(other: PerceptionFilter) {
        require(other.mode == mode) {
            "filter ${other.name} cannot be included: one of the two drops the percepts that match its rules, and the other keeps them"
        }
        rules += other.rules
        critical += other.critical
        smoothing += other.smoothing
    }

    /**
     * Adds a critical rule: percepts of [predicate] that meet all [conditions] are kept even if other rules drop them, and come first.
     *
     * ```kotlin
     * critical("dist") { argument(1) lt 15; reflex("stop") }
     * ```
     *
     * @throws IllegalArgumentException if [predicate] is no predicate, or the reflex cannot be sent
     */
    fun critical(predicate: String, conditions: CriticalConditions.() -> Unit = {}) {
        critical += CriticalConditions().apply(conditions).criticalRule(Predicate.of(predicate))
    }

    /**
     * Adds a critical rule on percepts of a declared type, whose arguments have names.
     *
     * ```kotlin
     * critical(Distance) { cm lt 15; reflex("stop") }
     * ```
     */
    fun <T : PerceptType> critical(type: T, conditions: context(TypedCriticalRule) T.() -> Unit = {}) {
        val rule = CriticalConditions()
        speakingOf(rule) { conditions(TypedCriticalRule(type, rule), type) }
        critical += rule.criticalRule(type.predicate)
    }

    /**
     * Adds a smoothing rule: each percept of [predicate] that meets all [conditions] is replaced by one of the sensor's last percepts. A
     * smoothing rule drops nothing.
     *
     * ```kotlin
     * smooth("dist") { argument(1).outliers(3); argument(1) median 5 }
     * ```
     *
     * @throws IllegalArgumentException if [predicate] is no predicate, or nothing is to be smoothed
     */
    fun smooth(predicate: String, conditions: SmoothingConditions.() -> Unit) {
        smoothing += SmoothingConditions().apply(conditions).smoothingRule(Predicate.of(predicate))
    }

    /**
     * Adds a smoothing rule on percepts of a declared type, whose arguments have names.
     *
     * ```kotlin
     * smooth(Distance) { cm median 5 }
     * ```
     */
    fun <T : PerceptType> smooth(type: T, conditions: context(TypedSmoothingRule) T.() -> Unit) {
        val rule = SmoothingConditions()
        speakingOf(rule) { conditions(TypedSmoothingRule(type, rule), type) }
        smoothing += rule.smoothingRule(type.predicate)
    }

    protected fun add(predicate: Predicate, conditions: RuleConditions.() -> Unit) {
        rules += RuleConditions().apply(conditions).rule(predicate)
    }

    protected fun <T : PerceptType> add(type: T, conditions: context(TypedRule) T.() -> Unit) {
        val rule = RuleConditions()
        speakingOf(rule) { conditions(TypedRule(type, rule), type) }
        rules += rule.rule(type.predicate)
    }
}

/** The rules of a filter under construction, in the mode [Mode.DROP]. */
class DropRules internal constructor() : RuleList(Mode.DROP) {
    /**
     * Drops the percepts of [predicate] that meet all [conditions].
     *
     * ```kotlin
     * drop("distance") { argument(0) ne "front" }
     * drop("~open")
     * ```
     *
     * @throws IllegalArgumentException if [predicate] is no predicate
     */
    fun drop(predicate: String, conditions: RuleConditions.() -> Unit = {}): Unit = add(Predicate.of(predicate), conditions)

    /**
     * Drops the percepts of a declared type that meet all [conditions]. The conditions refer to arguments by their names.
     *
     * ```kotlin
     * drop(Distance) { side ne "front" }
     * ```
     */
    fun <T : PerceptType> drop(type: T, conditions: context(TypedRule) T.() -> Unit = {}): Unit = add(type, conditions)
}

/** The rules of a filter under construction, in the mode [Mode.KEEP]. */
class KeepRules internal constructor() : RuleList(Mode.KEEP) {
    /** Keeps the percepts of [predicate] that meet all [conditions]; like [DropRules.drop]. */
    fun keep(predicate: String, conditions: RuleConditions.() -> Unit = {}): Unit = add(Predicate.of(predicate), conditions)

    /** Keeps the percepts of a declared type that meet all [conditions]; like [DropRules.drop]. */
    fun <T : PerceptType> keep(type: T, conditions: context(TypedRule) T.() -> Unit = {}): Unit = add(type, conditions)
}
