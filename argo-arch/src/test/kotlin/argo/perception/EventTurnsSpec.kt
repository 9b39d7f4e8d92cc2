package argo.perception

import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.PropertyTesting
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.long
import io.kotest.property.checkAll
import jason.asSemantics.Event
import jason.asSemantics.Intention
import jason.asSyntax.ASSyntax
import java.util.IdentityHashMap
import java.util.concurrent.ConcurrentLinkedQueue
import kotlin.random.Random

class EventTurnsSpec : FunSpec({
    fun event(trigger: String) = Event(ASSyntax.parseTrigger(trigger), Intention.EmptyInt)
    fun percept(literal: String) = event("+$literal[source(percept)]")
    fun taken(waiting: List<Event>, new: List<Event>): List<String> {
        val queue = ConcurrentLinkedQueue(waiting + new)
        takeTurns(queue, waiting.size)
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
        all.filter { it.startsWith("left") } shouldBe listOf("left::n(1)", "left::n(2)", "left::n(3)")
    }

    test("each event is reached in a number of turns that no later event changes, though more events come than Jason takes") {
        checkAll(PropertyTesting.defaultIterationCount / 20, Arb.long(), Arb.int(2..8)) { seed, boards ->
            val random = Random(seed)
            val queue = ConcurrentLinkedQueue<Event>()
            val due = IdentityHashMap<Event, Int>()
            for (cycle in 0 until 100) {
                val waiting = queue.toList()
                val new = (0 until boards).flatMap { board -> List(random.nextInt(3)) { percept("b$board::n($cycle)") } }
                val counts = waiting.groupingBy { it.trigger.literal.ns.functor }.eachCount().toMutableMap()
                new.forEach { due[it] = cycle + 2 * boards * (counts.merge(it.trigger.literal.ns.functor, 1, Int::plus) ?: 1) }
                queue += new
                takeTurns(queue, waiting.size)
                queue.poll()
                withClue({ "in cycle $cycle, seed $seed" }) { queue.filter { due.getValue(it) <= cycle }.shouldBeEmpty() }
            }
        }
    }

    test("of boards that each have a new event whenever Jason has taken the one before, none waits longer than the others") {
        val boards = (0 until 6).map { "b$it" }
        val queue = ConcurrentLinkedQueue<Event>()
        val taken = (1..1000).map { cycle ->
            val waiting = queue.toList()
            queue += (boards - waiting.map { it.trigger.literal.ns.functor }.toSet()).map { percept("$it::n($cycle)") }
            takeTurns(queue, waiting.size)
            queue.remove().trigger.literal.ns.functor
        }
        taken.windowed(2 * boards.size).filterNot { it.containsAll(boards) }.shouldBeEmpty()
    }

    test("the events of critical percepts stay in front") {
        val critical = listOf(percept("left::near(1)"), percept("left::near(2)"))
        val waiting = critical + listOf(percept("right::n(1)"), percept("left::n(1)"), percept("right::n(2)"))
        taken(waiting, listOf(percept("arm::n(1)"))) shouldBe
            listOf("left::near(1)", "left::near(2)", "right::n(1)", "arm::n(1)", "left::n(1)", "right::n(2)")
    }

    test("without new percepts the queue stays as it is") {
        val waiting = (1..3).map { percept("left::n($it)") } + event("+!go")
        taken(waiting, listOf(event("+!stop"))) shouldBe listOf("left::n(1)", "left::n(2)", "left::n(3)", "go", "stop")
    }
})
