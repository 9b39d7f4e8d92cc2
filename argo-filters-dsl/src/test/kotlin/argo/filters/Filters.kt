package argo.filters

import argo.filters.format.XmlFilters
import argo.filters.matching.PerceptMatcher
import argo.filters.matching.matcher
import io.kotest.property.Arb
import io.kotest.property.arbitrary.bind
import io.kotest.property.arbitrary.boolean
import io.kotest.property.arbitrary.choice
import io.kotest.property.arbitrary.constant
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.enum
import io.kotest.property.arbitrary.filter
import io.kotest.property.arbitrary.flatMap
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.long
import io.kotest.property.arbitrary.map
import io.kotest.property.arbitrary.numericDouble
import io.kotest.property.arbitrary.orNull
import io.kotest.property.arbitrary.string

fun xml(rules: String): PerceptionFilter = XmlFilters.read("<PerceptionFilter>$rules</PerceptionFilter>", "test.xml")

/** A filter with one rule on [predicate]. [conditions] is the XML of its conditions. */
fun rule(predicate: String, conditions: String = ""): PerceptMatcher =
    xml("<filter><predicate>$predicate</predicate>$conditions</filter>").matcher()

/** Few values, so filters often match percepts. */
val functors = Arb.element("dist", "light", "open", "'Left wheel'", "x_1", "begin", "'two\nlines'", "'a\tb\r'", "'<&>'", "'x::y'")
val predicates: Arb<Predicate> = Arb.bind(
    functors, Arb.element(false, false, true), Arb.element("default", "default", "default", "default", "house", "'a::b'"),
) { functor, negated, namespace ->
    Predicate(functor, negated, namespace)
}

val numbers: Arb<GroundTerm.Number> = Arb.choice(
    Arb.int(-3..3).map(Int::toDouble),
    Arb.element(0.5, -0.5, 36.0, 1e10, 1e300, 5e-324, 123456789012345680.0),
    Arb.numericDouble(),
).map(GroundTerm::Number)

val texts: Arb<GroundTerm.Text> = Arb.choice(
    Arb.element(
        "", "front", "a,b", "]", ")", "(", "say \"hi\"", "line\nbreak", "\\t", "// no comment", "é 漢 \uD83D\uDE00", "'", ";", "<&>]]>",
    ),
    Arb.string(0..6).filter { "\\u" !in "${GroundTerm.Text(it)}" && it.none(Char::isISOControl) }, // Jason's parser must be able to read it
).map(GroundTerm::Text)

fun values(depth: Int = 2): Arb<GroundTerm> {
    val leaves = listOf<Arb<GroundTerm>>(
        numbers.map { it }, texts.map { it }, predicates.map { GroundTerm.Structure(it) },
        Arb.element("front", "back", "true", "false").map(GroundTerm::of),
    )
    if (depth == 0) return Arb.choice(leaves)
    val items = Arb.list(values(depth - 1), 0..3)
    val lists: Arb<GroundTerm> = items.map(GroundTerm::Sequence)
    val structures: Arb<GroundTerm> = Arb.bind(predicates, items, Arb.list(values(depth - 1), 0..2)) { predicate, arguments, annotations ->
        GroundTerm.Structure(predicate, arguments, annotations.toSet())
    }
    return Arb.choice(leaves + leaves + lists + structures)
}

val comparisons: Arb<TermTest> = Arb.enum<Operator>().flatMap { operator ->
    val values: Arb<GroundTerm> = if (operator.ordering) numbers.map { it } else values()
    values.map { TermTest.Compare(operator, it) }
}

val tests: Arb<TermTest> = Arb.choice(
    comparisons,
    comparisons,
    Arb.list(values(), 1..3).map { TermTest.OneOf(it.toSet()) },
    Arb.element("front", "f.*|b.*", "-?\\d+", "\"[^\"]*\"", ".*[(\\[].*", "a\nb|<&>", "(?i)FRONT", "[ ]x").map { TermTest.Matches(it) },
)

/** Tests that compare by order, each with a limit beyond its own. */
private val limits: Arb<Pair<TermTest, Double>> =
    Arb.bind(Arb.element(Operator.entries.filter { it.ordering }), Arb.int(-3..3), Arb.element(0.5, 2.0)) { operator, limit, width ->
        val isBelow = operator == Operator.LT || operator == Operator.LE
        TermTest.Compare(operator, GroundTerm.Number(limit.toDouble())) to if (isBelow) limit + width else limit - width
    }

