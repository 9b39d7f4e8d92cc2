package javino.link

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

private const val MILLI = 1_000_000L
private const val TIMEOUT = 500 * MILLI

class OwedAnswersSpec : FunSpec({
    test("the answer to the only request there was is not late") {
        val owed = OwedAnswers()
        owed.asked(0)
        owed.mayBeLate() shouldBe false
        owed.answered(30 * MILLI)
        owed.asked(40 * MILLI)
        owed.mayBeLate() shouldBe false
    }

    test("after a request without an answer, what comes may be its answer, until the line has been silent") {
        val owed = OwedAnswers()
        owed.asked(0)
        owed.asked(500 * MILLI)
        owed.mayBeLate() shouldBe true
        owed.settled()
        owed.asked(900 * MILLI)
        owed.mayBeLate() shouldBe false
    }

    test("silence is twice the longest time an answer has taken") {
        val owed = OwedAnswers()
        owed.asked(0)
        owed.answered(100 * MILLI)
        owed.asked(200 * MILLI)
        owed.answered(230 * MILLI)
        owed.settlingNanos(300 * MILLI, TIMEOUT) shouldBe 200 * MILLI
    }

    test("silence is 50 ms at least, and the time limit at most") {
        val quick = OwedAnswers()
        quick.asked(0)
        quick.answered(MILLI)
        quick.settlingNanos(10 * MILLI, TIMEOUT) shouldBe 50 * MILLI
        quick.settlingNanos(10 * MILLI, 20 * MILLI) shouldBe 20 * MILLI
        val slow = OwedAnswers()
        slow.asked(0)
        slow.answered(400 * MILLI)
        slow.settlingNanos(0, TIMEOUT) shouldBe TIMEOUT
    }

    test("a board that has never answered may be as slow as its first answer is late, unless it was just starting") {
        val slow = OwedAnswers()
        slow.asked(0)
        slow.asked(250 * MILLI)
        slow.settlingNanos(300 * MILLI, TIMEOUT) shouldBe 300 * MILLI
        val starting = OwedAnswers()
        (0 until 8).forEach { starting.asked(it * 250 * MILLI) }
        starting.settlingNanos(1_900 * MILLI, TIMEOUT) shouldBe 50 * MILLI
    }
})
