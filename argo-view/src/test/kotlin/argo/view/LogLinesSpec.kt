package argo.view

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldHaveSize
import io.kotest.matchers.comparables.shouldBeLessThan
import io.kotest.matchers.shouldBe
import java.util.logging.Level
import java.util.logging.LogRecord

class LogLinesSpec : FunSpec({
    var now = 0L
    var changes = 0
    fun record() = LogLines({ now }) { changes++ }.also { now = 0 }
    fun LogLines.print(text: String, level: Level = Level.INFO) = publish(LogRecord(level, text))

    test("lines are kept with their ages, the latest first, and each is news") {
        changes = 0
        val record = record()
        record.print("driving")
        now = 30_000_000
        record.print("no plan for this", Level.WARNING)
        record.state(50_000_000).map { Triple(it.text, it.warning, it.ageMs) } shouldBe
            listOf(Triple("no plan for this", true, 20L), Triple("driving", false, 50L))
        changes shouldBe 2
    }

    test("a line that comes again is counted") {
        val record = record()
        repeat(3) { record.print("driving") }
        record.print("driving", Level.WARNING)
        record.print("stopped")
        record.print("driving")
        record.state(0).map { it.text to it.times } shouldBe
            listOf("driving" to 1, "stopped" to 1, "driving" to 1, "driving" to 3)
    }

    test("however much is printed, little is kept") {
        val record = record()
        repeat(10_000) { record.print("line $it " + "x".repeat(1000)) }
        record.state(0) shouldHaveSize 50
        record.state(0).first().text.take(9) shouldBe "line 9999"
        record.state(0).forEach { it.text.length shouldBeLessThan 400 }
    }
})
