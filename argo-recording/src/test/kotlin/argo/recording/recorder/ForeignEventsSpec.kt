package argo.recording.recorder

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import jason.asSemantics.Event
import jason.asSemantics.Intention
import jason.asSyntax.ASSyntax.parseTrigger

class ForeignEventsSpec : FunSpec({
    fun event(text: String) = Event(parseTrigger(text), Intention.EmptyInt)

    val first = event("+first")
    val waiting = mutableListOf(first)
    var isOwn = true
    val events = ForeignEvents({ waiting }) { isOwn }

    test("events that waited when it began, or that the agent adds, are its own, also if they are selected again") {
        val own = event("+own")
        events.eventAdded(own)
        listOf(first, own, own).map(events::takeSelected) shouldBe listOf(false, false, false)
        events.take().shouldBeEmpty()
    }

    test("an event that another thread adds is collected, and is not collected again when it is selected") {
        val foreign = event("+foreign")
        isOwn = false
        events.eventAdded(foreign)
        isOwn = true
        events.take() shouldContainExactly listOf(foreign)
        events.takeSelected(foreign) shouldBe false
    }

    test("an event that is selected in the cycle in which another thread adds it is another thread's") {
        val foreign = event("+foreign")
        isOwn = false
        events.eventAdded(foreign)
        isOwn = true
        events.takeSelected(foreign) shouldBe true
        events.take().shouldBeEmpty()
    }

    test("an event that is selected before the other thread has told of it is that thread's, and is not collected when it tells") {
        val foreign = event("+jag_shutting_down(3000)")
        events.takeSelected(foreign) shouldBe true
        isOwn = false
        events.eventAdded(foreign)
        isOwn = true
        events.take().shouldBeEmpty()
        events.size shouldBe 0
    }

    test("events that have gone are forgotten, those that wait are not") {
        waiting.clear()
        repeat(5_000) { events.eventAdded(event("+gone($it)")) }
        val kept = event("+kept")
        events.eventAdded(kept)
        waiting += kept
        events.takeSelected(kept) shouldBe false
        events.takeSelected(kept) shouldBe false
    }
})
