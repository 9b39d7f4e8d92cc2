package argo.filters

import kotlin.time.Duration
import kotlin.time.Duration.Companion.milliseconds

/**
 * The conditions of one rule under construction. A percept must meet all conditions.
 *
 * ```kotlin
 * drop("dist") { argument(0) ne "front"; argument(1) gt 200; everyMs(500) }
 * ```
 */
@FilterDsl
open class RuleConditions internal constructor() {
    private val conditions = ArrayList<Condition>()
    private val deadbands = LinkedHashSet<Deadband>()
    private val unsaid = ArrayList<Any>()
    private var arity: Int? = null
    private var everyMs: Long? = null

    /** Returns the argument at [index], counted from 0, of any type: `argument(0) ne "front"`. */
    fun argument(index: Int): AnyArgument {
        requireIndex(index)
        return AnyArgument(index, this).also(::mention)
    }

    /** Returns the annotations called [name]. At least one of these annotations must meet the test: `annotation("q") lt 0.5`. */
    fun annotation(name: String): AnyAnnotation = AnyAnnotation(Predicate.of(name), this).also(::mention)

    /** Requires an annotation called [name]: `hasAnnotation("urgent")`. */
    fun hasAnnotation(name: String): Unit = annotation(name) {}

    /** Requires one annotation called [name] that meets all tests: `annotation("q") { gt(0.5); lt(0.9) }`. */
    fun annotation(name: String, tests: AnnotationTests.() -> Unit): Unit =
        add(Condition.Annotation(Predicate.of(name), AnnotationTests().apply(tests).tests))

    /**
     * Requires [count] arguments: `arity(2)`.
     *
     * @throws IllegalArgumentException if the rule already has another number
     */
    fun arity(count: Int) {
        require(arity == null || arity == count) { "the rule has the arity $arity already; write another rule for $count arguments" }
        arity = count
    }

    /**
     * Lets at most one percept through in [ms] milliseconds: `everyMs(500)`. See [Rate].
     *
     * @throws IllegalArgumentException if the rule already has another interval
     */
    fun everyMs(ms: Long) {
        require(everyMs == null || everyMs == ms) { "the rule has the interval $everyMs ms already; write another rule for $ms ms" }
        everyMs = ms
    }

    /**
     * Sets the interval of [everyMs] as a duration: `every(2.seconds)`.
     *
     * @throws IllegalArgumentException if [interval] is not a whole number of milliseconds, or the rule already has another interval
     */
    fun every(interval: Duration): Unit = everyMs(wholeMillis(interval))

    /** Holds back a percept if none of its numbers has moved by [width] or more: `deadband(5)`. See [Rate]. */
    fun deadband(width: Number): Unit = deadband(null, width)

    internal fun deadband(argument: Int?, width: Number) {
        deadbands += Deadband(argument, width.toDouble())
    }

    internal fun add(condition: Condition) {
        conditions += condition
    }

    internal fun replace(old: Condition, new: Condition) {
        conditions[conditions.indexOfLast { it === old }] = new
    }

    internal fun mention(term: Any) {
        unsaid += term
    }

    internal fun specify(term: Any) {
        unsaid.removeAll { it === term }
    }

    /** @throws IllegalArgumentException if the block names an argument or annotation without a condition */
    internal fun rule(predicate: Predicate): Rule {
        require(unsaid.isEmpty()) {
            "there is no condition on ${unsaid.joinToString(" and ")} in a rule on $predicate; expected a word like eq or gt after it"
        }
        val rate = if (everyMs == null && deadbands.isEmpty()) null else Rate(everyMs, deadbands)
        return Rule(predicate, conditions.toList(), arity, rate)
    }
}

/**
 * The conditions of a critical rule under construction, and its reflex. A critical rule can have neither [everyMs] nor a [deadband].
 *
 * ```kotlin
 * critical("dist") { argument(1) lt 15; reflex("stop") }
 * ```
 */
class CriticalConditions internal constructor() : RuleConditions() {
    private var reflex: String? = null
    private var smoothed = false

    /** Lets the rule test the percept that a smoothing rule selects, in place of the received percept. See [CriticalRule.smoothed]. */
    fun smoothed() {
        smoothed = true
    }

    /**
     * Sends [command] for a percept that meets the rule, before the agent reasons: `reflex("speed(0)")`. See [CriticalRule.reflex].
     *
     * @throws IllegalArgumentException if [command] cannot be sent, or the rule has a reflex already
     */
    fun reflex(command: String) {
        require(reflex == null) { "the rule has the reflex '$reflex' already; write another rule for '$command'" }
        CriticalRule.requireSendable(command)
        reflex = command
    }

    internal fun criticalRule(predicate: Predicate) = CriticalRule(rule(predicate), reflex, smoothed)
}

/**
 * A term of undeclared type: an argument or an annotation's value. Text is in Jason's syntax: `argument(0) eq "front"` compares with an
 * atom, and `argument(0) eq "\"front\""` compares with a string.
 *
 * @param L the result of a comparison by order. For an argument it is a [Limit], which can get a second limit
 */
@FilterDsl
sealed class AnyTerm<out L> {
    internal abstract fun must(vararg tests: TermTest)

    internal abstract fun order(test: TermTest.Compare): L

    /** Requires a term equal to [value], which is in Jason's syntax: `argument(0) eq "front"`. */
    infix fun eq(value: String): Unit = must(TermTest.Compare(Operator.EQ, GroundTerm.of(value)))

    /** Requires a term equal to [value]: `argument(1) eq 36`. */
    infix fun eq(value: Number): Unit = must(TermTest.Compare(Operator.EQ, value.asTerm()))

