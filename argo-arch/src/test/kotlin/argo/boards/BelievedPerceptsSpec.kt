package argo.boards

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import jason.asSyntax.ASSyntax

class BelievedPerceptsSpec : FunSpec({
    val (old, now, next) = listOf("dist(1)", "dist(2)", "dist(3)").map(ASSyntax::parseLiteral)

    test("what is believed, and was before the last snapshot, belongs to the board; what was before that does not") {
        val first = BelievedPercepts.NONE.then(listOf(old), 1)
        val second = first.then(listOf(now), 2)
        val third = second.then(listOf(next), 3)
        (old in second) shouldBe true
        listOf(old, now, next).map { it in third } shouldBe listOf(false, true, true)
        third.nanos shouldBe 3
        third.percepts shouldBe listOf(next)
    }

    test("who reads it while the next snapshot is taken sees one of the two and no mixture") {
        val before = BelievedPercepts.NONE.then(listOf(old), 1)
        val read = before
        before.then(listOf(now), 2)
        (now in read) shouldBe false
        read.nanos shouldBe 1
    }

    test("annotations do not matter") {
        (ASSyntax.parseLiteral("dist(1)[source(percept)]") in BelievedPercepts.NONE.then(listOf(old), 1)) shouldBe true
    }
})
