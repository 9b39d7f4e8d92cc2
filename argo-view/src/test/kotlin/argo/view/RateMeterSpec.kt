package argo.view

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe

private const val MS = 1_000_000L

class RateMeterSpec : FunSpec({
    test("a rate is what happened in the last two seconds, by the second") {
        val meter = RateMeter()
        var rates: Rates? = null
        for (tick in 0L..100) rates = meter.rates(tick * 100 * MS, Counts(tick, 2 * tick, 3 * tick, 40 * tick))
        with(rates.shouldNotBeNull()) {
            frames shouldBe (10.0 plusOrMinus 0.01)
            handOvers shouldBe (20.0 plusOrMinus 0.01)
            commands shouldBe (30.0 plusOrMinus 0.01)
            cycles shouldBe (400.0 plusOrMinus 0.01)
        }
    }

    test("what has ended is at nought two seconds later") {
        val meter = RateMeter()
        for (tick in 0L..20) meter.rates(tick * 100 * MS, Counts(tick, 0, 0, 0))
        for (tick in 21L..40) meter.rates(tick * 100 * MS, Counts(20, 0, 0, 0))
        meter.rates(4100 * MS, Counts(20, 0, 0, 0)).shouldNotBeNull().frames shouldBe 0.0
    }

    test("a moment is too short for a rate") {
        val meter = RateMeter()
        meter.rates(0, Counts(0, 0, 0, 0)) shouldBe null
        meter.rates(100 * MS, Counts(5, 0, 0, 0)) shouldBe null
    }

    test("after a pause without anybody looking the pause is not taken for a moment") {
        val meter = RateMeter()
        meter.rates(0, Counts(0, 0, 0, 0))
        meter.rates(100_000 * MS, Counts(1000, 0, 0, 0)).shouldNotBeNull().frames shouldBe (10.0 plusOrMinus 0.01)
    }
})
