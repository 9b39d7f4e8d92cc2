package samples.board

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import javino.Frame
import javino.LineSettings
import javino.PortGoneException
import javino.sim.MemoryLine
import java.util.concurrent.CopyOnWriteArrayList
import kotlin.concurrent.thread

private const val DEADLINE_S = 30L

/** A board on a fast line; what it does and says is kept. */
private class FastBench(private val percepts: String) : AutoCloseable {
    private val line = MemoryLine.paced("bench", LineSettings(1_000_000))
    val deeds = CopyOnWriteArrayList<String>()
    private val board = thread(name = "board") {
        try {
            LibraryBoard(object : Sketch {
                override fun percepts() = this@FastBench.percepts
                override fun act(command: String) {
                    deeds += command
                }
            }).run(line.board())
        } catch (_: PortGoneException) {
            // the bench is cleared
        } catch (_: InterruptedException) {
            // while it answers
        }
    }

    /** Sends [frames] and returns the next bytes of the answer, as many as [expected] has. */
    fun answer(expected: String, vararg frames: Frame): String {
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

private fun version2(text: String, flags: Int = 0, sequence: Int = 0) = Frame.version2(text.toByteArray(), flags, sequence)

class LibraryBoardSpec : FunSpec({
    test("it answers in the version it is asked in") {
        FastBench("dist(f,9);").use { bench ->
            val first = "${Frame.of("dist(f,9);")}"
            bench.answer(first, Frame.of("getPercepts")) shouldBe first
            val second = "${version2("dist(f,9);")}"
            bench.answer(second, version2("getPercepts")) shouldBe second
        }
    }

    test("it answers with what it is asked for") {
        FastBench("dist(f,9);light(f,3);temp(b,1);distance(f,8);").use { bench ->
            val expected = "${version2("dist(f,9);temp(b,1);")}"
            bench.answer(expected, version2("getPercepts(dist,temp)")) shouldBe expected
        }
    }

    test("it acts once when an action is repeated, and acknowledges each time") {
        FastBench("").use { bench ->
            val acknowledged = "${version2("", Frame.ACK, 7)}"
            repeat(2) { bench.answer(acknowledged, version2("stop", Frame.ACK_WANTED, 7)) shouldBe acknowledged }
            val next = "${version2("", Frame.ACK, 8)}"
            bench.answer(next, version2("stop", Frame.ACK_WANTED, 8)) shouldBe next
            bench.deeds shouldBe listOf("stop", "stop")
        }
    }

    test("a long answer goes in fragments in version 2, and in whole percepts in version 1") {
        val percept = "x(${"1".repeat(96)});"
        FastBench(percept.repeat(3)).use { bench ->
            val whole = percept.repeat(3)
            val fragments = "${version2(whole.take(255), Frame.MORE, 0)}${version2(whole.drop(255), 0, 1)}"
            bench.answer(fragments, version2("getPercepts")) shouldBe fragments
            val messages = "${Frame.of(percept.repeat(2))}${Frame.of(percept)}"
            bench.answer(messages, Frame.of("getPercepts")) shouldBe messages
        }
    }

    test("messages that arrive while it answers are handled afterwards, in their order") {
        FastBench("dist(f,9);").use { bench ->
            val expected = "${version2("dist(f,9);")}${version2("", Frame.ACK, 1)}${version2("", Frame.ACK, 2)}"
            bench.answer(
                expected, version2("getPercepts"), version2("one", Frame.ACK_WANTED, 1), version2("two", Frame.ACK_WANTED, 2),
            ) shouldBe expected
            bench.deeds shouldBe listOf("one", "two")
        }
    }
})
