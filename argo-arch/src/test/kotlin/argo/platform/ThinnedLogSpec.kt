package argo.platform

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.ints.shouldBeLessThan
import io.kotest.matchers.shouldBe

private class LogBench {
    val time = TestTime()
    val lines = mutableListOf<String>()
    val log = ThinnedLog({ time.clock.nanos() / 1_000_000 }, time::later)

    fun says(kind: String, line: String) = log.report(kind) { lines += line + it }

    fun news() = lines.toList().also { lines.clear() }
}

class ThinnedLogSpec : FunSpec({
    test("what comes seldom is told at once, each time") {
        val bench = LogBench()
        repeat(100) {
            bench.says("port", "on $it")
            bench.news() shouldContainExactly listOf("on $it")
            bench.time.pass(120_000)
        }
        bench.time.isIdle() shouldBe true
    }

    test("what comes again and again is told ever more seldom, with the number of lines that were left out, and the last one always") {
        val bench = LogBench()
        repeat(ThinnedLog.FREE) { bench.says("port", "line $it") }
        bench.news().size shouldBe ThinnedLog.FREE
        repeat(50) { bench.says("port", "more $it") }
        bench.lines.shouldBeEmpty()
        bench.time.step()
        bench.news() shouldContainExactly listOf("more 49 (and 49 more like this before)")
        bench.says("port", "off")
        bench.time.step()
        bench.news() shouldContainExactly listOf("off")
        bench.time.isIdle() shouldBe true
    }

    test("two lines a second for a day are not three hundred") {
        val bench = LogBench()
        repeat(2 * 86_400) {
            while (!bench.time.isIdle() && bench.time.nextMs() <= bench.time.clock.nanos() / 1_000_000) bench.time.step()
            bench.says("port", if (it % 2 == 0) "timeout" else "on")
            bench.time.pass(500)
        }
        bench.lines.size shouldBeLessThan 320
    }

    test("a kind holds up no other") {
        val bench = LogBench()
        repeat(100) { bench.says("one", "one") }
        bench.news()
        bench.says("two", "two")
        bench.news() shouldContainExactly listOf("two")
    }
})
