package argo.view

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldHaveSize
import io.kotest.matchers.shouldBe

private const val S = 1_000_000_000L

class RecentNumbersSpec : FunSpec({
    test("each half second of the last minute has the last value that came in it, and none where nothing came") {
        val course = RecentNumbers()
        course.add(listOf(1.0), 0)
        course.add(listOf(2.0), S / 4)
        course.add(listOf(3.0), S)
        val values = course.values(S).single()
        values shouldHaveSize RecentNumbers.STEPS
        values.takeLast(4) shouldBe listOf(null, 2.0, null, 3.0)
    }

    test("what is older than a minute is forgotten, whether anything comes or not") {
        val course = RecentNumbers()
        course.add(listOf(1.0), 0)
        course.values(59 * S).single().filterNotNull() shouldBe listOf(1.0)
        course.values(60 * S).single().filterNotNull() shouldBe emptyList()
        repeat(10_000) { course.add(listOf(it.toDouble()), it * S) }
        course.values(9_999 * S).single().filterNotNull() shouldHaveSize RecentNumbers.STEPS / 2
    }

    test("a number beyond the range of doubles is none, since the page could not be told it") {
        val course = RecentNumbers()
        course.add(listOf("1e999".toDouble(), 4.0), 0)
        course.values(0).map { it.last() } shouldBe listOf(null, 4.0)
    }

    test("each number of a sensor has a course of its own") {
        val course = RecentNumbers()
        course.add(listOf(1.0, -5.0), 0)
        course.add(listOf(2.0), S)
        course.add(listOf(3.0, 7.5), 2 * S)
        course.values(2 * S).map { it.filterNotNull() } shouldBe listOf(listOf(1.0, 2.0, 3.0), listOf(-5.0, 7.5))
        RecentNumbers().values(0) shouldBe emptyList()
    }
})
