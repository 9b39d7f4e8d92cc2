package javino.sim

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import javino.Frame
import javino.LineClock
import javino.LineSettings
import javino.PortGoneException
import javino.wire.AnswerPart
import javino.wire.BoardAction
import javino.wire.BoardRule
import javino.wire.CommandItem
import javino.wire.CriticalReport
import javino.wire.FrameKind
import javino.wire.PerceptWriter
import javino.wire.ReflexOutcome
import javino.wire.Welcome
import javino.wire.WireFrame
import java.util.concurrent.CopyOnWriteArrayList
import kotlin.concurrent.thread

private const val DEADLINE_S = 120L

/** A board on a fast line. Records its actions and its output. */
private class FastBench(vararg percepts: String, rules: Int = 0, actions: List<String> = emptyList()) : AutoCloseable {
    @Volatile
    var percepts = percepts.toList()
    private val line = MemoryLine.paced("bench", LineSettings(1_000_000))
    val deeds = CopyOnWriteArrayList<String>()
    private val board = thread(name = "board") {
        try {
            val sketch = object : Sketch {
                override fun actions() = actions.map { BoardAction(it, 0) }
                override fun percepts() = this@FastBench.percepts
                override fun act(command: String) = deeds.add(command)
            }
            sketch.run(line.board(), LineClock.system(), rules)
        } catch (_: PortGoneException) {
        } catch (_: InterruptedException) {
        }
    }

    /** Sends [frames] and returns as many bytes of the answer as [expected] has. Each character is a byte. */
    fun answer(expected: String, vararg frames: String): String {
        val bytes = frames.joinToString("").toByteArray(Charsets.ISO_8859_1)
        line.computer().write(bytes, 0, bytes.size, 1000)
        val buffer = ByteArray(expected.length)
        var count = 0
        val deadline = System.nanoTime() + DEADLINE_S * 1_000_000_000
        while (count < buffer.size && System.nanoTime() < deadline) count += line.computer().read(buffer, count, buffer.size - count, 100)
        return String(buffer, 0, count, Charsets.ISO_8859_1)
    }

    override fun close() {
        line.unplug()
        board.interrupt()
        board.join(DEADLINE_S * 1000)
        check(!board.isAlive) { "the board still runs after its line has gone" }
    }
}

private fun version1(text: String) = Frame.of(text).toString()

private fun version2(kind: FrameKind, number: Int, payload: String = "") =
    String(WireFrame.of(kind, number, payload).toBytes(NONCE), Charsets.ISO_8859_1)

private const val NONCE = 7
private val hello = version2(FrameKind.HELLO, NONCE)
private val welcome = version2(FrameKind.WELCOME, 0, Welcome(7, 255, 255, 0).payload())

private fun ask(functors: String = "") = version2(FrameKind.ASK, 1, "\u0000$functors")

private fun command(number: Int, text: String) = command(number, CommandItem.Text(text))

private fun command(number: Int, item: CommandItem) = version2(FrameKind.COMMANDS, number, item.payload())

/** Returns the answer to request 1 of a computer that knows no shapes. */
private fun answer(vararg percepts: String): String = AnswerPart.split(1, PerceptWriter(126).items(percepts.toList(), 0))
    .joinToString("") { version2(it.kind(), 0, it.payload()) }

/** Tests the bytes of a sketch's board. */
class SketchOnLineSpec : FunSpec({
    test("it answers in the version it is asked in") {
        FastBench("dist(f,9)").use { bench ->
            val first = version1("dist(f,9);")
            bench.answer(first, version1("getPercepts")) shouldBe first
            val second = welcome + answer("dist(f,9);")
            bench.answer(second, hello, ask()) shouldBe second
        }
    }

    test("it answers with what it is asked for") {
        FastBench("dist(f,9)", "light(f,3)", "temp(b,1)", "distance(f,8)").use { bench ->
            val expected = welcome + answer("dist(f,9);", "temp(b,1);")
            bench.answer(expected, hello, ask("(dist,temp)")) shouldBe expected
        }
    }

    test("it acts once when a command is repeated, and acknowledges each time") {
        FastBench().use { bench ->
            bench.answer(welcome, hello) shouldBe welcome
            val acknowledged = version2(FrameKind.ACK, 1)
            repeat(2) { bench.answer(acknowledged, command(0, "stop")) shouldBe acknowledged }
            val next = version2(FrameKind.ACK, 2)
            bench.answer(next, command(1, "stop")) shouldBe next
            bench.deeds shouldBe listOf("stop", "stop")
        }
    }

    test("it tells its actions, and is sent them by their numbers") {
        FastBench(actions = listOf("front", "stop")).use { bench ->
            val described = welcome + version2(FrameKind.ACK, 1)
            bench.answer(described, hello, version2(FrameKind.COMMANDS, 0, CommandItem.Action(1).payload())) shouldBe described
            bench.deeds shouldBe listOf("stop")
        }
    }

    test("a long answer goes in parts in version 2, and in whole percepts in version 1") {
        val percept = "x(${"1".repeat(96)});"
        FastBench(*Array(3) { "x(${"1".repeat(96)})" }).use { bench ->
            val messages = version1(percept.repeat(2)) + version1(percept)
            bench.answer(messages, version1("getPercepts")) shouldBe messages
            val parts = welcome + answer(percept, percept, percept)
            bench.answer(parts, hello, ask()) shouldBe parts
        }
    }

    test("it watches a rule, carries out its reflex and reports the percept, each time that the rule begins to be met") {
        FastBench("dist(f,81)", rules = 1).use { bench ->
            val expected = version2(FrameKind.WELCOME, 0, Welcome(7, 255, 255, 1).payload()) + version2(FrameKind.ACK, 1)
            val atMost80 = BoardRule.Condition(2, BoardRule.Operator.AT_MOST, "80")
            val rule = BoardRule("dist", listOf(atMost80), "stop").setting(1)
            bench.answer(expected, hello, command(0, rule)) shouldBe expected
            bench.percepts = listOf("dist(f,80)")
            val report = version2(FrameKind.CRITICAL, 1, CriticalReport(1, ReflexOutcome.CARRIED_OUT, "dist(f,80);").payload())
            bench.answer(report) shouldBe report
            bench.deeds shouldBe listOf("stop")
        }
    }

    test("without room for rules it refuses them") {
        FastBench("dist(f,81)").use { bench ->
            val expected = welcome + String(WireFrame(FrameKind.ACK, true, false, 1, "").toBytes(NONCE), Charsets.ISO_8859_1)
            bench.answer(expected, hello, command(0, BoardRule("dist", listOf(), "stop").setting(1))) shouldBe expected
        }
    }

    test("messages that arrive while it answers are handled afterwards, in their order") {
        FastBench("dist(f,9)").use { bench ->
            val expected = welcome + answer("dist(f,9);") + version2(FrameKind.ACK, 1) + version2(FrameKind.ACK, 2)
            bench.answer(expected, hello, ask(), command(0, "one"), command(1, "two")) shouldBe expected
            bench.deeds shouldBe listOf("one", "two")
        }
    }
})
