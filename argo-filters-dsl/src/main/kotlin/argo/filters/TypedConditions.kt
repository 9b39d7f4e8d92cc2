/* Conditions on arguments of a declared percept type. Each is added to the rule of its block: `drop(Distance) { cm gt 9 }`. */
package argo.filters

import kotlin.time.Duration

/** A rule under construction, on a declared percept type: the context parameter of the functions in this file. */
open class TypedRule internal constructor(internal val type: PerceptType, internal val conditions: RuleConditions)

/** A critical rule under construction, on a declared percept type. */
class TypedCriticalRule internal constructor(type: PerceptType, internal val critical: CriticalConditions) : TypedRule(type, critical)

/** A smoothing rule under construction, on a declared percept type. */
class TypedSmoothingRule internal constructor(type: PerceptType, internal val smoothing: SmoothingConditions) : TypedRule(type, smoothing)

/** The rule tests the percept that a smoothing rule selects: `smoothed()`; see [CriticalRule.smoothed]. */
context(rule: TypedCriticalRule)
fun PerceptType.smoothed(): Unit = rule.critical.smoothed()

/** Selects the middle one of the last [count] credible percepts: `cm median 5`; see [SmoothingRule.median]. */
context(rule: TypedSmoothingRule)
infix fun NumberArgument.median(count: Int) {
    specify()
    rule.smoothing.median(index, count)
}

/** A percept is not credible if its number changed faster than [perSecond] a second: `cm maxRate 200`; see [SmoothingRule.maxRate]. */
context(rule: TypedSmoothingRule)
infix fun NumberArgument.maxRate(perSecond: Number) {
    specify()
    rule.smoothing.maxRate(index, perSecond)
}

/** A percept is not credible if its number is far from the median of the last [among] numbers: `cm.outliers(3)`; see [Outliers]. */
context(rule: TypedSmoothingRule)
fun NumberArgument.outliers(deviations: Number, among: Int = Outliers.AMONG) {
    specify()
    rule.smoothing.outliers(index, deviations, among)
}

/** Selected percepts get the annotation `smoothed`: `annotate()`. */
context(rule: TypedSmoothingRule)
fun PerceptType.annotate(): Unit = rule.smoothing.annotate()

/** Sends [command] for a percept that meets the rule: `reflex("stop")`; see [CriticalConditions.reflex]. */
context(rule: TypedCriticalRule)
fun PerceptType.reflex(command: String): Unit = rule.critical.reflex(command)

/** The argument must equal [value]: `side eq "front"`, `cm eq 36`, `position eq "pos(1,2)"`. A string has no quotes here. */
context(rule: TypedRule)
infix fun <V> TypedArgument<V>.eq(value: V): Unit = compare(Operator.EQ, value)

/** The argument must differ from [value]: `side ne "front"`. */
context(rule: TypedRule)
infix fun <V> TypedArgument<V>.ne(value: V): Unit = compare(Operator.NE, value)

/** The argument must be one of [values]: `side isIn listOf("front", "back")`, `cm isIn listOf(0, 255)`. */
context(rule: TypedRule)
infix fun <V> TypedArgument<V>.isIn(values: Collection<V>): Unit = must(TermTest.OneOf(values.map(termOf).toSet()))

/** The argument must be in [range], both ends included: `cm isIn 1..5` holds for 2.5, too. An empty range is refused. */
context(rule: TypedRule)
infix fun <N> NumberArgument.isIn(range: ClosedRange<N>): Unit where N : Number, N : Comparable<N> = must(*range.tests())

/** The argument's whole text, quotes included, must match the regular expression [pattern] ([TermTest.Matches]): `side matches "a|b"`. */
context(rule: TypedRule)
infix fun TypedArgument<String>.matches(pattern: String): Unit = must(TermTest.Matches(pattern))

/** The argument must be greater than [number]: `cm gt 200`. */
context(rule: TypedRule)
infix fun NumberArgument.gt(number: Number): Limit = order(Operator.GT, number)

/** The argument must be at least [number]: `cm ge 200`. */
context(rule: TypedRule)
infix fun NumberArgument.ge(number: Number): Limit = order(Operator.GE, number)

/** The argument must be less than [number]: `cm lt 15`. */
context(rule: TypedRule)
infix fun NumberArgument.lt(number: Number): Limit = order(Operator.LT, number)

/** The argument must be at most [number]: `cm le 15`. */
context(rule: TypedRule)
infix fun NumberArgument.le(number: Number): Limit = order(Operator.LE, number)

/** Holds back percepts in which this argument has moved by less than [width]: `cm deadband 5`; see [Rate]. */
context(rule: TypedRule)
infix fun NumberArgument.deadband(width: Number) {
    specify()
    rule.conditions.deadband(index, width)
}

/** The percept must have [count] arguments: `arity(2)`. */
context(rule: TypedRule)
fun PerceptType.arity(count: Int): Unit = rule.conditions.arity(count)

/** Holds back percepts that come less than [ms] milliseconds after the last percept that was let through: `everyMs(500)`; see [Rate]. */
context(rule: TypedRule)
fun PerceptType.everyMs(ms: Long): Unit = rule.conditions.everyMs(ms)

/** Sets the interval of [everyMs] by a duration: `every(2.seconds)`, a whole number of milliseconds. */
context(rule: TypedRule)
fun PerceptType.every(interval: Duration): Unit = rule.conditions.every(interval)

/** Holds back percepts in which each number has moved by less than [width]: `deadband(5)`; see [Rate]. */
context(rule: TypedRule)
fun PerceptType.deadband(width: Number): Unit = rule.conditions.deadband(width)

/** The percept must have an annotation called [name]: `hasAnnotation("urgent")`. */
context(rule: TypedRule)
fun PerceptType.hasAnnotation(name: String): Unit = rule.conditions.hasAnnotation(name)

/** The annotations called [name]. At least one of them must meet the test: `annotation("q") lt 0.5`. */
context(rule: TypedRule)
fun PerceptType.annotation(name: String): AnyAnnotation = rule.conditions.annotation(name)

/** One annotation called [name] must meet all tests: `annotation("q") { gt(0.5); lt(0.9) }`. */
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
