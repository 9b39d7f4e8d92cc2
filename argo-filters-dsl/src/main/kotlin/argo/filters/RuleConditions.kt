package argo.filters

/** The conditions of one rule under construction, all of which a percept must meet. */
@FilterDsl
open class RuleConditions internal constructor() {
    private val conditions = ArrayList<Condition>()
    private val deadbands = LinkedHashSet<Deadband>()
    private val begun = ArrayList<AnyTerm>()
    private var arity: Int? = null
    private var everyMs: Long? = null

    /** The argument at [index], counted from 0, of whatever type: `argument(0) ne "front"`. */
    fun argument(index: Int): AnyArgument {
        requireIndex(index)
        return AnyArgument(index, this).also(begun::add)
    }

    /** The annotations called [name], of which one must meet what is said of it: `annotation("q") lt 0.5`. */
    fun annotation(name: String): AnyAnnotation = AnyAnnotation(Predicate.of(name), this).also(begun::add)

    /** The percept must have an annotation called [name]. */
    fun hasAnnotation(name: String) {
        conditions += Condition.Annotation(Predicate.of(name))
    }

    /** One annotation called [name] must meet all that is said: `annotation("q") { gt(0.5); lt(0.9) }`. */
    fun annotation(name: String, tests: AnnotationTests.() -> Unit) {
        conditions += Condition.Annotation(Predicate.of(name), AnnotationTests().apply(tests).tests)
    }

    /** The percept must have [count] arguments. */
    fun arity(count: Int) {
        arity = count
    }

    /** Percepts are held back that come less than [ms] milliseconds after the one that was let through; see [Rate]. */
    fun everyMs(ms: Long) {
        everyMs = ms
    }

    /** Percepts are held back of which no number has moved by [width]; see [Rate]. */
    fun deadband(width: Number) {
        deadband(null, width)
    }

    internal fun deadband(argument: Int?, width: Number) {
        deadbands += Deadband(argument, width.toDouble())
    }

    internal fun argument(index: Int, test: Test) {
        conditions += Condition.Argument(index, test)
    }

    internal fun annotation(name: Predicate, test: Test) {
        conditions += Condition.Annotation(name, listOf(test))
    }

    /** @throws IllegalArgumentException if there is an argument or annotation of which nothing is said, which would be a condition lost */
    internal fun rule(predicate: Predicate): Rule {
        val forgotten = begun.find { !it.isSaid }
        require(forgotten == null) { "nothing is said of $forgotten in a rule on $predicate; expected a word like eq or gt after it" }
        val rate = if (everyMs == null && deadbands.isEmpty()) null else Rate(everyMs, deadbands)
        return Rule(predicate, conditions.toList(), arity, rate)
    }
}

/** The conditions of a critical rule under construction, and its reflex. It can have neither [everyMs] nor a [deadband]. */
class CriticalConditions internal constructor() : RuleConditions() {
    private var reflex: String? = null

    /**
     * The command [command] is sent when a percept comes that meets the rule, before the agent reasons; see [CriticalRule.reflex].
     *
     * @throws IllegalArgumentException if [command] cannot be sent, or the rule has a reflex already
     */
    fun reflex(command: String) {
        require(reflex == null) { "a critical rule has one reflex, and '$reflex' is it; expected another rule for '$command'" }
        CriticalRule.requireSendable(command)
        reflex = command
    }

    internal fun criticalRule(predicate: Predicate) = CriticalRule(rule(predicate), reflex)
}

/**
 * A term whose type is not declared: an argument or an annotation's value.
 *
 * Text is read as Jason reads it: `"front"` is an atom, `"\"front\""` a string.
 */
@FilterDsl
sealed class AnyTerm {
    /** Whether something is said of it. */
    internal var isSaid = false

    private fun must(test: Test) {
        isSaid = true
        add(test)
    }

    internal abstract fun add(test: Test)

    /** It equals [value], a Jason term. */
    infix fun eq(value: String): Unit = must(Test.Compare(Operator.EQ, Value.of(value)))

    /** It equals [value]. */
    infix fun eq(value: Number): Unit = must(Test.Compare(Operator.EQ, value.asValue()))

    /** It equals [value]. */
    infix fun eq(value: Value): Unit = must(Test.Compare(Operator.EQ, value))

    /** It differs from [value], a Jason term. */
    infix fun ne(value: String): Unit = must(Test.Compare(Operator.NE, Value.of(value)))

    /** It differs from [value]. */
    infix fun ne(value: Number): Unit = must(Test.Compare(Operator.NE, value.asValue()))

    /** It differs from [value]. */
    infix fun ne(value: Value): Unit = must(Test.Compare(Operator.NE, value))

    /** It is a number greater than [value]. */
    infix fun gt(value: Number): Unit = must(Test.Compare(Operator.GT, value.asValue()))

    /** It is a number, and at least [value]. */
    infix fun ge(value: Number): Unit = must(Test.Compare(Operator.GE, value.asValue()))

    /** It is a number less than [value]. */
    infix fun lt(value: Number): Unit = must(Test.Compare(Operator.LT, value.asValue()))

    /** It is a number, and at most [value]. */
    infix fun le(value: Number): Unit = must(Test.Compare(Operator.LE, value.asValue()))

    /** Its whole text matches the regular expression; see [Test.Matches]. */
    infix fun matches(pattern: String): Unit = must(Test.Matches(pattern))

    /** It equals one of [values]: Jason terms as text, numbers or [Value]s. */
    infix fun isIn(values: Collection<Any>): Unit = must(Test.OneOf(values.map(::valueOf).toSet()))

    private fun valueOf(value: Any): Value = when (value) {
        is Value -> value
        is Number -> value.asValue()
        is String -> Value.of(value)
        else -> throw IllegalArgumentException("$value (${value.javaClass.simpleName}) is no value; expected text, a number or a Value")
    }
}

/** An argument of a rule under construction. */
class AnyArgument internal constructor(private val index: Int, private val rule: RuleConditions) : AnyTerm() {
    override fun add(test: Test) = rule.argument(index, test)

    /** Percepts are held back of which this argument has not moved by [width]; see [Rate]. */
    infix fun deadband(width: Number) {
        isSaid = true
        rule.deadband(index, width)
    }

    override fun toString(): String = "argument($index)"
}

/** An annotation of a rule under construction. */
class AnyAnnotation internal constructor(private val name: Predicate, private val rule: RuleConditions) : AnyTerm() {
    override fun add(test: Test) = rule.annotation(name, test)

    override fun toString(): String = "annotation(\"$name\")"
}

/** All that is said of one annotation. */
class AnnotationTests internal constructor() : AnyTerm() {
    internal val tests = ArrayList<Test>()

    override fun add(test: Test) {
        tests += test
    }
}

internal fun Number.asValue(): Value.Number = Value.Number(toDouble())
