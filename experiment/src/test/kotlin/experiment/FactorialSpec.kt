package experiment

import experiment.report.Factorial
import experiment.report.Published
import experiment.report.Source
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.shouldBe
import org.apache.commons.math3.stat.regression.OLSMultipleLinearRegression
import kotlin.math.sqrt
import kotlin.random.Random

/** Draws responses for [sizes] levels of the factors and [replications] replications. */
private fun drawn(random: Random, sizes: List<Int> = listOf(3, 3, 3), replications: Int = 3) =
    List(sizes[0]) { i ->
        List(sizes[1]) { j ->
            List(sizes[2]) { k -> List(replications) { 5.0 * i * k - 3.0 * j + 2.0 * i * j * k + random.nextDouble(-4.0, 4.0) } }
        }
    }

/** Returns the columns of a general linear model for one factor, with effect coding. The coefficients of all levels add up to 0. */
private fun coded(level: Int, size: Int): List<Double> = List(size - 1) { if (level == size - 1) -1.0 else if (level == it) 1.0 else 0.0 }

private fun model(responses: List<List<List<List<Double>>>>, sources: List<Source>): OLSMultipleLinearRegression {
    val sizes = listOf(responses.size, responses[0].size, responses[0][0].size)
    val rows = ArrayList<DoubleArray>()
    val ys = ArrayList<Double>()
    val cells = responses.indices.flatMap { i ->
        responses[i].indices.flatMap { j -> responses[i][j].indices.map { k -> listOf(i, j, k) to responses[i][j][k] } }
    }
    for ((levels, cell) in cells) for (y in cell) {
        rows += sources.flatMap { source ->
            source.factors.map { coded(levels[it], sizes[it]) }.reduce { some, more -> some.flatMap { s -> more.map { m -> s * m } } }
        }.toDoubleArray()
        ys += y
    }
    return OLSMultipleLinearRegression().apply { newSampleData(ys.toDoubleArray(), rows.toTypedArray()) }
}

