package benchmarks

import io.kotest.core.spec.style.StringSpec
import io.kotest.matchers.doubles.shouldBeLessThan
import io.kotest.matchers.ints.shouldBeAtMost

/** Checks the figures of `docs/filters.md` on noise, with fewer percepts. */
class NoiseSpec : StringSpec({
    fun left(stray: Stray, words: String) =
        falseStops(SMOOTHING.getValue(words), stray, 100_000).toDouble() / falseStops({}, stray, 100_000)

    "a median of five prevents 99 % of the false stops by stray echoes" { left(Stray.ANY, "median 5") shouldBeLessThan 0.01 }

    "a greatest rate prevents 99 % of the false stops by lost echoes" { left(Stray.LOST, "maxRate 200") shouldBeLessThan 0.01 }

    "outliers left out before a median of three prevent 99 % of the false stops of each kind" {
        for (stray in Stray.entries) left(stray, "outliers 3 among 5, median 3") shouldBeLessThan 0.01
    }

    "a median of five, outliers among five and a greatest rate delay a stop by at most two percepts" {
        for (words in listOf("median 5", "outliers 3 among 5", "maxRate 200")) {
            delay(SMOOTHING.getValue(words), DRIVING) shouldBeAtMost 2
            delay(SMOOTHING.getValue(words), APPEARING) shouldBeAtMost 2
        }
    }
})
