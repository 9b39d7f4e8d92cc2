package argo.sensing

import argo.connecting.OpenPort
import argo.connecting.PortOptions
import argo.links.JavinoLink
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import jason.asSyntax.ASSyntax
import javino.link.Link
import javino.link.LinkSettings
import javino.sim.FakeBoard

class StaleBeliefsSpec : FunSpec({
    fun options(text: String) = PortOptions.of(ASSyntax.parseTerm(text))

    test("a board is stale when no message has come for as long as the limit") {
        FakeBoard.plugIn("quiet").use { board ->
            JavinoLink(Link.open(board.port(), LinkSettings.defaults(), "bob")).use { link ->
                var nowMs = 1_000L
                val port =
                    OpenPort(mapOf(ASSyntax.createAtom("quiet") to board.port()), link, options("[stale(300)]"), 0, 0) { AutoCloseable { } }
                val stale = StaleBeliefs({ nowMs }, { port }, { 50 })
                stale.dueInMs() shouldBe 300
                nowMs = 1_299
                stale.dueInMs() shouldBe 1
                stale.update() shouldBe false
                nowMs = 5_000
                stale.dueInMs() shouldBe 0
                stale.hasNews() shouldBe true
                stale.update() shouldBe true
                stale.beliefs().map { "$it" } shouldBe listOf("stale(quiet)")
                stale.renew()
                stale.dueInMs() shouldBe 300
                stale.update() shouldBe true
                stale.isEmpty() shouldBe true
            }
        }
    }

    test("the limit is that of the option, or two answers behind the interval, and none for a board that speaks unasked") {
        StaleBeliefs.limitMs(options("[]"), 50) shouldBe 1_050
        StaleBeliefs.limitMs(options("[timeout(2000)]"), 60_000) shouldBe 64_000
        StaleBeliefs.limitMs(options("[stale(300)]"), 60_000) shouldBe 300
        StaleBeliefs.limitMs(options("[stale(0)]"), 50) shouldBe null
        StaleBeliefs.limitMs(options("[mode(listen)]"), 50) shouldBe null
        StaleBeliefs.limitMs(options("[mode(listen),stale(200)]"), 50) shouldBe 200
    }
})
