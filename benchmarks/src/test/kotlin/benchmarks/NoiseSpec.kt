package benchmarks

import io.kotest.core.spec.style.StringSpec
import io.kotest.matchers.doubles.shouldBeLessThan
import io.kotest.matchers.ints.shouldBeAtMost

/** The figures of `docs/filters.md` on noise, with fewer percepts. */
class NoiseSpec : StringSpec({
    fun left(stray: Stray, words: String) =
        falseStops(SMOOTHING.getValue(words), stray, 100_000).toDouble() / falseStops({}, stray, 100_000)

    "a median of five prevents 99 % of the false stops by stray echoes" { left(Stray.ANY, "median 5") shouldBeLessThan 0.01 }

    "a greatest rate prevents 99 % of the false stops by lost echoes" { left(Stray.LOST, "maxRate 200") shouldBeLessThan 0.01 }

    "each of them delays a stop by at most two percepts" {
        for (words in listOf("median 5", "outliers 3 among 5", "maxRate 200")) {
            worstDelay(SMOOTHING.getValue(words)) { 60 - it * 2.5 } shouldBeAtMost 2
            worstDelay(SMOOTHING.getValue(words)) { if (it < 8) 60.0 else 20.0 } shouldBeAtMost 2
        }
    }
})
