package samples.experiment

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.doubles.shouldBeBetween
import io.kotest.matchers.doubles.shouldBeGreaterThan
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import samples.experiment.analysis.Factorial
import samples.experiment.analysis.Interval
import samples.experiment.analysis.Source
import samples.experiment.analysis.medianInterval
import samples.experiment.analysis.proportionInterval
import samples.experiment.analysis.shareIntervals
import kotlin.random.Random

class IntervalsSpec : FunSpec({
    /** Two levels of each factor, three replications: A moves the response by 10, errors by up to [noise]. */
    fun experiment(noise: Double, replications: Int = 3): Factorial {
        val random = Random(7)
        return Factorial(List(2) { a -> List(2) { List(2) { List(replications) { 10.0 * a + noise * random.nextDouble(-1.0, 1.0) } } } })
    }

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

    test("a share without errors is sure, and errors widen its interval") {
        val sure = shareIntervals(experiment(0.0), Random(1))[Source.A].shouldNotBeNull()
        sure shouldBe Interval(1.0, 1.0)
        val analysis = experiment(4.0)
        val intervals = shareIntervals(analysis, Random(1))
        val unsure = intervals[Source.A].shouldNotBeNull()
        analysis.share(Source.A).shouldBeBetween(unsure.low, unsure.high, 0.0)
        (unsure.high - unsure.low) shouldBeGreaterThan 0.02
    }

    test("the same seed gives the same intervals, and one replication gives none") {
        val analysis = experiment(4.0)
        shareIntervals(analysis, Random(3))[Source.A] shouldBe shareIntervals(analysis, Random(3))[Source.A]
        shareIntervals(experiment(4.0, replications = 1), Random(3))[Source.A] shouldBe null
    }

    test("errors that are drawn anew have the variance of the responses") {
        val analysis = experiment(4.0)
        val random = Random(5)
        val variance = List(400) { analysis.resampled(random) }.map { it.error / it.errorFreedom }.average()
        variance shouldBe (analysis.error / analysis.errorFreedom plusOrMinus 0.15 * analysis.error / analysis.errorFreedom)
    }

    test("an interval leaves as many decimals as the first digit of its width") {
        listOf(Interval(0.0, 30.0), Interval(1.0, 1.5), Interval(1.0, 1.04), Interval(2.0, 2.0)).map { it.decimals } shouldBe
            listOf(0, 1, 2, 3)
    }
})
