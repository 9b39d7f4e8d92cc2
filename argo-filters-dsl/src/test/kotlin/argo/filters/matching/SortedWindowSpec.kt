package argo.filters.matching

import io.kotest.core.spec.style.StringSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.choice
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.map
import io.kotest.property.arbitrary.numericDouble
import io.kotest.property.checkAll
import kotlin.math.abs

private val series = Arb.list(Arb.choice(Arb.int(0..9).map(Int::toDouble), Arb.numericDouble(-1e6, 1e6).map { it + 0.0 }), 1..40)
private val sizes = Arb.element(3, 5, 7, 99)

class SortedWindowSpec : StringSpec({
    "its median is that of the last numbers, of two in the middle the newer one" {
        checkAll(series, sizes) { numbers, size ->
            val window = SortedWindow(size)
            numbers.forEachIndexed { at, number ->
                window.add(number)
                val last = numbers.subList(maxOf(0, at + 1 - size), at + 1)
                val sorted = last.withIndex().sortedBy { it.value }
                val middle = listOf(sorted[last.size / 2], sorted[(last.size - 1) / 2]).maxBy { it.index }
                window[window.median()] shouldBe middle.value
                window.middle() shouldBe sorted[last.size / 2].value
                window.count shouldBe last.size
            }
        }
    }

    "its median distance is that of all distances to the middle" {
        checkAll(series, sizes) { numbers, size ->
            val window = SortedWindow(size)
            numbers.forEach(window::add)
            val distances = numbers.takeLast(size).map { abs(it - window.middle()) }.sorted()
            window.medianDistance() shouldBe distances[distances.size / 2]
        }
    }
})
