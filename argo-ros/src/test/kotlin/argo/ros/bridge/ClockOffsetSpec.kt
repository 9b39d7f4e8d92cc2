package argo.ros.bridge

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import java.util.concurrent.TimeUnit

class ClockOffsetSpec : FunSpec({
    test("without an answer nothing is known") {
        ClockOffset().whenShown(5) shouldBe null
    }
    test("the answer that took the shortest time counts, until it is one of many") {
        val clock = ClockOffset()
        clock.add(askedNanos = 0, rosNanos = 1_050, answeredNanos = 20)
        clock.add(askedNanos = 100, rosNanos = 1_103, answeredNanos = 104)
        (clock.offsetNanos to clock.errorNanos) shouldBe (1_001L to 2L)
        clock.whenShown(1_180) shouldBe 179
        repeat(8) { clock.add(askedNanos = 300, rosNanos = 2_305, answeredNanos = 310) }
        clock.offsetNanos shouldBe 2_000
    }
    test("a clock that is set counts from its next answer on, however long that takes") {
        val clock = ClockOffset()
        val (hour, second) = TimeUnit.HOURS.toNanos(1) to TimeUnit.SECONDS.toNanos(1)
        clock.add(askedNanos = 0, rosNanos = 1, answeredNanos = 2)
        clock.add(askedNanos = 10 * second, rosNanos = 10 * second + hour, answeredNanos = 10 * second + 2_000)
        clock.offsetNanos shouldBe hour - 1_000
        clock.add(askedNanos = 20 * second, rosNanos = 20 * second, answeredNanos = 20 * second + 4_000)
        clock.offsetNanos shouldBe -2_000
    }
    test("a clock that drifts is the same clock") {
        val clock = ClockOffset()
        val second = TimeUnit.SECONDS.toNanos(1)
        clock.add(askedNanos = 0, rosNanos = 1, answeredNanos = 2)
        clock.add(askedNanos = 10 * second, rosNanos = 10 * second + second / 1_000, answeredNanos = 10 * second + 8_000)
        clock.errorNanos shouldBe 1
    }
})
