package javino

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe

class PerceptDescriptionSpec : FunSpec({
    test("the texts of a description are read as its kinds, and percepts between them are none") {
        val kinds = PerceptKind.parseLines("dist(front|left, cm 0..400)\nready\n~wall(_)")
        val texts = PerceptDescription.texts(kinds)
        texts.first() shouldBe "?dist(front|left, cm 0..400);"
        PerceptDescription.read("dist(front,3);" + texts.joinToString("dist(left,4);")) shouldBe PerceptDescription(kinds, emptyList())
        PerceptDescription.read("dist(front,3);ready;").kinds.shouldBeEmpty()
    }

    test("of a hostile description a thousand kinds are kept, and no reason holds a control character or a long text") {
        val description = PerceptDescription.read("?a\n;?${"b".repeat(255)};?d();" + "?c;".repeat(1_002))
        description.kinds.size shouldBe 1_000
        description.problems.size shouldBe 5
        description.problems.filter { reason -> reason.length > 600 || reason.any(Char::isISOControl) }.shouldBeEmpty()
    }
})
