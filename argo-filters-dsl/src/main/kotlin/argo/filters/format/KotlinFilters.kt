package argo.filters.format

import argo.filters.Condition
import argo.filters.CriticalRule
import argo.filters.Deadband
import argo.filters.GroundTerm
import argo.filters.PerceptionFilter
import argo.filters.Rule
import argo.filters.SmoothingRule
import argo.filters.TermTest
import argo.filters.usableName

/** Writes filters as Kotlin source. ARGO cannot read this source, only a Kotlin compiler can. */
object KotlinFilters {
    /**
     * Returns the text of a Kotlin file with LF line ends. The file's only property is an equal filter with an equal name.
     *
     * The property's name is the filter's name, in backquotes if Kotlin requires them. `_` replaces characters that a Java method or file
     * name cannot contain.
     *
     * @throws IllegalArgumentException if agents cannot call [filter] by its name
     */
    fun write(filter: PerceptionFilter): String = KotlinFilterWriter(filter).write()
}

internal class KotlinFilterWriter(private val filter: PerceptionFilter) {
    private val text = StringBuilder()

    fun write(): String {
        line(0, "import argo.filters.*")
        val freezes = filter.onSwitch == PerceptionFilter.OnSwitch.FREEZE
        if (freezes) line(0, "import argo.filters.PerceptionFilter.OnSwitch")
        line(0, "")
        val verb = filter.mode.name.lowercase()
        val onSwitch = if (freezes) ", OnSwitch.FREEZE" else ""
        line(0, "val ${kotlinName(filter.name)} = ${verb}Filter(${kotlinString(usableName(filter.name))}$onSwitch) {")
        filter.smoothing.forEach { rule("smooth", it.rule, smoothing(it)) }
        filter.critical.forEach { rule("critical", it.rule, critical(it)) }
        filter.rules.forEach { rule(verb, it) }
        line(0, "}")
        return text.toString()
    }

    private fun smoothing(rule: SmoothingRule): List<String> {
        val argument = "argument(${rule.argument})"
        return listOfNotNull(
            rule.maxRate?.let { "$argument maxRate ${number(it)}" },
            rule.outliers?.let { "$argument.outliers(${number(it.deviations)}, among = ${it.among})" },
            rule.median?.let { "$argument median $it" },
            "annotate()".takeIf { rule.annotates },
        )
    }

    private fun critical(rule: CriticalRule) =
        listOfNotNull("smoothed()".takeIf { rule.smoothed }, rule.reflex?.let { "reflex(${kotlinString(it)})" })

    private fun rule(verb: String, rule: Rule, own: List<String> = emptyList()) {
        val head = "$verb(${kotlinString("${rule.predicate}")})"
        val rate = rule.rate
        val statements = listOfNotNull(rule.arity?.let { "arity($it)" }, rate?.everyMs?.let { "everyMs($it)" }) +
            rate?.deadbands.orEmpty().map(::deadband) + rule.conditions.map(::condition) + own
        when (statements.size) {
            0 -> line(1, head)
            1 -> line(1, "$head { ${statements.single()} }")
            else -> {
                line(1, "$head {")
                statements.forEach { line(2, it) }
                line(1, "}")
            }
        }
    }

    private fun deadband(deadband: Deadband): String {
        val width = number(deadband.width)
        return if (deadband.argument == null) "deadband($width)" else "argument(${deadband.argument}) deadband $width"
    }

    private fun condition(condition: Condition): String = when (condition) {
        is Condition.Argument ->
            "argument(${condition.index}) ${infix(condition.test)}" + condition.until?.let { " until ${number(it)}" }.orEmpty()
        is Condition.Annotation -> annotation(kotlinString("${condition.name}"), condition.tests)
    }

    private fun annotation(name: String, tests: List<TermTest>): String = when (tests.size) {
        0 -> "hasAnnotation($name)"
        1 -> "annotation($name) ${infix(tests.single())}"
        else -> "annotation($name) { ${tests.joinToString("; ") { "${word(it)}(${value(it)})" }} }"
    }

    private fun infix(test: TermTest) = "${word(test)} ${value(test)}"

    private fun word(test: TermTest): String = when (test) {
        is TermTest.Compare -> test.operator.name.lowercase()
        is TermTest.OneOf -> "isIn"
        is TermTest.Matches -> "matches"
    }

    private fun value(test: TermTest): String = when (test) {
        is TermTest.Compare -> value(test.value)
        is TermTest.OneOf -> test.values.joinToString(", ", "listOf(", ")", transform = ::value)
        is TermTest.Matches -> kotlinString(test.pattern)
    }

    private fun value(value: GroundTerm): String =
        if (value is GroundTerm.Number) number(value.value) else kotlinString("$value")

    private fun number(value: Double): String = when (value) {
        Double.POSITIVE_INFINITY -> "Double.POSITIVE_INFINITY"
        Double.NEGATIVE_INFINITY -> "Double.NEGATIVE_INFINITY"
        else -> "${GroundTerm.Number(value)}"
    }

    private fun line(depth: Int, line: String) {
        text.append("    ".repeat(depth)).append(line).append('\n')
    }
}

internal fun kotlinString(text: String): String = text.toCharArray().joinToString("", "\"", "\"") { character ->
    when (character) {
        '"', '\\', '$' -> "\\$character"
        '\n' -> "\\n"
        '\r' -> "\\r"
        '\t' -> "\\t"
        else -> if (character.isISOControl() || character.isSurrogate()) "\\u%04X".format(character.code) else "$character"
    }
}

private val WORD = Regex("[A-Za-z_][A-Za-z0-9_]*")
private const val FOREIGN_TO_FILES = ".;[]/<>:\\`*?\"|"
private val HARD_KEYWORDS = setOf(
    "as", "break", "class", "continue", "do", "else", "false", "for", "fun", "if", "in", "interface", "is", "null", "object", "package",
    "return", "super", "this", "throw", "true", "try", "typealias", "typeof", "val", "var", "when", "while",
)

private fun kotlinName(name: String): String {
    val possible = name.map { if (it in FOREIGN_TO_FILES || it.isISOControl() || it.isSurrogate()) '_' else it }
        .joinToString("").ifBlank { "filter" }
    return if (possible.matches(WORD) && possible !in HARD_KEYWORDS && possible.any { it != '_' }) possible else "`$possible`"
}
