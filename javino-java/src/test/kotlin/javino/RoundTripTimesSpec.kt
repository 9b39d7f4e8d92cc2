package javino

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

private const val MILLI = 1_000_000L
private const val TIMEOUT = 500 * MILLI

class RoundTripTimesSpec : FunSpec({
    test("the answer to the only request there was is not late") {
        val history = RoundTripTimes()
        history.asked(0)
        history.mayBeLate() shouldBe false
        history.answered(30 * MILLI)
        history.asked(40 * MILLI)
        history.mayBeLate() shouldBe false
    }

    test("after a request without an answer, what comes may be its answer, until the line has been silent") {
        val history = RoundTripTimes()
        history.asked(0)
        history.asked(500 * MILLI)
        history.mayBeLate() shouldBe true
        history.settled()
        history.asked(900 * MILLI)
        history.mayBeLate() shouldBe false
    }

    test("silence is twice the longest time an answer has taken") {
        val history = RoundTripTimes()
        history.asked(0)
        history.answered(100 * MILLI)
        history.asked(200 * MILLI)
        history.answered(230 * MILLI)
        history.settlingNanos(300 * MILLI, TIMEOUT) shouldBe 200 * MILLI
    }

    test("silence is 50 ms at least, and the time limit at most") {
        val quick = RoundTripTimes()
        quick.asked(0)
        quick.answered(MILLI)
        quick.settlingNanos(10 * MILLI, TIMEOUT) shouldBe 50 * MILLI
        quick.settlingNanos(10 * MILLI, 20 * MILLI) shouldBe 20 * MILLI
        val slow = RoundTripTimes()
        slow.asked(0)
        slow.answered(400 * MILLI)
        slow.settlingNanos(0, TIMEOUT) shouldBe TIMEOUT
    }

    test("a board that has never answered may be as slow as its first answer is late, unless it was just starting") {
        val slow = RoundTripTimes()
        slow.asked(0)
        slow.asked(250 * MILLI)
        slow.settlingNanos(300 * MILLI, TIMEOUT) shouldBe 300 * MILLI
        val starting = RoundTripTimes()
        (0 until 8).forEach { starting.asked(it * 250 * MILLI) }
        starting.settlingNanos(1_900 * MILLI, TIMEOUT) shouldBe 50 * MILLI
    }
})
