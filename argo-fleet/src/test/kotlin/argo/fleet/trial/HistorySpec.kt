package argo.fleet.trial

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class HistorySpec : FunSpec({
    fun faults(vararg lines: String) = History(lines.mapIndexed { index, line -> Event.of("${index * 1000} $line") }).faults()

    test("an event reads as it was written") {
        val event = Event(5, "a#1", Kind.SENT, listOf("b", "7"))
        Event.of(event.toString()) shouldBe event
        Event.of("5 a#1 FINISHED") shouldBe Event(5, "a#1", Kind.FINISHED)
    }

    test("messages that are taken in order, or reported failed, are no fault") {
        faults(
            "a#1 SENT b 1", "a#1 SENT b 2", "a#1 SENT b 3", "b#1 TOOK a#1 1", "a#1 TAKEN 1", "a#1 FAILED 2", "b#1 TOOK a#1 3",
            "a#1 TAKEN 3", "a#1 FINISHED",
        ) shouldBe emptyList()
        faults("a#1 SENT b 1", "b#1 TOOK a#1 1", "a#1 FAILED 1", "a#1 FINISHED") shouldBe emptyList()
        faults("a#1 SENT b 1", "a#1 CRASHED") shouldBe emptyList()
    }

    test("a message that is taken twice, by another computer, or behind a later one is a fault") {
        faults("a#1 SENT b 1", "b#1 TOOK a#1 1", "b#2 TOOK a#1 1") shouldBe listOf("message 1 of a#1 was taken 2 times, by b#1, b#2")
        faults("a#1 SENT b 1", "c#1 TOOK a#1 1") shouldBe listOf("c#1 took message 1 of a#1, which was sent to b")
        faults("b#1 TOOK a#1 1") shouldBe listOf("b#1 took message 1 of a#1, which was sent to nobody")
        faults("a#1 SENT b 1", "a#1 SENT b 2", "b#1 TOOK a#1 2", "b#1 TOOK a#1 1") shouldBe
            listOf("b#1 took message 1 of a#1 behind message 2")
    }

    test("a message without an end, with two, or with one that lies is a fault") {
        faults("a#1 SENT b 1", "a#1 FINISHED") shouldBe listOf("message 1 of a#1 had no end")
        faults("a#1 SENT b 1", "a#1 FAILED 1", "a#1 FAILED 1") shouldBe listOf("message 1 of a#1 ended 2 times")
        faults("a#1 SENT b 1", "a#1 TAKEN 1") shouldBe listOf("message 1 of a#1 ended as taken, and nobody took it")
    }

    test("an agent that acts after its next reign has begun to act is a fault, one that moves is none") {
        faults("a#1 ACTED m 1", "a#1 ACTED m 1", "b#1 ACTED m 2", "a#1 ACTED other 1", "a#1 ACTED m 3") shouldBe emptyList()
        faults("a#1 ACTED m 1", "b#1 ACTED m 2", "a#1 ACTED m 1", "b#1 ACTED m 2") shouldBe
            listOf("m acted on a#1 1 microseconds after its next reign, on b#1, had begun to act")
    }
})
