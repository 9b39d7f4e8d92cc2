package benchmarks

import io.kotest.core.spec.style.StringSpec
import io.kotest.matchers.doubles.shouldBeLessThan

/** The figures of `docs/filters.md` on noise, with fewer percepts. */
class NoiseSpec : StringSpec({
    fun left(stray: Stray, words: String) =
        falseStops(SMOOTHING.getValue(words), stray, 100_000).toDouble() / falseStops({}, stray, 100_000)

    "a median of five prevents 99 % of the false stops by stray echoes" { left(Stray.ANY, "median 5") shouldBeLessThan 0.01 }

    "a greatest rate prevents 99 % of the false stops by lost echoes" { left(Stray.LOST, "maxRate 200") shouldBeLessThan 0.01 }
})