    /** Requires a term equal to [value]: `argument(0) eq GroundTerm.Text("low battery")`. */
    infix fun eq(value: GroundTerm): Unit = must(TermTest.Compare(Operator.EQ, value))

    /** Requires a term different from [value], which is in Jason's syntax: `argument(0) ne "front"`. */
    infix fun ne(value: String): Unit = must(TermTest.Compare(Operator.NE, GroundTerm.of(value)))

    /** Requires a term different from [value]: `argument(1) ne 0`. */
    infix fun ne(value: Number): Unit = must(TermTest.Compare(Operator.NE, value.asTerm()))

    /** Requires a term different from [value]: `argument(0) ne GroundTerm.Text("ok")`. */
    infix fun ne(value: GroundTerm): Unit = must(TermTest.Compare(Operator.NE, value))

    /** Requires a number greater than [value]: `argument(1) gt 200`. */
    infix fun gt(value: Number): L = order(TermTest.Compare(Operator.GT, value.asTerm()))

    /** Requires a number of at least [value]: `argument(1) ge 200`. */
    infix fun ge(value: Number): L = order(TermTest.Compare(Operator.GE, value.asTerm()))

    /** Requires a number less than [value]: `annotation("q") lt 0.5`. */
    infix fun lt(value: Number): L = order(TermTest.Compare(Operator.LT, value.asTerm()))

    /** Requires a number of at most [value]: `argument(1) le 15`. */
    infix fun le(value: Number): L = order(TermTest.Compare(Operator.LE, value.asTerm()))

    /**
     * Requires that the term's whole text matches the regular expression [pattern]: `argument(0) matches "front|left"`. See
     * [TermTest.Matches].
     */
    infix fun matches(pattern: String): Unit = must(TermTest.Matches(pattern))

    /**
     * Requires a term equal to one of [values]: texts in Jason's syntax, numbers or [GroundTerm]s.
     * `argument(0) isIn listOf("front", "left")`.
     */
    infix fun isIn(values: Collection<Any>): Unit = must(TermTest.OneOf(values.map(::valueOf).toSet()))

    /**
     * Requires a number in [range], both ends included: `argument(1) isIn 1..5` also holds for 2.5.
     *
     * @throws IllegalArgumentException if [range] is empty
     */
    infix fun <N> isIn(range: ClosedRange<N>): Unit where N : Number, N : Comparable<N> = must(*range.tests())

    private fun valueOf(value: Any): GroundTerm = when (value) {
        is GroundTerm -> value
        is Number -> value.asTerm()
        is String -> GroundTerm.of(value)
        else -> throw IllegalArgumentException(
            "$value (${value.javaClass.simpleName}) is no value; expected text, a number or a GroundTerm",
        )
    }
}

/** An argument of a rule under construction, as `argument(0)` returns it. */
class AnyArgument internal constructor(internal val index: Int, private val rule: RuleConditions) : AnyTerm<Limit>() {
    override fun must(vararg tests: TermTest) {
        rule.specify(this)
        tests.forEach { rule.add(Condition.Argument(index, it)) }
    }

    override fun order(test: TermTest.Compare): Limit {
        rule.specify(this)
        return Limit(rule, Condition.Argument(index, test))
    }

    /** Holds back percepts in which this argument has moved by less than [width]: `argument(1) deadband 5`. See [Rate]. */
    infix fun deadband(width: Number) {
        rule.specify(this)
        rule.deadband(index, width)
    }

    override fun toString(): String = "argument($index)"
}

/** An annotation of a rule under construction, as `annotation("q")` returns it. */
class AnyAnnotation internal constructor(private val name: Predicate, private val rule: RuleConditions) : AnyTerm<Unit>() {
    override fun must(vararg tests: TermTest) {
        rule.specify(this)
        rule.add(Condition.Annotation(name, tests.toList()))
    }

    override fun order(test: TermTest.Compare) = must(test)

    override fun toString(): String = "annotation(\"$name\")"
}

/** All tests of one annotation: `annotation("q") { gt(0.5); lt(0.9) }`. */
class AnnotationTests internal constructor() : AnyTerm<Unit>() {
    internal val tests = ArrayList<TermTest>()

    override fun must(vararg tests: TermTest) {
        this.tests += tests
    }

    override fun order(test: TermTest.Compare) = must(test)
}

/** A limit of a condition on an argument. It can get a second limit. */
class Limit internal constructor(private val rule: RuleConditions, private var condition: Condition.Argument) {
    init {
        rule.add(condition)
    }

    /**
     * Once a sensor's number has met the condition, the condition holds until the number reaches [limit]: `argument(1) lt 40 until 45`.
     * See [Condition.Argument.until].
     *
     * @throws IllegalArgumentException if [limit] is not beyond the first limit, or the condition has a second limit already
     */
    infix fun until(limit: Number) {
        val last = condition
        require(last.until == null) { "the condition '$last' has a second limit already; expected no other one, and not ${limit.asTerm()}" }
        condition = last.copy(until = limit.toDouble())
        rule.replace(last, condition)
    }
}

private fun wholeMillis(interval: Duration): Long = interval.inWholeMilliseconds.also {
    require(it.milliseconds == interval) { "the interval $interval is not a whole number of milliseconds" }
}

/** Returns tests that all numbers in the range meet, and no other terms. */
internal fun <N> ClosedRange<N>.tests(): Array<TermTest> where N : Number, N : Comparable<N> {
    require(!isEmpty()) { "the range $this is empty; expected the smaller number first" }
    return arrayOf(TermTest.Compare(Operator.GE, start.asTerm()), TermTest.Compare(Operator.LE, endInclusive.asTerm()))
}

internal fun Number.asTerm(): GroundTerm.Number = GroundTerm.Number(toDouble())
