package argo.perception

import argo.filters.PerceptionFilter
import argo.filters.PerceptionFilter.Mode
import argo.filters.Predicate
import argo.filters.Rate
import argo.filters.Rule
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

private fun keeping(vararg rules: Rule) = perceptsRequest(PerceptionFilter("f", rules.asList(), Mode.KEEP))

class PerceptsRequestSpec : FunSpec({
    test("a filter that keeps percepts by their functor has these alone asked for") {
        keeping(Rule("dist"), Rule("light"), Rule("dist")) shouldBe "getPercepts(dist,light)"
        keeping(Rule("~open")) shouldBe "getPercepts(open)"
    }

    test("every other filter has everything asked for") {
        perceptsRequest(null) shouldBe "getPercepts"
        perceptsRequest(PerceptionFilter("f", Rule("dist"))) shouldBe "getPercepts"
        keeping() shouldBe "getPercepts"
        keeping(Rule("dist"), Rule(Predicate.of("temp"), rate = Rate(everyMs = 100))) shouldBe "getPercepts"
        keeping(Rule("house::dist")) shouldBe "getPercepts"
        keeping(Rule("'Left wheel'")) shouldBe "getPercepts"
    }

    test("a list that is longer than a frame is not sent") {
        keeping(*Array(100) { Rule("sensor$it") }) shouldBe "getPercepts"
    }
})
