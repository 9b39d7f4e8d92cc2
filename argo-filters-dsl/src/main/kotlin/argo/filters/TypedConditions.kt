/**
 * What can be said of the arguments of a declared percept type, each kind of which has words of its own. They are said in the block of a
 * rule, as in `drop(Distance) { cm gt 200 }`, and add to that rule.
 */
package argo.filters

/** A rule on a declared percept type under construction. The words of this file find it by themselves in the block of the rule. */
open class TypedRule internal constructor(internal val conditions: RuleConditions)

/** A critical rule on a declared percept type under construction. */
class TypedCriticalRule internal constructor(internal val critical: CriticalConditions) : TypedRule(critical)

/** The command [command] is sent when a percept comes that meets the rule: `reflex("stop")`; see [CriticalConditions.reflex]. */
context(rule: TypedCriticalRule)
fun PerceptType.reflex(command: String): Unit = rule.critical.reflex(command)

/** It is the atom [atom], as Jason writes it: `side eq "front"`. */
context(rule: TypedRule)
infix fun AtomArgument.eq(atom: String): Unit = rule.conditions.argument(index, Test.Compare(Operator.EQ, atomOf(atom)))

/** It is another atom than [atom]: `side ne "front"`. */
context(rule: TypedRule)
infix fun AtomArgument.ne(atom: String): Unit = rule.conditions.argument(index, Test.Compare(Operator.NE, atomOf(atom)))

/** It is one of [atoms]: `side isIn listOf("front", "back")`. */
context(rule: TypedRule)
infix fun AtomArgument.isIn(atoms: Collection<String>): Unit = rule.conditions.argument(index, Test.OneOf(atoms.map(::atomOf).toSet()))

/** Its whole text matches the regular expression [pattern]: `side matches "front|left"`; see [Test.Matches]. */
context(rule: TypedRule)
infix fun AtomArgument.matches(pattern: String): Unit = rule.conditions.argument(index, Test.Matches(pattern))

/** It equals [number]: `cm eq 36`. */
context(rule: TypedRule)
infix fun NumberArgument.eq(number: Number): Unit = compare(Operator.EQ, number)

/** It differs from [number]: `cm ne 0`. */
context(rule: TypedRule)
infix fun NumberArgument.ne(number: Number): Unit = compare(Operator.NE, number)

/** It is greater than [number]: `cm gt 200`. */
context(rule: TypedRule)
infix fun NumberArgument.gt(number: Number): Unit = compare(Operator.GT, number)

/** It is at least [number]: `cm ge 200`. */
context(rule: TypedRule)
infix fun NumberArgument.ge(number: Number): Unit = compare(Operator.GE, number)

/** It is less than [number]: `cm lt 15`. */
context(rule: TypedRule)
infix fun NumberArgument.lt(number: Number): Unit = compare(Operator.LT, number)

/** It is at most [number]: `cm le 15`. */
context(rule: TypedRule)
infix fun NumberArgument.le(number: Number): Unit = compare(Operator.LE, number)

/** It is one of [numbers]: `cm isIn listOf(0, 255)`. */
context(rule: TypedRule)
infix fun NumberArgument.isIn(numbers: Collection<Number>): Unit = rule.conditions.argument(index, Test.OneOf(numbers.map(Number::asValue).toSet()))

/** Percepts are held back of which it has not moved by [width]: `cm deadband 5`; see [Rate]. */
context(rule: TypedRule)
infix fun NumberArgument.deadband(width: Number): Unit = rule.conditions.deadband(index, width)

/** It is the string of [text], given without quotes: `message eq "low battery"`. */
context(rule: TypedRule)
infix fun StringArgument.eq(text: String): Unit = rule.conditions.argument(index, Test.Compare(Operator.EQ, Value.Text(text)))

/** It is another string than that of [text]: `message ne "ok"`. */
context(rule: TypedRule)
infix fun StringArgument.ne(text: String): Unit = rule.conditions.argument(index, Test.Compare(Operator.NE, Value.Text(text)))

/** It is the string of one of [texts]: `message isIn listOf("ok", "ready")`. */
context(rule: TypedRule)
infix fun StringArgument.isIn(texts: Collection<String>): Unit = rule.conditions.argument(index, Test.OneOf(texts.map(Value::Text).toSet()))

/** Its whole text, quotes included, matches the regular expression [pattern]: `message matches "\"low .*"`; see [Test.Matches]. */
context(rule: TypedRule)
infix fun StringArgument.matches(pattern: String): Unit = rule.conditions.argument(index, Test.Matches(pattern))

/** It equals [term], as Jason writes it: `position eq "pos(1,2)"`. */
context(rule: TypedRule)
infix fun TermArgument.eq(term: String): Unit = rule.conditions.argument(index, Test.Compare(Operator.EQ, Value.of(term)))

/** It differs from [term]: `position ne "pos(1,2)"`. */
context(rule: TypedRule)
infix fun TermArgument.ne(term: String): Unit = rule.conditions.argument(index, Test.Compare(Operator.NE, Value.of(term)))

/** It is one of [terms]: `position isIn listOf("pos(1,2)", "home")`. */
context(rule: TypedRule)
infix fun TermArgument.isIn(terms: Collection<String>): Unit = rule.conditions.argument(index, Test.OneOf(terms.map(Value::of).toSet()))

/** Its whole text matches the regular expression [pattern]: `position matches "pos[(]1,.*"`; see [Test.Matches]. */
context(rule: TypedRule)
infix fun TermArgument.matches(pattern: String): Unit = rule.conditions.argument(index, Test.Matches(pattern))

/** The percept must have [count] arguments: `arity(2)`. */
context(rule: TypedRule)
fun PerceptType.arity(count: Int): Unit = rule.conditions.arity(count)

/** Percepts are held back that come less than [ms] milliseconds after the one that was let through: `everyMs(500)`; see [Rate]. */
context(rule: TypedRule)
fun PerceptType.everyMs(ms: Long): Unit = rule.conditions.everyMs(ms)

/** Percepts are held back of which no number has moved by [width]: `deadband(5)`; see [Rate]. */
context(rule: TypedRule)
fun PerceptType.deadband(width: Number): Unit = rule.conditions.deadband(width)

/** The percept must have an annotation called [name]: `hasAnnotation("urgent")`. */
context(rule: TypedRule)
fun PerceptType.hasAnnotation(name: String): Unit = rule.conditions.hasAnnotation(name)

/** The annotations called [name], of which one must meet what is said of it: `annotation("q") lt 0.5`. */
context(rule: TypedRule)
fun PerceptType.annotation(name: String): AnyAnnotation = rule.conditions.annotation(name)

/** One annotation called [name] must meet all that is said: `annotation("q") { gt(0.5); lt(0.9) }`. */
context(rule: TypedRule)
fun PerceptType.annotation(name: String, tests: AnnotationTests.() -> Unit): Unit = rule.conditions.annotation(name, tests)

context(rule: TypedRule)
private fun NumberArgument.compare(operator: Operator, number: Number) = rule.conditions.argument(index, Test.Compare(operator, number.asValue()))

/** @throws IllegalArgumentException if [written] is no atom */
private fun atomOf(written: String): Value {
    val value = Value.of(written)
    require(value is Value.Structure && value.arguments.isEmpty() && value.annotations.isEmpty()) {
        "'$written' is not an atom, which the argument is declared to be"
    }
    return value
}
