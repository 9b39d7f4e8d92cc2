package argo.filters

/**
 * Decides over percepts by a filter's rules.
 *
 * Immutable; any thread may use it. For percepts that are Jason literals there is `drops(Literal)`, an extension in this package.
 */
class PerceptMatcher internal constructor(val filter: PerceptionFilter) {
    private val rules: Map<Predicate, List<Rule>> = filter.rules.groupBy(Rule::predicate)

    /**
     * Whether the filter drops the percept that [percept] is the text of, as it came off the line: `dist(f,123)`.
     *
     * Text that is not a percept is kept, so that whoever reads it can report it. Never throws.
     */
    fun drops(percept: CharSequence): Boolean {
        if (rules.isEmpty()) return false
        val scanner = PerceptScanner(percept)
        return scanner.scan() && dropping(scanner.predicate()) { meets(it, percept, scanner) }
    }

    internal inline fun dropping(predicate: Predicate, meets: (Condition) -> Boolean): Boolean =
        rules[predicate]?.any { rule -> rule.conditions.all(meets) } == true

    private fun meets(condition: Condition, text: CharSequence, percept: PerceptScanner): Boolean = when (condition) {
        is Condition.Argument -> condition.index < percept.arguments.size &&
            meets(condition.test, value(text, percept.arguments, condition.index))
        is Condition.Annotation -> (0 until percept.annotations.size).any {
            meets(condition, value(text, percept.annotations, it))
        }
    }

    private fun value(text: CharSequence, bounds: PerceptScanner.Bounds, index: Int): Value? =
        ValueReader(text, bounds.start(index), bounds.end(index)).readWhole()

    internal fun meets(condition: Condition.Annotation, annotation: Value?): Boolean {
        if (annotation !is Value.Structure || annotation.predicate != condition.name) return false
        val value = annotation.arguments.firstOrNull()
        return condition.tests.all { meets(it, value) }
    }

    internal fun meets(test: Test, value: Value?): Boolean = value != null && when (test) {
        is Test.Compare -> compares(test.operator, value, test.value)
    }

    private fun compares(operator: Operator, found: Value, wanted: Value): Boolean = when (operator) {
        Operator.EQ -> found == wanted
        Operator.NE -> found != wanted
        else -> found is Value.Number && wanted is Value.Number && ordered(operator, found.value, wanted.value)
    }

    private fun ordered(operator: Operator, found: Double, wanted: Double): Boolean = when (operator) {
        Operator.GT -> found > wanted
        Operator.GE -> found >= wanted
        Operator.LT -> found < wanted
        else -> found <= wanted
    }
}
