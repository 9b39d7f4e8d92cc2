package argo.perception

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import jason.asSyntax.ASSyntax
import jason.asSyntax.Literal

class PerceptAgesSpec : FunSpec({
    fun literals(vararg texts: String): List<Literal> = texts.map(ASSyntax::parseLiteral)

    test("a percept was seen when the newest message in which it stood came") {
        val sightings = PerceptAges { emptyList() }
        sightings.seen(literals("dist(f,1)", "light(2)"), emptyList(), 10)
        sightings.seen(literals("dist(f,1)"), emptyList(), 20)
        sightings.seen(literals("light(2)"), emptyList(), 5)
        sightings.lastSeenNanos(ASSyntax.parseLiteral("dist(f,1)[source(percept)]")) shouldBe 20
        sightings.lastSeenNanos(ASSyntax.parseLiteral("light(2)")) shouldBe 10
        sightings.lastSeenNanos(ASSyntax.parseLiteral("~light(2)")) shouldBe null
    }

    test("ever new percepts are forgotten, but none that is believed or about to be") {
        var believed = emptyList<Literal>()
        val sightings = PerceptAges { believed }
        repeat(10_000) {
            val delivered = literals("old", "n($it)")
            sightings.seen(if (it == 0) delivered else delivered.drop(1), delivered, it.toLong())
            believed = delivered
        }
        sightings.lastSeenNanos(ASSyntax.parseLiteral("old")) shouldBe 0
        sightings.lastSeenNanos(ASSyntax.parseLiteral("n(9999)")) shouldBe 9999
        check(sightings.size() < 100) { "${sightings.size()} percepts are remembered" }
    }
})
