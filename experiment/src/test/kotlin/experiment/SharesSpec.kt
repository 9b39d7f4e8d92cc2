package experiment

import experiment.report.Factorial
import experiment.report.Interval
import experiment.report.SharePivots
import experiment.report.Source
import experiment.report.Squares
import experiment.report.shareIntervals
import io.kotest.core.NamedTag
import io.kotest.core.spec.style.FunSpec
import io.kotest.inspectors.forAll
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.doubles.shouldBeBetween
import io.kotest.matchers.doubles.shouldBeLessThan
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import org.apache.commons.math3.random.Well19937c
import java.util.Random
import kotlin.math.sqrt

/** The true model of an experiment: the mean of each combination. A and C have three levels, B two. Errors have the variance 1. */
private class Truth(val replications: Int, val mean: (Int, Int, Int) -> Double) {
    private val means = Factorial(drawn(1) { 0.0 })
    private val variance = means.total / means.count + 1

    fun drawn(replications: Int, error: () -> Double) =
        List(3) { a -> List(2) { b -> List(3) { c -> List(replications) { mean(a, b, c) + error() } } } }

    fun share(source: Source) = means.squares(source) / means.count / variance

    val errorShare = 1 / variance

    /** Returns the number of [experiments] whose interval contains the true share, for each source and then for the error. */
    fun coverage(experiments: Int, error: (Random) -> Double): List<Double> {
        val random = Random(11)
        val found = List(experiments) { seed ->
            val analysis = Factorial(drawn(replications) { error(random) })
            val intervals = shareIntervals(analysis, seed.toLong(), draws = 1_000).shouldNotBeNull()
            Source.entries.map { share(it) in intervals.sources.getValue(it) } + (errorShare in intervals.error)
        }
        return List(Source.entries.size + 1) { i -> found.count { it[i] } / experiments.toDouble() }
    }
}

/** Returns true if [value] is in the interval, with a tolerance for rounding. */
private operator fun Interval.contains(value: Double) = value >= low - 1e-12 && value <= high + 1e-12

private const val EXPERIMENTS = 400

private val thorough = setOf(NamedTag("Thorough"))

class SharesSpec : FunSpec({
    val truths = mapOf(
        "without any effect" to Truth(3) { _, _, _ -> 0.0 },
        "with one effect" to Truth(3) { a, _, _ -> 1.0 * a },
        "with weak effects of all factors" to Truth(2) { a, b, c -> 0.4 * a + 0.3 * b + 0.2 * c + 0.3 * a * c },
        "with strong effects and an interaction" to Truth(2) { a, b, c -> 8.0 * a + 3.0 * b + 5.0 * a * c },
    )
    truths.forEach { (name, truth) ->
        val tags = if ("interaction" in name) emptySet() else thorough
        test("of experiments $name, intervals hold the true shares in 95 of 100, or some more").config(tags = tags) {
            truth.coverage(EXPERIMENTS, Random::nextGaussian).forAll { it.shouldBeBetween(0.92, 0.995, 0.0) }
        }
    }

    test("errors that are uniform, as those of the simulated sensors, do not change that").config(tags = thorough) {
        truths.values.last().coverage(EXPERIMENTS) { sqrt(12.0) * (it.nextDouble() - 0.5) }.forAll { it.shouldBeBetween(0.92, 0.995, 0.0) }
    }

    test("for one effect they are the published intervals from the noncentral F distribution") {
        /** Returns the 90 % interval for [f], the ratio of variances. */
        fun interval(f: Double, effect: Int, error: Int) =
            SharePivots(Squares(error.toDouble(), error), effect + error + 1, Well19937c(3), draws = 200_000)
                .interval(Squares(f * effect, effect), Squares(0.0, 0), 0.9)

        listOf(
            // M. Smithson, Educational and Psychological Measurement 61 (2001), page 619
            interval(6.0, 1, 42) to Interval(0.0117, 0.2801),
            interval(2.65, 6, 42) to Interval(0.0174, 0.3577),
            // F. Fidler and B. Thompson, the same volume, page 596
            interval(4.0, 3, 16) to Interval(0.0357, 0.5671),
            interval(1.5, 1, 16) to Interval(0.0, 0.3167),
        ).forAll { (found, published) ->
            found.low shouldBe (published.low plusOrMinus 3e-3)
            found.high shouldBe (published.high plusOrMinus 3e-3)
        }
    }

    test("an effect that others drown has a narrow interval, since they are known as well as it") {
        val strong = Truth(3) { a, b, _ -> 1000.0 * a + 1000.0 * b }
        val intervals = shareIntervals(Factorial(strong.drawn(3, Random(1)::nextGaussian)), 1).shouldNotBeNull()
        val share = intervals.sources.getValue(Source.B)
        strong.share(Source.B).shouldBeBetween(share.low, share.high, 0.0)
        (share.high - share.low) shouldBeLessThan 1e-3
    }

    test("without errors all is sure, also where nothing varies or a factor has one level") {
        val sure = Factorial(List(2) { a -> List(1) { List(2) { c -> List(2) { 3.0 * a + c } } } })
        val intervals = shareIntervals(sure, 1).shouldNotBeNull()
        Source.entries.forAll { intervals.sources.getValue(it) shouldBe Interval(sure.share(it), sure.share(it)) }
        intervals.error shouldBe Interval(0.0, 0.0)
        val same = Factorial(List(2) { List(1) { List(2) { List(2) { 1.0 } } } })
        val none = shareIntervals(same, 1).shouldNotBeNull()
        none.sources.getValue(Source.A) shouldBe Interval(0.0, 0.0)
        none.error shouldBe Interval(0.0, 0.0)
    }

    test("a factor of one level has no share, with errors too") {
        val random = Random(2)
        val analysis = Factorial(List(2) { a -> List(1) { List(2) { List(2) { a + random.nextGaussian() } } } })
        shareIntervals(analysis, 1).shouldNotBeNull().sources.getValue(Source.B) shouldBe Interval(0.0, 0.0)
    }

    test("the same seed gives the same intervals, and one replication gives none") {
        val weak = truths.values.first()
        val analysis = Factorial(weak.drawn(2, Random(4)::nextGaussian))
        shareIntervals(analysis, 3)?.sources shouldBe shareIntervals(analysis, 3)?.sources
        shareIntervals(Factorial(weak.drawn(1, Random(4)::nextGaussian)), 3) shouldBe null
    }
})
