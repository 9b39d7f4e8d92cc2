package argo.filters

import argo.filters.PerceptionFilter.Mode
import argo.filters.PerceptionFilter.OnSwitch

/** Marks the receivers of filters in Kotlin, so that a word is only understood in the block that it belongs to. */
@DslMarker
annotation class FilterDsl

/**
 * A filter that drops the percepts its rules meet and keeps all others.
 *
 * ```kotlin
 * val frontDistance = perceptionFilter("frontDistance") {
 *     drop("temperature")
 *     drop("light")
 *     drop("distance") { argument(0) ne "front" }
 * }
 * ```
 *
 * @param name what agents call it
 * @param onSwitch what becomes of beliefs that it hides when an agent changes to it
 * @throws IllegalArgumentException if a predicate, a value or a pattern cannot be read; the message says what is wrong with it
 */
fun perceptionFilter(name: String, onSwitch: OnSwitch = OnSwitch.FORGET, rules: DropRules.() -> Unit): PerceptionFilter =
    PerceptionFilter(name, DropRules().apply(rules).rules, Mode.DROP, onSwitch)

/**
 * A filter that keeps the percepts its rules meet and drops all others.
 *
 * ```kotlin
 * val frontDistance = keepingFilter("frontDistance") {
 *     keep("distance") { argument(0) eq "front" }
 * }
 * ```
 *
 * Parameters and errors are those of [perceptionFilter].
 */
fun keepingFilter(name: String, onSwitch: OnSwitch = OnSwitch.FORGET, rules: KeepRules.() -> Unit): PerceptionFilter =
    PerceptionFilter(name, KeepRules().apply(rules).rules, Mode.KEEP, onSwitch)

/** The rules of a filter under construction. */
@FilterDsl
sealed class RuleList(private val mode: Mode) {
    internal val rules = ArrayList<Rule>()

    /**
     * Adds all rules of [other], as if they were written here.
     *
     * ```kotlin
     * perceptionFilter("night") { include(frontDistance); drop("light") }
     * ```
     *
     * @throws IllegalArgumentException if one of the filters drops what its rules meet and the other keeps it
     */
    fun include(other: PerceptionFilter) {
        require(other.mode == mode) { "filter ${other.name} cannot be included: one of the two drops what its rules meet, and the other keeps it" }
        rules += other.rules
    }

    protected fun add(predicate: Predicate, conditions: RuleConditions.() -> Unit) {
        rules += RuleConditions().apply(conditions).rule(predicate)
    }

    protected fun <T : PerceptType> add(type: T, conditions: context(TypedRule) T.() -> Unit) {
        val rule = RuleConditions()
        conditions(TypedRule(rule), type)
        rules += rule.rule(type.predicate)
    }
}

/** The rules of a filter that drops. */
class DropRules internal constructor() : RuleList(Mode.DROP) {
    /**
     * Drops the percepts of [predicate] that meet all [conditions].
     *
     * ```kotlin
     * drop("distance") { argument(0) ne "front" }
     * drop("~open")
     * ```
     *
     * @throws IllegalArgumentException if [predicate] is none
     */
    fun drop(predicate: String, conditions: RuleConditions.() -> Unit = {}): Unit = add(Predicate.of(predicate), conditions)

    /**
     * Drops the percepts of a declared type that meet all [conditions], in which its arguments have names.
     *
     * ```kotlin
     * drop(Distance) { side ne "front" }
     * ```
     */
    fun <T : PerceptType> drop(type: T, conditions: context(TypedRule) T.() -> Unit = {}): Unit = add(type, conditions)
}

/** The rules of a filter that keeps. */
class KeepRules internal constructor() : RuleList(Mode.KEEP) {
    /** Keeps the percepts of [predicate] that meet all [conditions]; as [DropRules.drop]. */
    fun keep(predicate: String, conditions: RuleConditions.() -> Unit = {}): Unit = add(Predicate.of(predicate), conditions)

    /** Keeps the percepts of a declared type that meet all [conditions]; as [DropRules.drop]. */
    fun <T : PerceptType> keep(type: T, conditions: context(TypedRule) T.() -> Unit = {}): Unit = add(type, conditions)
}
