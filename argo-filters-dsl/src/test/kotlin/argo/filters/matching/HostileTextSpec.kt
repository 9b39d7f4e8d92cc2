package argo.filters.matching

import argo.filters.Condition
import argo.filters.GroundTerm
import argo.filters.Operator
import argo.filters.PerceptionFilter
import argo.filters.Rule
import argo.filters.TermTest
import argo.filters.jason.perceptText
import argo.filters.rule
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.StringSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.PropertyTesting
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.map
import io.kotest.property.arbitrary.string
import io.kotest.property.checkAll
import jason.asSyntax.ASSyntax

private val tokens = Arb.list(
    Arb.element(
        "d", "(", ")", "[", "]", "{", "}", ",", "|", "\"", "'", "\\", "~", "::", ":", ".", "-", "+", "1", "1.5e", "e3", "X", "_", " ", "\n",
        "//", "/*", "*/", "/", "true", "not", "\u0000", "é", ";",
    ),
    0..14,
).map { it.joinToString("") }

class HostileTextSpec : StringSpec({
    val anyCondition = listOf(Operator.EQ, Operator.NE).map { Rule("d", Condition.Argument(0, TermTest.Compare(it, GroundTerm.of("1")))) } +
        Rule("d", Condition.Annotation("d", TermTest.Compare(Operator.NE, GroundTerm.of("1"))))
    val matcher = PerceptionFilter("any", anyCondition).matcher()
    val dropsAll = rule("d")

    "text that is no percept is kept" {
        val broken = listOf(
            "", " ", "d(", "d)", "d(1", "d(1]", "d[1)", "d(1))", "d()", "d(,)", "d(1,)", "d(,1)", "d(1,,2)", "d(1)(2)", "d(1)[x](2)",
            "d(1)[x][y]", "d[x](1)",
            "d e", "d(1) e", "d.", "d(1).", "d(\"1)", "d('1)", "d(\"a\nb\")", "d(\"\\x\")", "d([)])", "d({)}", "d(1);e(2)", "d(1) /*",
            "/* d(1)", "/", "D(1)", "1", "\"d\"",
            "[d]", "~", "~~d", "::", "a::b::d", "not d", "if", "d\u0000", "\u0000", "d(1)\u0000", "d :: ", "~true", "true(1)",
            "house::true", "{d}", "é",
        )
        for (text in broken) withClue(text) {
            dropsAll.drops(text) shouldBe false
            matcher.drops(text) shouldBe false
        }
    }

    "10,000 nested brackets are kept, and nothing overflows" {
        for ((open, close) in listOf("(" to ")", "[" to "]", "f(" to ")", "-(" to ")", "[a|[" to "]]", "a[" to "]", "{" to "}")) {
            for (text in listOf("d(" + open.repeat(10_000), "d(" + open.repeat(10_000) + "1" + close.repeat(10_000) + ")")) {
                matcher.drops(text) shouldBe false
                dropsAll.drops(text) shouldBe false
            }
        }
        matcher.drops("~".repeat(10_000) + "d") shouldBe false
        matcher.drops("d(" + "-".repeat(10_000) + "1)") shouldBe false
    }

    "terms nested as deep as a scanner goes make no condition true" {
        val text = "d(" + "[".repeat(200) + "]".repeat(200) + ")"
        dropsAll.drops(text) shouldBe true
        matcher.drops(text) shouldBe false
        matcher.drops(perceptText(ASSyntax.parseLiteral(text))) shouldBe false
    }

    "no text makes a matcher throw" {
        checkAll(20 * PropertyTesting.defaultIterationCount, tokens) { matcher.drops(it) }
        checkAll(5 * PropertyTesting.defaultIterationCount, Arb.string(0..40)) { matcher.drops("d($it)") }
    }

    "no text makes the reader of values throw, and what it reads it can write" {
        fun shouldReturn(text: String) = GroundTerm.ofOrNull(text)?.let { GroundTerm.of("$it") shouldBe it }
        checkAll(20 * PropertyTesting.defaultIterationCount, tokens) { shouldReturn(it) }
        checkAll(5 * PropertyTesting.defaultIterationCount, Arb.string(0..12)) { shouldReturn("\"$it\"") }
    }
})
