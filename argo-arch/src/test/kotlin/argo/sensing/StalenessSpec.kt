package argo.sensing

import argo.ports.PortOptions
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import jason.asSyntax.ASSyntax

class StalenessSpec : FunSpec({
    fun options(text: String) = PortOptions.of(ASSyntax.parseTerm(text))

    test("a board is stale when nothing has come for as long as the limit") {
        var nowMs = 1_000L
        val staleness = Staleness { nowMs }
        staleness.dueInMs(300) shouldBe 300
        nowMs = 1_299
        staleness.dueInMs(300) shouldBe 1
        nowMs = 5_000
        staleness.dueInMs(300) shouldBe 0
        staleness.renew()
        staleness.dueInMs(300) shouldBe 300
    }

    test("the limit is that of the option, or two answers behind the interval, and none for a board that speaks unasked") {
        options("[]").staleAfterMs(50) shouldBe 1_050
        options("[timeout(2000)]").staleAfterMs(60_000) shouldBe 64_000
        options("[stale(300)]").staleAfterMs(60_000) shouldBe 300
        options("[stale(0)]").staleAfterMs(50) shouldBe null
        options("[mode(listen)]").staleAfterMs(50) shouldBe null
        options("[mode(listen),stale(200)]").staleAfterMs(50) shouldBe 200
    }
})
