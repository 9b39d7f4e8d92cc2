package argo.fleet.node

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class RetrySpec : FunSpec({
    test("a failure is tried again once, after half a minute, then after twice the time each, an hour at most") {
        var seconds = 0L
        val retry = Retry { seconds * 1_000_000_000 }
        retry.isDue() shouldBe false
        val waits = List(9) {
            retry.failed()
            val failed = seconds
            while (!retry.isDue()) seconds++
            retry.isDue() shouldBe false
            seconds - failed
        }
        waits shouldBe listOf(30L, 60, 120, 240, 480, 960, 1920, 3600, 3600)
    }
})
