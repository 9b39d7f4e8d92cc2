package argo.filters

/**
 * One rule of a filter: a percept of this [predicate] that meets all [conditions] is met by the rule.
 *
 * @property conditions may be empty: then the rule meets every percept of the predicate
 */
data class Rule(val predicate: Predicate, val conditions: List<Condition> = emptyList()) {

    constructor(predicate: String, vararg conditions: Condition) : this(Predicate.of(predicate), conditions.toList())

    /** The rule in words: `distance where argument 0 is not front`. */
    override fun toString(): String =
        if (conditions.isEmpty()) "$predicate" else conditions.joinToString(" and ", "$predicate where ")
}

/**
 * A perception filter: percepts that one of its [rules] meets are dropped, all others are kept.
 *
 * Immutable, and safe to share between agents. Two filters are equal if they say the same; the [name] is how a filter is found, not what
 * it does, and has no part in it.
 *
 * @property name what agents call the filter
 */
class PerceptionFilter(val name: String, rules: List<Rule>) {
    val rules: List<Rule> = java.util.List.copyOf(rules)

    constructor(name: String, vararg rules: Rule) : this(name, rules.asList())

    override fun equals(other: Any?): Boolean = other is PerceptionFilter && rules == other.rules
    override fun hashCode(): Int = rules.hashCode()

    /** The filter in words: `filter frontDistance drops temperature; light; distance where argument 0 is not front`. */
    override fun toString(): String =
        if (rules.isEmpty()) "filter $name drops nothing" else rules.joinToString("; ", "filter $name drops ")
}

/** Compiles the filter. The matcher is to be made once and used for every percept. */
fun PerceptionFilter.matcher(): PerceptMatcher = PerceptMatcher(this)
