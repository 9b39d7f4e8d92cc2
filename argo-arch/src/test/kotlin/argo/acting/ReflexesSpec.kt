package argo.acting

import argo.calls.Failure
import argo.connecting.OpenPort
import argo.connecting.PortOptions
import argo.filters.CriticalRule
import argo.filters.Rule
import argo.links.JavinoLink
import argo.platform.RateLimitedWarning
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldHaveSize
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import jason.asSyntax.ASSyntax
import javino.Frame
import javino.link.Link
import javino.link.LinkSettings
import javino.sim.FakeBoard
import javino.wire.ReflexOutcome

class ReflexesSpec : FunSpec({
    val near = CriticalRule(Rule("near"), "stop")
    val bump = CriticalRule(Rule("bump"), "back")
    val silent = CriticalRule(Rule("smoke"))
    val sent = ArrayList<String>()
    val outcomes = ArrayList<(Failure?) -> Unit>()
    val warnings = ArrayList<String>()
    var nowMs = 0L
    val watchedByBoard = HashSet<CriticalRule>()
    val ended = ArrayList<String>()
    fun reflexes(send: (String, (Failure?) -> Unit) -> Unit = { command, outcome -> sent += command; outcomes += outcome }) = Reflexes(
        { _, command, outcome -> send(command, outcome) }, { _, rule -> rule in watchedByBoard },
        { rule, watcher, failure -> ended += "${rule.reflex} by ${watcher.word}: ${failure?.error ?: "done"}" },
        RateLimitedWarning({ nowMs }) { warnings += it },
    )
    val board = FakeBoard.plugIn("reflexes").lenient()
    val port = OpenPort(
        mapOf(ASSyntax.createAtom("reflexes") to "sim:reflexes"),
        JavinoLink(Link.open("sim:reflexes", LinkSettings.defaults(), "test")),
        PortOptions(), 0, 0,
    ) { AutoCloseable { } }
    afterSpec {
        port.close()
        board.close()
    }
    beforeTest { sent.clear(); outcomes.clear(); warnings.clear(); watchedByBoard.clear(); ended.clear(); nowMs = 0 }

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

    test("the end of one is passed on before its failure is logged") {
        val order = ArrayList<String>()
        Reflexes(
            { _, _, outcome -> outcome(Failure("port_gone", "it is gone")) }, { _, _ -> false }, { _, _, _ -> order += "ended" },
            RateLimitedWarning({ nowMs }) { order += "logged" },
        ).perceived(port, listOf(near))
        order shouldBe listOf("ended", "logged")
    }

    test("one that fails at once does not end sensing") {
        val reflexes = reflexes { _, _ -> throw IllegalStateException("broken") }
        reflexes.perceived(port, listOf(near))
        warnings.single() shouldContain "broken"
    }

    test("at another port or time it begins anew, with another filter only if that has another rule") {
        val reflexes = reflexes()
        reflexes.perceived(port, listOf(near))
        outcomes.single()(null)
        reflexes.forget()
        reflexes.perceived(port, listOf(near))
        sent shouldBe listOf("stop", "stop")
        reflexes.keepOnly(listOf(bump, near))
        reflexes.perceived(port, listOf(near))
        sent shouldBe listOf("stop", "stop")
        reflexes.keepOnly(listOf(bump))
        reflexes.perceived(port, listOf(near))
        sent shouldBe listOf("stop", "stop", "stop")
    }

    test("its outcome is believed from when it is known until the rule is not met any more") {
        val reflexes = reflexes()
        reflexes.perceived(port, listOf(near, bump))
        reflexes.beliefs().shouldBeEmpty()
        outcomes[0](Failure("act_unconfirmed", "no answer"))
        reflexes.hasNews() shouldBe true
        "${reflexes.beliefs()}" shouldBe "[reflex(stop,failed)]"
        reflexes.hasNews() shouldBe false
        outcomes[1](null)
        reflexes.perceived(port, listOf(near, bump)) // sends stop again
        "${reflexes.beliefs()}" shouldBe "[reflex(stop,failed), reflex(back,done)]"
        outcomes[2](null)
        "${reflexes.beliefs()}" shouldBe "[reflex(stop,done), reflex(back,done)]"
        reflexes.perceived(port, listOf(bump))
        reflexes.hasNews() shouldBe true
        "${reflexes.beliefs()}" shouldBe "[reflex(back,done)]"
        reflexes.forget()
        reflexes.beliefs().shouldBeEmpty()
        ended shouldBe listOf("stop by the computer: act_unconfirmed", "back by the computer: done", "stop by the computer: done")
    }

    test("an outcome that comes when its rule is not met any more is not believed") {
        val reflexes = reflexes()
        reflexes.perceived(port, listOf(near))
        reflexes.perceived(port, emptyList())
        outcomes.single()(null)
        reflexes.beliefs().shouldBeEmpty()
    }

    test("a command that is no literal is believed as a string") {
        val reflexes = reflexes()
        val rules = listOf("speed(0)", "turn left", "Left", "[go]", "a & b").map { CriticalRule(Rule("near"), it) }
        reflexes.perceived(port, rules)
        outcomes.forEach { it(null) }
        "${reflexes.beliefs()}" shouldBe
            "[reflex(speed(0),done), reflex(\"turn left\",done), reflex(\"Left\",done), reflex(\"[go]\",done), reflex(\"a & b\",done)]"
    }

    test("one of a rule that the board watches is left to the board, whose report is its outcome") {
        watchedByBoard += near
        val reflexes = reflexes()
        reflexes.perceived(port, listOf(near))
        reflexes.reported(near, ReflexOutcome.CARRIED_OUT)
        repeat(3) { reflexes.perceived(port, listOf(near)) }
        sent.shouldBeEmpty()
        "${reflexes.beliefs()}" shouldBe "[reflex(stop,done)]"
        reflexes.perceived(port, emptyList())
        reflexes.reported(near, ReflexOutcome.REFUSED)
        repeat(3) { reflexes.perceived(port, listOf(near)) }
        sent.shouldBeEmpty()
        "${reflexes.beliefs()}" shouldBe "[reflex(stop,failed)]"
        warnings.single() shouldContain "the board, which watches the rule, refuses it"
        ended shouldBe listOf("stop by the board: done", "stop by the board: act_refused")
    }

    test("without a report the computer sends it with the second message that meets the rule") {
        watchedByBoard += near
        val reflexes = reflexes()
        reflexes.perceived(port, listOf(near))
        repeat(3) { reflexes.perceived(port, listOf(near), isMessage = false) } // reports of other rules
        sent.shouldBeEmpty()
        reflexes.perceived(port, listOf(near))
        sent shouldBe listOf("stop")
        outcomes.single()(null)
        reflexes.perceived(port, listOf(near))
        sent shouldBe listOf("stop")
    }

    test("one that the board does not watch any more is the computer's at once") {
        watchedByBoard += near
        val reflexes = reflexes()
        reflexes.perceived(port, listOf(near))
        watchedByBoard.clear()
        reflexes.perceived(port, listOf(near), isMessage = false)
        sent shouldBe listOf("stop")
    }

    test("a failure of the computer's changes nothing when the board has reported meanwhile") {
        val reflexes = reflexes()
        reflexes.perceived(port, listOf(near))
        watchedByBoard += near
        reflexes.reported(near, ReflexOutcome.CARRIED_OUT)
        outcomes.single()(Failure("act_unconfirmed", "no answer"))
        reflexes.perceived(port, listOf(near))
        sent shouldBe listOf("stop")
        "${reflexes.beliefs()}" shouldBe "[reflex(stop,done)]"
    }

    test("things that come in turn are told once each, and of more than a hundred at a time only that there are others") {
        val warning = RateLimitedWarning({ nowMs }) { warnings += it }
        fun inTurn(things: Int) = repeat(5) { repeat(things) { nowMs += 10; warning.report("$it") { "$it" } } }
        inTurn(100)
        warnings shouldBe List(100) { "$it" }
        inTurn(150)
        warnings.drop(100) shouldBe listOf("100; others like this are not reported while there are so many")
        nowMs += RateLimitedWarning.QUIET_MS + 1
        inTurn(2)
        warnings.drop(101) shouldBe listOf("0", "1")
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
