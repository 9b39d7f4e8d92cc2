/*
 * Conditions on arguments of a declared percept type. Each function adds a condition to the rule of its block:
 * `drop(Distance) { cm gt 9 }`.
 */
package argo.filters

import kotlin.time.Duration

/** A rule under construction, on a declared percept type. The functions in this file have this rule as their context parameter. */
open class TypedRule internal constructor(internal val type: PerceptType, internal val conditions: RuleConditions)

/** A critical rule under construction, on a declared percept type. */
class TypedCriticalRule internal constructor(type: PerceptType, internal val critical: CriticalConditions) : TypedRule(type, critical)

/** A smoothing rule under construction, on a declared percept type. */
class TypedSmoothingRule internal constructor(type: PerceptType, internal val smoothing: SmoothingConditions) : TypedRule(type, smoothing)

/** Lets the rule test the percept that a smoothing rule selects: `smoothed()`. See [CriticalRule.smoothed]. */
context(rule: TypedCriticalRule)
fun PerceptType.smoothed(): Unit = rule.critical.smoothed()

/** Selects the middle one of the last [count] credible percepts: `cm median 5`. See [SmoothingRule.median]. */
context(rule: TypedSmoothingRule)
infix fun NumberArgument.median(count: Int) {
    specify()
    rule.smoothing.median(index, count)
}

/**
 * Treats a percept as not credible if its number changes by more than [perSecond] a second: `cm maxRate 200`. See
 * [SmoothingRule.maxRate].
 */
context(rule: TypedSmoothingRule)
infix fun NumberArgument.maxRate(perSecond: Number) {
    specify()
    rule.smoothing.maxRate(index, perSecond)
}

/** Treats a percept as not credible if its number is far from the median of the last [among] numbers: `cm.outliers(3)`. See [Outliers]. */
context(rule: TypedSmoothingRule)
fun NumberArgument.outliers(deviations: Number, among: Int = Outliers.AMONG) {
    specify()
    rule.smoothing.outliers(index, deviations, among)
}

/** Adds the annotation `smoothed` to selected percepts: `annotate()`. */
context(rule: TypedSmoothingRule)
fun PerceptType.annotate(): Unit = rule.smoothing.annotate()

/** Sends [command] for a percept that meets the rule: `reflex("stop")`. See [CriticalConditions.reflex]. */
context(rule: TypedCriticalRule)
fun PerceptType.reflex(command: String): Unit = rule.critical.reflex(command)

/** Requires an argument equal to [value]: `side eq "front"`, `cm eq 36`, `position eq "pos(1,2)"`. A string is written without quotes. */
context(rule: TypedRule)
infix fun <V> TypedArgument<V>.eq(value: V): Unit = compare(Operator.EQ, value)

/** Requires an argument different from [value]: `side ne "front"`. */
context(rule: TypedRule)
infix fun <V> TypedArgument<V>.ne(value: V): Unit = compare(Operator.NE, value)

/** Requires one of [values]: `side isIn listOf("front", "back")`, `cm isIn listOf(0, 255)`. */
context(rule: TypedRule)
infix fun <V> TypedArgument<V>.isIn(values: Collection<V>): Unit = must(TermTest.OneOf(values.map(termOf).toSet()))

/** Requires a number in [range], both ends included: `cm isIn 1..5` also holds for 2.5. An empty range is refused. */
context(rule: TypedRule)
infix fun <N> NumberArgument.isIn(range: ClosedRange<N>): Unit where N : Number, N : Comparable<N> = must(*range.tests())

/**
 * Requires that the argument's whole text, quotes included, matches the regular expression [pattern]: `side matches "a|b"`. See
 * [TermTest.Matches].
 */
context(rule: TypedRule)
infix fun TypedArgument<String>.matches(pattern: String): Unit = must(TermTest.Matches(pattern))

/** Requires a number greater than [number]: `cm gt 200`. */
context(rule: TypedRule)
infix fun NumberArgument.gt(number: Number): Limit = order(Operator.GT, number)

/** Requires a number of at least [number]: `cm ge 200`. */
context(rule: TypedRule)
infix fun NumberArgument.ge(number: Number): Limit = order(Operator.GE, number)

/** Requires a number less than [number]: `cm lt 15`. */
context(rule: TypedRule)
infix fun NumberArgument.lt(number: Number): Limit = order(Operator.LT, number)

/** Requires a number of at most [number]: `cm le 15`. */
context(rule: TypedRule)
infix fun NumberArgument.le(number: Number): Limit = order(Operator.LE, number)

/** Holds back percepts in which this argument has moved by less than [width]: `cm deadband 5`. See [Rate]. */
context(rule: TypedRule)
infix fun NumberArgument.deadband(width: Number) {
    specify()
    rule.conditions.deadband(index, width)
}

/** Requires [count] arguments: `arity(2)`. */
context(rule: TypedRule)
fun PerceptType.arity(count: Int): Unit = rule.conditions.arity(count)

/** Lets at most one percept through in [ms] milliseconds: `everyMs(500)`. See [Rate]. */
context(rule: TypedRule)
fun PerceptType.everyMs(ms: Long): Unit = rule.conditions.everyMs(ms)

/** Sets the interval of [everyMs] as a duration, a whole number of milliseconds: `every(2.seconds)`. */
context(rule: TypedRule)
fun PerceptType.every(interval: Duration): Unit = rule.conditions.every(interval)

/** Holds back a percept if none of its numbers has moved by [width] or more: `deadband(5)`. See [Rate]. */
context(rule: TypedRule)
fun PerceptType.deadband(width: Number): Unit = rule.conditions.deadband(width)

/** Requires an annotation called [name]: `hasAnnotation("urgent")`. */
context(rule: TypedRule)
fun PerceptType.hasAnnotation(name: String): Unit = rule.conditions.hasAnnotation(name)

/** Returns the annotations called [name]. At least one of these annotations must meet the test: `annotation("q") lt 0.5`. */
context(rule: TypedRule)
fun PerceptType.annotation(name: String): AnyAnnotation = rule.conditions.annotation(name)

/** Requires one annotation called [name] that meets all tests: `annotation("q") { gt(0.5); lt(0.9) }`. */
context(rule: TypedRule)
fun PerceptType.annotation(name: String, tests: AnnotationTests.() -> Unit): Unit = rule.conditions.annotation(name, tests)

context(rule: TypedRule)
private fun <V> TypedArgument<V>.compare(operator: Operator, value: V) = must(TermTest.Compare(operator, termOf(value)))

context(rule: TypedRule)
private fun NumberArgument.order(operator: Operator, number: Number): Limit {
    specify()
    return Limit(rule.conditions, Condition.Argument(index, TermTest.Compare(operator, termOf(number))))
}

context(rule: TypedRule)
private fun TypedArgument<*>.must(vararg tests: TermTest) {
    specify()
    tests.forEach { rule.conditions.add(Condition.Argument(index, it)) }
}

context(rule: TypedRule)
private fun TypedArgument<*>.specify() {
    require(type === rule.type) { "$this is an argument of ${type.predicate}, and the rule is on ${rule.type.predicate}" }
    rule.conditions.specify(this)
}
