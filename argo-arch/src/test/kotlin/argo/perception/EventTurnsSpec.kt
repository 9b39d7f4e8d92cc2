package argo.perception

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import jason.asSemantics.Event
import jason.asSemantics.Intention
import jason.asSyntax.ASSyntax
import java.util.concurrent.ConcurrentLinkedQueue

class EventTurnsSpec : FunSpec({
    fun event(trigger: String) = Event(ASSyntax.parseTrigger(trigger), Intention.EmptyInt)
    fun percept(literal: String) = event("+$literal[source(percept)]")
    fun taken(waiting: List<Event>, new: List<Event>): List<String> {
        val queue = ConcurrentLinkedQueue(waiting + new)
        takeTurns(queue, waiting.size) { it.ns.functor }
        return queue.map { it.trigger.literal.copy().apply { clearAnnots() }.toString() }
    }

    test("the percepts of a board do not wait behind a flood of another board's") {
        val flood = (1..100).map { percept("right::n($it)") }
        taken(flood, listOf(percept("left::a"), percept("left::b"))).take(5) shouldBe
            listOf("right::n(1)", "left::a", "right::n(2)", "left::b", "right::n(3)")
        taken(emptyList(), flood + percept("left::a")).take(3) shouldBe listOf("right::n(1)", "left::a", "right::n(2)")
    }

    test("no event is lost, and those of one board keep their order") {
        val waiting = listOf(event("+!go"), percept("left::n(1)"), percept("right::m(1)"))
        val new = listOf(percept("left::n(2)"), percept("left::n(3)"), event("+!stop"), percept("right::m(2)"))
        val all = taken(waiting, new)
        all.sorted() shouldBe (waiting + new).map { it.trigger.literal.copy().apply { clearAnnots() }.toString() }.sorted()
        all.filter { it.startsWith("left") } shouldBe listOf("left::n(1)", "left::n(2)", "left::n(3)").sortedBy(all::indexOf)
        (all.indexOf("left::n(2)") < all.indexOf("left::n(3)")) shouldBe true
    }

    test("without new percepts the queue stays as it is") {
        val waiting = (1..3).map { percept("left::n($it)") } + event("+!go")
        taken(waiting, listOf(event("+!stop"))) shouldBe listOf("left::n(1)", "left::n(2)", "left::n(3)", "go", "stop")
    }
})
