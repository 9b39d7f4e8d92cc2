package argo.filters.format

import argo.filters.AnyArgument
import argo.filters.AnyTerm
import argo.filters.Condition
import argo.filters.CriticalRule
import argo.filters.GroundTerm
import argo.filters.Limit
import argo.filters.Operator
import argo.filters.PerceptionFilter
import argo.filters.Rule
import argo.filters.RuleConditions
import argo.filters.RuleList
import argo.filters.SmoothingRule
import argo.filters.TermTest
import argo.filters.dropFilter
import argo.filters.filters
import argo.filters.jason.perceptText
import argo.filters.keepFilter
import argo.filters.matching.FilterSession
import argo.filters.matching.matcher
import argo.filters.perceptTexts
import io.kotest.core.NamedTag
import io.kotest.core.Tag
import io.kotest.core.spec.style.StringSpec
import io.kotest.core.spec.style.stringSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.matchers.shouldNotBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll
import jason.asSyntax.ASSyntax

/** Writes a filter in one form and reads it back. */
private typealias Form = (PerceptionFilter) -> PerceptionFilter

/**
 * Tests that every form of filters must pass. [form] writes a filter in one form and reads it back. Equal filters drop the same percepts, so
 * the tests of what a filter drops have the given tags.
 */
private fun parity(tags: Set<Tag> = setOf(NamedTag("Thorough")), form: Form) = stringSpec {
    "a filter comes back equal" { checkAll(filters) { form(it) shouldBe it } }

    "a filter that came back drops exactly what it dropped, as text and as literals".config(tags = tags) {
        checkAll(filters, Arb.list(perceptTexts, 0..12)) { filter, percepts ->
            val expected = percepts.filterNot(filter.matcher()::drops)
            val matcher = form(filter).matcher()
            percepts.filterNot(matcher::drops) shouldContainExactly expected
            percepts.filterNot { matcher.drops(perceptText(ASSyntax.parseLiteral(it))) } shouldContainExactly expected
        }
    }

    "a filter that came back holds back exactly what it held back".config(tags = tags) {
        checkAll(200, filters, Arb.list(Arb.list(perceptTexts, 0..5), 1..6)) { filter, snapshots ->
            fun run(filter: PerceptionFilter) = FilterSession.ofTexts().let { session ->
                session.switchTo(filter)
                snapshots.mapIndexed { number, percepts ->
                    session.perceive(percepts, number * 300L).let { Triple(it.kept, it.nextDueMs, it.critical) }
                }
            }
            run(form(filter)) shouldBe run(filter)
        }
    }
}

/** A filter rewritten with the Kotlin functions, in a person's style. */
private fun inKotlin(filter: PerceptionFilter): PerceptionFilter {
    fun AnyTerm<*>.say(test: TermTest) = when (test) {
        is TermTest.Compare -> compare(test)
        is TermTest.OneOf -> isIn(test.values)
        is TermTest.Matches -> matches(test.pattern)
    }
    fun RuleConditions.say(rule: Rule) {
        rule.arity?.let(::arity)
        rule.rate?.everyMs?.let(::everyMs)
        rule.rate?.deadbands?.forEach { deadband ->
            deadband.argument?.let { argument(it) deadband deadband.width } ?: deadband(deadband.width)
        }
        rule.conditions.forEach { condition ->
            when (condition) {
                is Condition.Argument -> argument(condition.index).let { argument ->
                    condition.until?.let { argument.limit(condition.test as TermTest.Compare) until it } ?: argument.say(condition.test)
                }
                is Condition.Annotation -> annotation("${condition.name}") { condition.tests.forEach { say(it) } }
            }
        }
    }
    fun RuleList.sayCritical() = filter.critical.forEach { critical ->
        critical("${critical.rule.predicate}") {
            say(critical.rule)
            critical.reflex?.let(::reflex)
            if (critical.smoothed) smoothed()
        }
    }
    fun RuleList.saySmoothing() = filter.smoothing.forEach { smoothing ->
        smooth("${smoothing.rule.predicate}") {
            say(smoothing.rule)
            smoothing.maxRate?.let { argument(smoothing.argument) maxRate it }
            smoothing.outliers?.let { argument(smoothing.argument).outliers(it.deviations, it.among) }
            smoothing.median?.let { argument(smoothing.argument) median it }
            if (smoothing.annotates) annotate()
        }
    }
    return when (filter.mode) {
        PerceptionFilter.Mode.DROP -> dropFilter(filter.name, filter.onSwitch) {
            filter.rules.forEach { rule -> drop("${rule.predicate}") { say(rule) } }
            sayCritical()
            saySmoothing()
        }
        PerceptionFilter.Mode.KEEP -> keepFilter(filter.name, filter.onSwitch) {
            filter.rules.forEach { rule -> keep("${rule.predicate}") { say(rule) } }
            sayCritical()
            saySmoothing()
        }
    }
}

