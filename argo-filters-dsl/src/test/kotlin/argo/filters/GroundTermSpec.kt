package argo.filters

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.StringSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.shouldNotBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import io.kotest.property.Arb
import io.kotest.property.PropertyTesting
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.map
import io.kotest.property.checkAll

class GroundTermSpec : StringSpec({
    "what a value writes is read back to it" {
        checkAll(5 * PropertyTesting.defaultIterationCount, values()) { GroundTerm.of("$it") shouldBe it }
    }

    "numbers are equal by what they are, not by how they are written" {
        for (written in listOf("36.0", "3.6e1", " 36", "+36", "360e-1", "036")) GroundTerm.of(written) shouldBe GroundTerm.of("36")
        GroundTerm.of("-0.0") shouldBe GroundTerm.of("0")
        GroundTerm.of("-0.0").hashCode() shouldBe GroundTerm.of("0").hashCode()
    }

    "a string is not the atom of the same text" { GroundTerm.of("\"front\"") shouldNotBe GroundTerm.of("front") }

    "annotations have no order" { GroundTerm.of("a[b,c]") shouldBe GroundTerm.of("a[c,b,c]") }

    "what is no ground term is refused with what is wrong" {
        for ((written, words) in listOf(
            "" to "missing", "Front" to "variable", "_x" to "variable", "a b" to "not a value",
            "Front Left" to "'Front Left' is not a value that Jason can read; a text stands in quotes (\"Front Left\")",
            "1d" to "not a value",
            "0x10" to "not a value", "a+b" to "not a value", "[a|T]" to "not a value", "\"x" to "not a value",
        )) {
            shouldThrow<IllegalArgumentException> { GroundTerm.of(written) }.message shouldContain words
        }
    }

    "for a variable an atom is proposed, if that is what it becomes in lower case" {
        fun refusal(written: String) = shouldThrow<IllegalArgumentException> { GroundTerm.of(written) }.message
        refusal("Front") shouldBe "'Front' is a variable to Jason; an atom starts with a lower-case letter (front) or stands in quotes"
        refusal("Pos(1,2)") shouldContain "letter (pos(1,2)) or"
        for (written in listOf("_", "_1", "Pos(X)", "Front Left!", "Links+1", "Ölstand_über")) {
            refusal(written) shouldNotContain Regex("letter \\(")
        }
    }

    "a string that Jason's syntax cannot hold is written with escapes of its own, and read back" {
        val texts = listOf(
            "\\", "a\\", "\\x", "\r", "\\n", "C:\\robot\\map.yaml", "\\d+",
            "{\"a\": \"x\\ny\"}", "\\\"", "\\u005C", "\\\\u005C\n\\",
        )
        for (text in texts) GroundTerm.of("${GroundTerm.Text(text)}") shouldBe GroundTerm.Text(text)
        "${GroundTerm.Text("C:\\maps")}" shouldBe "\"C:\\u005Cmaps\""
        val escapes = Arb.list(Arb.element("\\", "u", "n", "0", "5", "C", "\"", "\n", "\r"), 0..8).map { it.joinToString("") }
        checkAll(5 * PropertyTesting.defaultIterationCount, escapes) { text ->
            GroundTerm.of("${GroundTerm.Text(text)}") shouldBe GroundTerm.Text(text)
        }
    }

    "what Jason's parser takes behind a backslash keeps its meaning" {
        GroundTerm.of("\"\\\\u005C\"") shouldBe GroundTerm.Text("\\\\u005C")
        GroundTerm.of("\"\\t\"") shouldBe GroundTerm.Text("\\t")
        shouldThrow<IllegalArgumentException> { GroundTerm.of("\"\\u00G0\"") }
    }

    "a structure that Jason cannot write is refused" {
        shouldThrow<IllegalArgumentException> { GroundTerm.Structure(Predicate("true"), listOf(GroundTerm.of("1"))) }
        shouldThrow<IllegalArgumentException> { GroundTerm.Structure(Predicate("math.abs"), listOf(GroundTerm.of("1"))) }
        shouldThrow<IllegalArgumentException> { Predicate("a", namespace = "this_ns") }
    }

    "an ordering needs a number" {
        shouldThrow<IllegalArgumentException> { TermTest.Compare(Operator.GT, GroundTerm.of("front")) }.message shouldContain
            "'front' is not one"
    }

    "a predicate is written as it is read" {
        for (written in listOf(
            "dist", "~open", "house::dist", "house::~open", "'Left wheel'", "'x::y'", "~'x::y'", "'a::b'::'x::y'", "house::'x::y'",
        )) {
            "${Predicate.of(written)}" shouldBe written
        }
        "${Predicate.of(" default:: dist ")}" shouldBe "dist"
        for (written in listOf("", "Dist", "dist(1)", "~", "~~a", "a b", "1", "::", "a::", "A::b", "not", "~true", "a::true", "true::a")) {
            shouldThrow<IllegalArgumentException> { Predicate.of(written) }
        }
    }
})
