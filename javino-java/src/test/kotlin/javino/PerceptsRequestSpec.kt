package javino

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe

class PerceptsRequestSpec : FunSpec({
    test("a request for percepts asks for all, or for those of some functors") {
        listOf("getPercepts", "getPercepts()", "getPercepts(dist)", "getPercepts(dist,light)")
            .filterNot(PerceptsRequest::isIn).shouldBeEmpty()
        listOf("", "getPercept", "getPerceptsNow", "getpercepts", "ledOn", " getPercepts").filter(PerceptsRequest::isIn).shouldBeEmpty()
    }

    test("the functors are those between the brackets, and none stand for all") {
        PerceptsRequest.functorsIn("getPercepts(dist,light)") shouldBe setOf("dist", "light")
        PerceptsRequest.functorsIn("getPercepts(dist,,dist,") shouldBe setOf("dist")
        listOf("getPercepts", "getPercepts()", "getPercepts(", "ledOn").flatMap(PerceptsRequest::functorsIn).shouldBeEmpty()
    }
})
