package argo.filters

import argo.filters.PerceptionFilter.Mode
import argo.filters.PerceptionFilter.OnSwitch

/** Marks the receivers of filters in Kotlin. Each function then compiles only in its own block. */
@DslMarker
annotation class FilterDsl

/**
 * Makes a filter that drops percepts that meet a rule and keeps all others.
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
 * @param onSwitch whether an agent that changes to the filter forgets or freezes the beliefs that the filter hides
 * @throws IllegalArgumentException if [name] cannot be a filter's name, or a predicate, a value or a pattern cannot be read
 */
fun dropFilter(name: String, onSwitch: OnSwitch = OnSwitch.FORGET, rules: DropRules.() -> Unit): PerceptionFilter =
    DropRules().apply(rules).let { PerceptionFilter(usableName(name), it.rules, Mode.DROP, onSwitch, it.critical, it.smoothing) }

/**
 * Makes a filter that keeps percepts that meet a rule and drops all others.
 *
 * ```kotlin
 * val frontDistance = keepFilter("frontDistance") {
 *     keep("distance") { argument(0) eq "front" }
 * }
 * ```
 *
 * [dropFilter] describes the parameters and errors.
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
     * Adds all rules of [other].
     *
     * ```kotlin
     * dropFilter("night") { include(frontDistance); drop("light") }
     * ```
     *
     * @throws IllegalArgumentException if the two filters have different modes
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
     * Adds a critical rule: the filter keeps percepts of [predicate] that meet all [conditions], even if other rules drop them. The agent
     * perceives critical percepts before other percepts.
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
     * Adds a critical rule on percepts of a declared type. Conditions name the arguments.
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
     * Adds a smoothing rule: one of the sensor's last percepts replaces each percept of [predicate] that meets all [conditions]. A
     * smoothing rule drops nothing.
     *
     * ```kotlin
     * smooth("dist") { argument(1).outliers(3); argument(1) median 5 }
     * ```
     *
     * @throws IllegalArgumentException if [predicate] is no predicate, or if the rule smooths nothing
     */
    fun smooth(predicate: String, conditions: SmoothingConditions.() -> Unit) {
        smoothing += SmoothingConditions().apply(conditions).smoothingRule(Predicate.of(predicate))
    }

    /**
     * Adds a smoothing rule on percepts of a declared type. Conditions name the arguments.
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
     * Drops the percepts of a declared type that meet all [conditions]. Conditions name the arguments.
     *
     * ```kotlin
     * drop(Distance) { side ne "front" }
     * ```
     */
    fun <T : PerceptType> drop(type: T, conditions: context(TypedRule) T.() -> Unit = {}): Unit = add(type, conditions)
}

/** The rules of a filter under construction, in the mode [Mode.KEEP]. */
class KeepRules internal constructor() : RuleList(Mode.KEEP) {
    /** Keeps the percepts of [predicate] that meet all [conditions]. See [DropRules.drop]. */
    fun keep(predicate: String, conditions: RuleConditions.() -> Unit = {}): Unit = add(Predicate.of(predicate), conditions)

    /** Keeps the percepts of a declared type that meet all [conditions]. See [DropRules.drop]. */
    fun <T : PerceptType> keep(type: T, conditions: context(TypedRule) T.() -> Unit = {}): Unit = add(type, conditions)
}