val conditions: Arb<Condition> = Arb.choice(
    Arb.bind(Arb.int(0..2), tests) { index, test -> Condition.Argument(index, test) },
    Arb.bind(Arb.int(0..2), limits) { index, (test, until) -> Condition.Argument(index, test, until) },
    Arb.bind(predicates, Arb.list(tests, 0..2)) { name, tests -> Condition.Annotation(name, tests) },
)

private val intervals: Arb<Long> = Arb.choice(Arb.long(1L..2_000), Arb.long(1L..2_000), Arb.element(Int.MAX_VALUE + 1L, Long.MAX_VALUE))

val rates: Arb<Rate> =
    Arb.bind(intervals.orNull(), Arb.list(Arb.int(0..2).orNull(), 0..2), Arb.element(0.5, 1.0, 1e6)) { everyMs, arguments, width ->
        val deadbands = arguments.toSet().map { Deadband(it, width) }.toSet()
        Rate(if (deadbands.isEmpty()) everyMs ?: 1 else everyMs, deadbands)
    }

/** Rules without rates. Each percept is decided alone. */
val timelessRules: Arb<Rule> = Arb.bind(predicates, Arb.list(conditions, 0..2), Arb.int(0..3).orNull(0.7)) { predicate, conditions, arity ->
    Rule(predicate, conditions, arity)
}

val rules: Arb<Rule> = Arb.bind(timelessRules, rates.orNull(0.7)) { rule, rate -> rule.copy(rate = rate) }

val criticalRules: Arb<CriticalRule> = Arb.bind(
    timelessRules, Arb.element("stop", "speed(120)", "say(\"hi; <&> 'you'\")", "é", "a  b").orNull(0.3), Arb.boolean(), ::CriticalRule,
)

private val windows = Arb.element(3, 5, 99)

val smoothingRules: Arb<SmoothingRule> = Arb.bind(
    timelessRules, Arb.int(0..2), Arb.element(0.5, 200.0, 1e6).orNull(), Arb.bind(Arb.element(1.0, 2.5), windows, ::Outliers).orNull(),
    windows, Arb.boolean(),
) { rule, argument, maxRate, outliers, median, annotates ->
    val conditions = rule.conditions.filterNot { it is Condition.Argument && it.until != null }
    SmoothingRule(
        rule.copy(conditions = conditions), argument, maxRate, outliers,
        median.takeIf { annotates || maxRate == null && outliers == null }, annotates,
    )
}

val filters: Arb<PerceptionFilter> = Arb.bind(
    Arb.list(rules, 0..6), Arb.enum<PerceptionFilter.Mode>(), Arb.enum<PerceptionFilter.OnSwitch>(), Arb.list(criticalRules, 0..2),
    Arb.list(smoothingRules, 0..2),
) { rules, mode, onSwitch, critical, smoothing -> PerceptionFilter("generated", rules, mode, onSwitch, critical, smoothing) }

/** The parts of a percept. Its annotations are structures, in order. */
data class Percept(val predicate: Predicate, val arguments: List<GroundTerm>, val annotations: List<GroundTerm>)

val percepts: Arb<Percept> = Arb.bind(predicates, Arb.list(values(), 0..3), Arb.list(values(1), 0..2), ::Percept)

/** White space and comments between the tokens of a percept. */
val blanks: Arb<String> =
    Arb.choice(Arb.constant(""), Arb.constant(""), Arb.element(" ", "\t", "\n", " \r\n ", "/* , ) */", "// ]\n", "/***/"))

val perceptTexts: Arb<String> = Arb.bind(percepts, Arb.list(blanks, 16..16), Arb.boolean()) { percept, blanks, spaced ->
    var next = 0
    fun blank() = if (spaced) blanks[next++ % blanks.size] else ""
    fun group(open: String, terms: List<GroundTerm>, close: String) =
        if (terms.isEmpty()) "" else terms.joinToString(",", open, close) { blank() + it + blank() }
    blank() + percept.predicate + blank() + group("(", percept.arguments, ")") + blank() + group("[", percept.annotations, "]") + blank()
}
