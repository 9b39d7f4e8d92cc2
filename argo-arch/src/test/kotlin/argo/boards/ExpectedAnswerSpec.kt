package argo.boards

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import java.util.concurrent.TimeUnit

class ExpectedAnswerSpec : FunSpec({
    fun ms(ms: Int) = TimeUnit.MILLISECONDS.toNanos(ms.toLong())

    fun answered() = ExpectedAnswer().apply {
        asked(ms(20))
        came(ms(23))
        read(nextNanos = ms(40))
    }

    test("nothing is expected of a board that has never answered") {
        ExpectedAnswer().apply { asked(ms(20)) }.isNear(ms(21)) shouldBe false
    }

    test("after an answer the next is expected as long after the next instant as answers take, before the board was asked") {
        val answer = answered()
        answer.isNear(ms(24)) shouldBe false
        answer.isNear(ms(40)) shouldBe false // 3 ms early
        answer.isNear(ms(41)) shouldBe true
        answer.isNear(ms(48)) shouldBe true // 5 ms late
        answer.isNear(ms(49)) shouldBe false
    }

    test("an answer that has come is expected until it is read, however early it is") {
        val answer = answered()
        answer.asked(ms(100))
        answer.isNear(ms(100)) shouldBe false
        answer.came(ms(100))
        answer.isNear(ms(100)) shouldBe true
    }

    test("a board that is asked late answers late") {
        val answer = answered().apply { asked(ms(46)) }
        answer.isNear(ms(49)) shouldBe true
        answer.isNear(ms(54)) shouldBe true
    }

    test("none is expected after one that stayed out, nor of a board that speaks unasked") {
        val unasked = ExpectedAnswer().apply {
            came(ms(23))
            read(nextNanos = ms(40))
        }
        answered().apply { stayedOut() }.isNear(ms(43)) shouldBe false
        unasked.isNear(ms(40)) shouldBe false
    }
})
