package argo.ros.bridge

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class ClockOffsetSpec : FunSpec({
    test("without an answer a message is of the time when it came") {
        ClockOffset().trueAt(5, 100) shouldBe 100
    }
    test("the answer that took the shortest time counts, until it is one of many") {
        val clock = ClockOffset()
        clock.add(askedNanos = 0, rosNanos = 1_050, answeredNanos = 20)
        clock.add(askedNanos = 100, rosNanos = 1_103, answeredNanos = 104)
        (clock.offsetNanos to clock.errorNanos) shouldBe (1_001L to 2L)
        clock.trueAt(1_180, 200) shouldBe 179
        repeat(8) { clock.add(askedNanos = 300, rosNanos = 2_305, answeredNanos = 310) }
        clock.offsetNanos shouldBe 2_000
    }
    test("no message is of a time after it came, nor ages old") {
        val clock = ClockOffset().apply { add(0, 1_000, 0) }
        clock.trueAt(1_300, 200) shouldBe 200
        clock.trueAt(1_000, ClockOffset.MAX_AGE_NANOS + 1) shouldBe ClockOffset.MAX_AGE_NANOS + 1
        clock.trueAt(null, 200) shouldBe 200
    }
})
