package argo.filters.matching

import argo.filters.Condition
import argo.filters.Deadband
import argo.filters.GroundTerm
import argo.filters.Operator
import argo.filters.PerceptionFilter
import argo.filters.Predicate
import argo.filters.Rate
import argo.filters.Rule
import argo.filters.RuleConditions
import argo.filters.TermTest
import argo.filters.dropFilter
import argo.filters.filters
import argo.filters.jason.perceptText
import argo.filters.matching.Explanation.Outcome
import argo.filters.perceptTexts
import io.kotest.core.spec.style.StringSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.PropertyTesting
import io.kotest.property.checkAll
import jason.asSyntax.ASSyntax

class ExplanationSpec : StringSpec({
    val rules = listOf(Rule("light"), Rule("dist", Condition.Argument(0, TermTest.Compare(Operator.NE, GroundTerm.of("f")))))
    val dropping = PerceptionFilter("front", rules).matcher()
    val keeping = PerceptionFilter("others", rules, PerceptionFilter.Mode.KEEP).matcher()

    "it tells which rule dropped a percept" {
        val explanation = dropping.explain("dist(b,1)")
        explanation.toString() shouldBe "dist(b,1) is dropped by filter front: it matches rule 2: dist where argument 0 is not f"
        explanation.outcome shouldBe Outcome.DROPPED
        explanation.rule shouldBe rules[1]
    }

    "it tells why a percept was kept" {
        dropping.explain("dist(f,1)").toString() shouldBe
            "dist(f,1) is kept by filter front: it does not match rule 2: argument 0 is f"
        dropping.explain("~light").toString() shouldBe "~light is kept by filter front: it has no rule on ~light with 0 arguments"
        dropping.explain("dist(").toString() shouldBe
            "dist( is kept by filter front: its text is not a percept, and filters leave that to the parser"
    }

    "it tells the same of a filter that keeps" {
        keeping.explain("dist(b,1)").toString() shouldBe
            "dist(b,1) is kept by filter others: it matches rule 2: dist where argument 0 is not f"
        keeping.explain("dist(f,1)").toString() shouldBe
            "dist(f,1) is dropped by filter others: it does not match rule 2: argument 0 is f"
    }

    "it tells what a percept has in place of what a rule asks for" {
        fun found(percept: String, conditions: RuleConditions.() -> Unit) =
            dropFilter("f") { drop("d", conditions) }.matcher().explain(percept).reason.substringAfter("it does not match rule 1: ")
        found("d(back,30)") { argument(1) gt 200 } shouldBe "argument 1 is 30, not greater than 200"
        found("d(back)") { argument(0) eq "front" } shouldBe "argument 0 is back, not front"
        found("d( back )") { argument(0) isIn listOf("left", 1) } shouldBe "argument 0 is back, not one of left, 1"
        found("d(back)") { argument(0) matches "f.*" } shouldBe "argument 0 is back, which does not match f.*"
        found("d(Side)") { argument(0) ne "front" } shouldBe "argument 0 is Side, which is no value"
        found("d(back)") { argument(1) ne 3 } shouldBe "there is no argument 1"
        found("d[q(1)]") { annotation("q") { lt(0.5); ne(0) } } shouldBe "no annotation q is less than 0.5 and is not 0"
        found("d[q(1)]") { hasAnnotation("urgent") } shouldBe "there is no annotation urgent"
    }

    "it explains literals as texts" {
        dropping.explain(perceptText(ASSyntax.parseLiteral("dist(b,1)"))).toString() shouldBe dropping.explain("dist(b,1)").toString()
    }

    "it agrees with what the matcher does" {
        checkAll(2 * PropertyTesting.defaultIterationCount, filters, perceptTexts) { filter, text ->
            val matcher = filter.matcher()
            (matcher.explain(text).outcome == Outcome.DROPPED) shouldBe matcher.drops(text)
        }
    }

    "filters say what they do" {
        val keep = PerceptionFilter(
            "k",
            listOf(Rule(Predicate("d"), emptyList(), 2, Rate(500, setOf(Deadband(1, 0.5))))),
            PerceptionFilter.Mode.KEEP,
            PerceptionFilter.OnSwitch.FREEZE,
        )
        "$keep" shouldBe "filter k keeps only d where there are 2 arguments and the last one was less than 500 ms ago " +
            "and argument 1 has not moved by 0.5, and freezes what it hides"
        "${PerceptionFilter("none")}" shouldBe "filter none drops nothing"
        val oneOf = TermTest.OneOf(setOf(GroundTerm.of("a"), GroundTerm.of("1")))
        "${Rule("d", Condition.Annotation("q", oneOf, TermTest.Matches("a.*")))}" shouldBe
            "d where annotation q is one of a, 1 and matches a.*"
    }
})
