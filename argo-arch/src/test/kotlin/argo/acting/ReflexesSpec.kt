package argo.acting

import argo.calls.Failure
import argo.filters.CriticalRule
import argo.filters.Rule
import argo.platform.RateLimitedWarning
import argo.ports.OpenPort
import argo.ports.PortOptions
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldHaveSize
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import jason.asSyntax.ASSyntax
import javino.Frame
import javino.Link
import javino.LinkSettings
import javino.sim.FakeBoard

class ReflexesSpec : FunSpec({
    val near = CriticalRule(Rule("near"), "stop")
    val bump = CriticalRule(Rule("bump"), "back")
    val silent = CriticalRule(Rule("smoke"))
    val sent = ArrayList<String>()
    val outcomes = ArrayList<(Failure?) -> Unit>()
    val warnings = ArrayList<String>()
    var nowMs = 0L
    fun reflexes() =
        Reflexes({ _, command, outcome -> sent += command; outcomes += outcome }, RateLimitedWarning({ nowMs }) { warnings += it })
    val board = FakeBoard.plugIn("reflexes").lenient()
    val port = OpenPort(
        mapOf(ASSyntax.createAtom("reflexes") to "sim:reflexes"),
        Link.open("sim:reflexes", LinkSettings.defaults(), "test"),
        PortOptions(), 0, 0,
    ) { AutoCloseable { } }
    afterSpec {
        port.close()
        board.close()
    }
    beforeTest { sent.clear(); outcomes.clear(); warnings.clear(); nowMs = 0 }

    test("the longest reflex that a filter takes fits into one frame") {
        CriticalRule.MAX_REFLEX_LENGTH shouldBe Frame.MAX_PAYLOAD
    }

    test("a reflex is sent when its rule begins to be met, and not again while it stays met") {
        val reflexes = reflexes()
        reflexes.perceived(port, emptyList())
        sent.shouldBeEmpty()
        repeat(3) { reflexes.perceived(port, listOf(near, near, silent)) }
        outcomes.single()(null)
        repeat(3) { reflexes.perceived(port, listOf(near)) }
        sent shouldBe listOf("stop")
        reflexes.perceived(port, listOf(near, bump))
        sent shouldBe listOf("stop", "back")
        reflexes.perceived(port, emptyList())
        reflexes.perceived(port, listOf(near))
        sent shouldBe listOf("stop", "back", "stop")
    }

    test("one that has failed is sent again with the next message that meets its rule, and the log tells of it once") {
        val reflexes = reflexes()
        repeat(5) {
            reflexes.perceived(port, listOf(near))
            outcomes.last()(Failure("act_unconfirmed", "no answer"))
        }
        sent shouldHaveSize 5
        reflexes.perceived(port, listOf(near))
        outcomes.last()(null)
        reflexes.perceived(port, listOf(near))
        sent shouldHaveSize 6
        warnings shouldHaveSize 1
        warnings.single().split("stop") shouldHaveSize 2 // named once
        warnings.single() shouldContain "the reflex stop"
        warnings.single() shouldContain "no answer"
    }

    test("one that the board refuses is not sent again while its rule stays met") {
        val reflexes = reflexes()
        reflexes.perceived(port, listOf(near))
        outcomes.single()(Failure("act_refused", "unknown"))
        repeat(3) { reflexes.perceived(port, listOf(near)) }
        sent shouldBe listOf("stop")
        warnings shouldHaveSize 1
    }

    test("one that fails at once does not end sensing") {
        val reflexes = Reflexes({ _, _, _ -> throw IllegalStateException("broken") }, RateLimitedWarning({ nowMs }) { warnings += it })
        reflexes.perceived(port, listOf(near))
        warnings.single() shouldContain "broken"
    }

    test("with another filter, port or time it begins anew") {
        val reflexes = reflexes()
        reflexes.perceived(port, listOf(near))
        outcomes.single()(null)
        reflexes.forget()
        reflexes.perceived(port, listOf(near))
        sent shouldBe listOf("stop", "stop")
    }

    test("a thing that goes on is told once, and again when it had ended for a minute or is another") {
        val warning = RateLimitedWarning({ nowMs }) { warnings += it }
        repeat(1_000) { nowMs += 50_000; warning.report("a") { "a at $nowMs" } }
        warnings shouldBe listOf("a at 50000")
        nowMs += RateLimitedWarning.QUIET_MS + 1
        warning.report("a") { "a again" }
        warning.report("b") { "b" }
        warnings shouldBe listOf("a at 50000", "a again", "b")
    }
})
