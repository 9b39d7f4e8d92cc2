package argo.perception

import argo.acting.CommandLedger
import argo.filters.CriticalRule
import argo.filters.PerceptionFilter
import argo.filters.Rule
import argo.filters.matching.CriticalPercept
import argo.platform.RateLimitedWarning
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldHaveSize
import io.kotest.matchers.shouldBe
import jason.asSemantics.Event
import jason.asSemantics.Intention
import jason.asSyntax.ASSyntax
import java.util.concurrent.ConcurrentLinkedQueue

class CriticalLaneSpec : FunSpec({
    val near = CriticalRule(Rule("near"))
    val bump = CriticalRule(Rule("bump"))
    fun event(trigger: String) = Event(ASSyntax.parseTrigger(trigger), Intention.EmptyInt)
    fun snapshot(n: Long, vararg critical: Pair<CriticalRule, String>) = Snapshot(
        null, listOf("n($n)"), listOf("n($n)"), emptyList(), n,
        critical.map { (rule, text) -> CriticalPercept(rule, ASSyntax.parseLiteral(text)) },
    )

    /** A hand-over to an agent. The agent's queue holds the given number of percept events, and one command never goes out. */
    class Busy(events: Int) {
        val queue = ConcurrentLinkedQueue<Event>()
        val commands = CommandLedger { this }
        val handOver = FreshHandOver(UnfinishedWork(commands, ReasoningQueues { queue }))

        init {
            commands.issue(this)
            handOver.put(snapshot(0))
            handOver.take()
            repeat(events) { queue += event("+light($it)[source(percept)]") }
            handOver.take() shouldBe null
        }

        fun taken() = handOver.take()?.receivedNanos
    }

    test("a snapshot with a new critical percept is handed over though events and commands wait") {
        val busy = Busy(300)
        busy.handOver.put(snapshot(1))
        busy.handOver.isReady() shouldBe false
        busy.handOver.put(snapshot(2, near to "near(9)"))
        busy.handOver.isReady() shouldBe true
        busy.taken() shouldBe 2
        busy.taken() shouldBe null // the earlier snapshot is older
    }

    test("one with the same critical percepts waits as any other") {
        val busy = Busy(300)
        busy.handOver.put(snapshot(1, near to "near(9)"))
        busy.taken() shouldBe 1
        busy.handOver.put(snapshot(2, near to "near(9)"))
        busy.taken() shouldBe null
        busy.handOver.put(snapshot(3, near to "near(8)"))
        busy.taken() shouldBe 3
    }

    test("a newer snapshot without the critical percept does not take its place, nor one that is critical for another reason") {
        val busy = Busy(300)
        busy.handOver.put(snapshot(1, bump to "bump"))
        busy.handOver.put(snapshot(2))
        busy.handOver.put(snapshot(3, near to "near(9)"))
        busy.handOver.put(snapshot(4, near to "near(8)"))
        busy.taken() shouldBe 1
        busy.taken() shouldBe 4
        busy.taken() shouldBe null
    }

    test("a board that is critical all the time does not make events pile up") {
        val busy = Busy(FreshHandOver.MANY_EVENTS)
        busy.handOver.put(snapshot(1, near to "near(9)"))
        busy.taken() shouldBe 1
        busy.handOver.put(snapshot(2, near to "near(8)"))
        busy.taken() shouldBe null
        busy.handOver.put(snapshot(3, near to "near(7)", bump to "bump"))
        busy.taken() shouldBe 3
        busy.handOver.put(snapshot(4, near to "near(6)", bump to "bump(2)"))
        busy.taken() shouldBe null
        busy.queue.clear()
        busy.taken() shouldBe 4
    }

    test("events of critical percepts come before all that wait, in their order, and no event is lost") {
        val queue = ConcurrentLinkedQueue<Event>()
        val waiting = (1..5).map { event("+light($it)[source(percept)]") }
        val critical = listOf(event("+near(9)[source(percept)]"), event("+~open(door)[source(percept)]"))
        val others = listOf(
            event("-near(9)[source(percept)]"), event("+near(9)[source(self)]"), event("+open(door)[source(percept)]"),
            event("+!near(9)[source(percept)]"),
        )
        queue += waiting + critical[0] + others + critical[1]
        bringForward(queue, listOf(ASSyntax.parseLiteral("near(9)[q(1)]"), ASSyntax.parseLiteral("~open(door)")))
        queue.toList().map { "${it.trigger}" } shouldBe (critical + waiting + others).map { "${it.trigger}" }
        bringForward(queue, listOf(ASSyntax.parseLiteral("nowhere")))
        queue shouldHaveSize 11
    }

    test("a board of version 2 is asked for critical percepts too") {
        fun request(rules: List<Rule>, critical: List<CriticalRule>, mode: PerceptionFilter.Mode = PerceptionFilter.Mode.KEEP) =
            perceptsRequest(PerceptionFilter("f", rules, mode, critical = critical))
        request(listOf(Rule("dist")), listOf(near, CriticalRule(Rule("dist")))) shouldBe "getPercepts(dist,near)"
        request(emptyList(), listOf(near)) shouldBe "getPercepts(near)"
        request(listOf(Rule("dist")), listOf(CriticalRule(Rule("house::near")))) shouldBe "getPercepts"
        request(listOf(Rule("dist")), listOf(near), PerceptionFilter.Mode.DROP) shouldBe "getPercepts"
    }

    test("of more percepts than the limit the first are believed, critical ones before others, with one warning") {
        val warnings = ArrayList<String>()
        val limit = PerceptLimit(3, RateLimitedWarning({ 0 }) { warnings += it })
        fun literals(vararg texts: String) = texts.map(ASSyntax::parseLiteral)
        limit.limited(literals("a", "b", "c"), emptyList()).map { "$it" } shouldBe listOf("a", "b", "c")
        limit.limited(literals("a", "a", "b", "b", "c"), emptyList()).map { "$it" } shouldBe listOf("a", "b", "c")
        warnings shouldHaveSize 0
        repeat(10) { limit.limited(literals("a", "b", "c", "d"), emptyList()).map { "$it" } shouldBe listOf("a", "b", "c") }
        limit.limited(literals("a", "b", "c", "d", "e"), literals("d", "e")).map { "$it" } shouldBe listOf("a", "d", "e")
        limit.limited(literals("a", "b", "c", "d"), literals("d", "c", "b", "a")).map { "$it" } shouldBe listOf("b", "c", "d")
        warnings shouldHaveSize 1
    }
})
