package argo.recording.agent

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import jason.asSemantics.Event
import jason.asSemantics.Intention
import jason.asSyntax.ASSyntax

class CourseNoteSpec : FunSpec({
    test("an event is recorded as it was chosen, though its belief gets another source afterwards") {
        val event = Event(ASSyntax.parseTrigger("+dist(f,41)[source(percept)]"), Intention.EmptyInt)
        val note = CourseNote(event.triggerNow(), null, null, null, emptyList(), emptyList(), 1)
        event.trigger.literal.addSource(ASSyntax.createAtom("bob"))
        note.course().event shouldBe "+dist(f,41)[source(percept)]"
    }
})