class FactorialSpec : FunSpec({
    test("a 2×2×2 experiment with two replications, computed by hand") {
        // y = 40 + 20a + 10b + 5c + 3ab + 2ac + 1bc + 0abc ± 1 with a, b, c = -1 or 1, the signs of a 2^k design
        val signs = listOf(-1, 1)
        fun mean(a: Int, b: Int, c: Int) = 40.0 + 20 * a + 10 * b + 5 * c + 3 * a * b + 2 * a * c + b * c
        val responses = signs.map { a -> signs.map { b -> signs.map { c -> listOf(mean(a, b, c) - 1, mean(a, b, c) + 1) } } }
        val analysis = Factorial(responses)
        analysis.mean shouldBe (40.0 plusOrMinus 1e-9)
        // a sum of squares is 2^3 combinations × 2 replications × the square of the effect
        val squares = mapOf(
            Source.A to 6400.0, Source.B to 1600.0, Source.C to 400.0, Source.AB to 144.0, Source.AC to 64.0, Source.BC to 16.0,
            Source.ABC to 0.0,
        )
        squares.forEach { (source, expected) -> analysis.squares(source) shouldBe (expected plusOrMinus 1e-9) }
        analysis.error shouldBe (16.0 plusOrMinus 1e-9)
        analysis.total shouldBe (8640.0 plusOrMinus 1e-9)
        analysis.share(Source.A) shouldBe (6400.0 / 8640 plusOrMinus 1e-12)
        analysis.errorShare shouldBe (16.0 / 8640 plusOrMinus 1e-12)
        // the variance of the error is 16/8 = 2, and of an effect 2/16; the 0.975 quantile of t with 8 degrees of freedom is 2.306
        val (low, high) = analysis.effects(Source.A, 0.95)
        low.value shouldBe (-20.0 plusOrMinus 1e-9)
        high.value shouldBe (20.0 plusOrMinus 1e-9)
        high.interval.high - high.value shouldBe (2.306 * sqrt(2.0 / 16) plusOrMinus 1e-4)
        high.isSignificant shouldBe true
        analysis.effects(Source.ABC, 0.95).any { it.isSignificant } shouldBe false
        analysis.mean(0.95).high shouldBe (40 + 2.306 * sqrt(2.0 / 16) plusOrMinus 1e-4)
    }

    test("the sums of squares are those of a general linear model, source by source") {
        listOf(1, 2, 3).forEach { seed ->
            val responses = drawn(Random(seed), listOf(3, 2, 4))
            val analysis = Factorial(responses)
            val all = Source.entries.toList()
            val residual = model(responses, all).calculateResidualSumOfSquares()
            analysis.error shouldBe (residual plusOrMinus 1e-6)
            all.forEach { source ->
                val without = model(responses, all - source).calculateResidualSumOfSquares()
                analysis.squares(source) shouldBe (without - residual plusOrMinus 1e-6)
            }
        }
    }

    test("the effects and the width of their intervals are those of a general linear model") {
        val responses = drawn(Random(7))
        val analysis = Factorial(responses)
        val model = model(responses, Source.entries)
        val estimates = model.estimateRegressionParameters()
        val deviations = model.estimateRegressionParametersStandardErrors()
        estimates[0] shouldBe (analysis.mean plusOrMinus 1e-9)
        // columns: mean, then two for each of A, B, C
        listOf(Source.A to 1, Source.B to 3, Source.C to 5).forEach { (source, column) ->
            analysis.effects(source, 0.90).take(2).forEachIndexed { level, effect ->
                effect.value shouldBe (estimates[column + level] plusOrMinus 1e-9)
                effect.interval.high - effect.value shouldBe (T_90_54 * deviations[column + level] plusOrMinus 1e-3)
            }
        }
    }

    test("all shares add up to one") {
        val analysis = Factorial(drawn(Random(9)))
        Source.entries.sumOf(analysis::share) + analysis.errorShare shouldBe (1.0 plusOrMinus 1e-9)
    }

    test("without replications there is no error, and nothing is certain") {
        val analysis = Factorial(drawn(Random(1), replications = 1))
        analysis.errorShare shouldBe (0.0 plusOrMinus 1e-12)
        analysis.effects(Source.A, 0.95).none { it.isSignificant } shouldBe true
    }

    test("responses that do not vary have no shares") {
        val analysis = Factorial(List(2) { List(2) { List(2) { listOf(1.0, 1.0) } } })
        analysis.share(Source.C) shouldBe 0.0
    }

    test("what rounding makes of equal responses is no variation") {
        listOf(0.1, 5.3, 12.0, 1e6 / 3).forEach { same ->
            val analysis = Factorial(List(3) { List(3) { List(3) { List(3) { same } } } })
            analysis.total shouldBe 0.0
            Source.entries.map(analysis::share) + analysis.errorShare shouldBe List(8) { 0.0 }
            Source.entries.flatMap { analysis.effects(it, 0.95) }.none { it.isSignificant } shouldBe true
        }
    }

    test("nor does it make effects significant where the replications are all the same") {
        val analysis = Factorial(List(3) { List(3) { k -> List(3) { List(3) { 0.1 + 0.7 * k } } } }) // only B has an effect
        analysis.share(Source.B) shouldBe (1.0 plusOrMinus 1e-12)
        analysis.error shouldBe 0.0
        (Source.entries - Source.B).flatMap { analysis.effects(it, 0.95) }.none { it.isSignificant } shouldBe true
        analysis.effects(Source.B, 0.95).map { it.isSignificant } shouldBe listOf(true, false, true)
    }

    test("a cell with fewer replications than others is refused") {
        val lopsided = listOf(listOf(listOf(listOf(1.0, 2.0), listOf(1.0))))
        shouldThrow<IllegalArgumentException> { Factorial(lopsided) }.message shouldBe
            "a full factorial experiment has all combinations of levels, each with the same number of replications"
    }

    test("the published shares are whole") {
        Published.percent.values.sum() + Published.ERROR_PERCENT shouldBe (100.0 plusOrMinus 0.1)
    }
})

/** The 0.95 quantile of Student's t with 54 degrees of freedom. There are 27 combinations with two more replications each. */
private const val T_90_54 = 1.6736
