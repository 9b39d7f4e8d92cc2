package argo.view

import argo.observing.CommandFailure
import argo.observing.IssuedCommand
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldHaveSize
import io.kotest.matchers.comparables.shouldBeLessThan
import io.kotest.matchers.shouldBe

class CommandRecordSpec : FunSpec({
    var now = 0L
    var number = 0L
    fun record() = CommandRecord().also { now = 0 }
    fun CommandRecord.issue(port: String, text: String) = IssuedCommand(++number, port, text, now).also(::issued)

    test("the first command of each port is on the line, the others wait") {
        val record = record()
        record.issue("left", "a")
        record.issue("left", "b")
        record.issue("right", "c")
        record.state(0).unfinished.map { it.text to it.state } shouldBe listOf("a" to "line", "b" to "waiting", "c" to "line")
        record.state(0).waiting shouldBe 3
    }

    test("a command that has gone out tells how long it took and how long ago it was given") {
        val record = record()
        val command = record.issue("left", "a")
        now = 30_000_000
        record.ended(command, null, now)
        with(record.state(50_000_000).finished.single()) { listOf(state, tookMs, ageMs, error) shouldBe listOf("done", 30L, 50L, null) }
        record.state(now).unfinished.shouldBeEmpty()
        record.count shouldBe 1
    }

    test("a command that failed tells why") {
        val record = record()
        record.ended(record.issue("left", "a"), CableOut, now)
        with(record.state(0).finished.single()) { state to error shouldBe ("failed" to "port_gone: the cable is out") }
    }

    test("however many there are, few are kept, and the others are counted") {
        val record = record()
        val commands = (1..10_000).map { record.issue("left", "c$it") }
        val state = record.state(0)
        state.waiting shouldBe 10_000
        state.unfinished.size shouldBeLessThan 100
        state.unfinished.first().text shouldBe "c1"
        commands.forEach { record.ended(it, null, now) }
        with(record.state(0)) {
            waiting shouldBe 0
            unfinished.shouldBeEmpty()
            finished.first().text shouldBe "c10000"
            finished.size shouldBeLessThan 100
        }
    }

    test("equal commands with the same end, one after the other, are one with a count and the last one's times") {
        val record = record()
        fun end(text: String, failure: CommandFailure? = null) {
            val command = record.issue("left", text)
            now += 5_000_000
            record.ended(command, failure, now)
        }
        end("front")
        repeat(12) { end("stop") }
        val first = record.state(now).finished.first()
        listOf(first.text, first.times, first.tookMs, first.ageMs) shouldBe listOf("stop", 12, 5L, 5L)
        end("stop", CableOut)
        end("stop")
        record.state(now).finished.map { it.text to it.times } shouldBe listOf("stop" to 1, "stop" to 1, "stop" to 12, "front" to 1)
        record.state(now).finished[2].number shouldBe first.number
    }

    test("equal commands that wait are one with a count, and that on the line is not among them") {
        val record = record()
        repeat(4) { record.issue("left", "stop") }
        record.issue("left", "front")
        record.state(0).unfinished.map { Triple(it.text, it.state, it.times) } shouldBe
            listOf(Triple("stop", "line", 1), Triple("stop", "waiting", 3), Triple("front", "waiting", 1))
        record.state(0).waiting shouldBe 5
    }

    test("a command longer than any page wants is cut") {
        val record = record()
        record.issue("left", "x".repeat(100_000))
        record.state(0).unfinished.shouldHaveSize(1).single().text.length shouldBeLessThan 400
    }
})

private object CableOut : CommandFailure {
    override val error = "port_gone"
    override val cause = "the cable is out"
}