private fun AnyArgument.limit(test: TermTest.Compare): Limit {
    val number = (test.value as GroundTerm.Number).value
    return when (test.operator) {
        Operator.GT -> gt(number)
        Operator.GE -> ge(number)
        Operator.LT -> lt(number)
        else -> le(number)
    }
}

private fun AnyTerm<*>.compare(test: TermTest.Compare) {
    val number = (test.value as? GroundTerm.Number)?.value
    when (test.operator) {
        Operator.EQ -> if (number != null) eq(number) else eq("${test.value}")
        Operator.NE -> if (number != null) ne(number) else ne("${test.value}")
        Operator.GT -> gt(number!!)
        Operator.GE -> ge(number!!)
        Operator.LT -> lt(number!!)
        Operator.LE -> le(number!!)
    }
}

class FilterParitySpec : StringSpec({
    include("XML: ", parity { XmlFilters.read(XmlFilters.write(it), "f.xml") })
    include("JSON: ", parity { JsonFilters.read(JsonFilters.write(it), "f.json") })
    include("Kotlin: ", parity(form = ::inKotlin))
    include(
        "all three in turn: ",
        parity(emptySet()) { inKotlin(JsonFilters.read(JsonFilters.write(XmlFilters.read(XmlFilters.write(it), "f.xml")), "f.json")) },
    )

    "filters that differ in anything but their names are not equal" {
        val rules = listOf(Rule("dist"))
        val filter = PerceptionFilter("a", rules)
        PerceptionFilter("b", rules) shouldBe filter
        for (other in listOf(
            PerceptionFilter("a"),
            PerceptionFilter("a", rules, PerceptionFilter.Mode.KEEP),
            PerceptionFilter("a", rules, onSwitch = PerceptionFilter.OnSwitch.FREEZE),
            PerceptionFilter("a", rules, critical = listOf(CriticalRule(Rule("dist")))),
            PerceptionFilter("a", rules, smoothing = listOf(SmoothingRule(Rule("dist"), 1, median = 3))),
        )) other shouldNotBe filter
    }

    "the paper's filter is one filter in all forms" {
        val kotlin = dropFilter("frontDistance") {
            drop("temperature")
            drop("light")
            drop("distance") { argument(0) ne "front" }
        }
        val xml = """
            <?xml version="1.0"?>
            <PerceptionFilter>
              <filter><predicate>temperature</predicate></filter>
              <filter><predicate>light</predicate></filter>
              <filter><predicate>distance</predicate><parameter operator="NE" id="0">front</parameter></filter>
            </PerceptionFilter>
        """.trimIndent()
        val json = """
            {"rules": [
              {"predicate": "temperature"},
              {"predicate": "light"},
              {"predicate": "distance", "conditions": [{"argument": 0, "operator": "NE", "value": "front"}]}
            ]}
        """
        XmlFilters.read(xml, "frontDistance.xml") shouldBe kotlin
        JsonFilters.read(json, "frontDistance.json") shouldBe kotlin
        XmlFilters.read(xml, "frontDistance.xml").hashCode() shouldBe kotlin.hashCode()
    }
})
