package javino

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

private const val MILLI = 1_000_000L

class RoundTripTimesSpec : FunSpec({
    test("the timeout is twice the longest time that an answer has taken, at least 100 ms, and as given while none was timed") {
        val times = RoundTripTimes(1_000)
        times.timeoutNanos() shouldBe 1_000 * MILLI
        times.answeredAfter(3 * MILLI)
        times.timeoutNanos() shouldBe 100 * MILLI
        times.answeredAfter(80 * MILLI)
        times.answeredAfter(20 * MILLI)
        times.timeoutNanos() shouldBe 160 * MILLI
    }

    test("each answer that is late doubles the timeout, up to sixteen times, until one is timed") {
        val times = RoundTripTimes(1_000)
        times.answeredAfter(100 * MILLI)
        repeat(3) { times.timedOut() }
        times.timeoutNanos() shouldBe 1_600 * MILLI
        repeat(10) { times.timedOut() }
        times.timeoutNanos() shouldBe 3_200 * MILLI
        times.answeredAfter(100 * MILLI)
        times.timeoutNanos() shouldBe 200 * MILLI
    }
})
