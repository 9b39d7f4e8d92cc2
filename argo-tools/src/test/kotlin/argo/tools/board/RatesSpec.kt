package argo.tools.board

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.collections.shouldHaveSize
import io.kotest.matchers.shouldBe

class RatesSpec : FunSpec({
    test("percepts that differ in numbers only are one kind") {
        Rates.kindOf("dist(front,-3.5e2)") shouldBe "dist(front,_)"
        Rates.kindOf("pos(1, [2,3], a4)") shouldBe "pos(_, [_,_], a4)"
        Rates.kindOf("say(\"x 3\")") shouldBe "say(\"x 3\")"
    }

    test("a rate needs two messages at two times") {
        val rates = Rates()
        rates.now() shouldBe null
        rates.count(1_000, listOf("a"))
        rates.now() shouldBe null
        rates.count(1_000, listOf("a"))
        rates.now() shouldBe null
        rates.count(2_000, listOf("a"))
        rates.now() shouldBe 2.0
    }

    test("the rate shown is that of the last ten messages") {
        val rates = Rates()
        repeat(5) { rates.count(it * 1_000L, emptyList()) }
        repeat(10) { rates.count(10_000 + it * 100L, emptyList()) }
        rates.now() shouldBe 10.0
    }

    test("the summary counts by kind and gives the last of each") {
        val rates = Rates()
        repeat(5) { rates.count(it * 500L, listOf("dist(f,$it)", "on")) }
        rates.summary() shouldContainExactly listOf(
            "5 messages in 2.000 s, 2.0 a second", "  dist(f,_): 5, 2.0 a second, last dist(f,4)", "  on: 5, 2.0 a second, last on",
        )
    }

    test("a board that makes up new kinds for ever costs no more than some") {
        val rates = Rates()
        repeat(1_000) { rates.count(it.toLong(), listOf("p$it")) }
        rates.kinds() shouldHaveSize Rates.MAX_KINDS
        rates.summary().last() shouldBe "  800 of other kinds"
    }
})
