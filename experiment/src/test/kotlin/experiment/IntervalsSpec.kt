package experiment

import experiment.report.Interval
import experiment.report.decimals
import experiment.report.medianInterval
import experiment.report.proportionInterval
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.shouldBe

class IntervalsSpec : FunSpec({
    test("a share of runs has Wilson's interval, also where all or none have it") {
        proportionInterval(27, 27).let { (low, high) ->
            low shouldBe (0.8755 plusOrMinus 1e-4) // 27 / (27 + 1.96²)
            high shouldBe (1.0 plusOrMinus 1e-9)
        }
        proportionInterval(0, 9).let { (low, high) ->
            low shouldBe (0.0 plusOrMinus 1e-9)
            high shouldBe (0.2991 plusOrMinus 1e-4) // 1.96² / (9 + 1.96²)
        }
    }

    test("the median of 27 lies between the eighth and the twentieth, that of six between the least and the greatest") {
        medianInterval((1..27).map(Int::toDouble)) shouldBe Interval(8.0, 20.0)
        medianInterval(listOf(3.0, 1.0, 2.0, 6.0, 5.0, 4.0)) shouldBe Interval(1.0, 6.0)
        medianInterval((1..5).map(Int::toDouble)) shouldBe null
        medianInterval(emptyList()) shouldBe null
    }

    test("an interval leaves two digits of half its width, or one if they are above 35") {
        fun decimals(halfWidth: Double) = Interval(5 - halfWidth, 5 + halfWidth).decimals
        listOf(40.0, 3.6, 3.5, 0.5, 0.25, 0.05, 0.0).map(::decimals) shouldBe listOf(0, 0, 1, 1, 2, 2, 3)
    }
})
