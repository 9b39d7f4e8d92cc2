package samples.board

import io.kotest.assertions.nondeterministic.eventually
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import javino.Frame
import javino.LineSettings
import javino.PortGoneException
import javino.Transport
import javino.sim.MemoryLine
import javino.sim.Sketch
import java.util.concurrent.LinkedBlockingQueue
import java.util.concurrent.TimeUnit
import kotlin.concurrent.thread
import kotlin.time.Duration.Companion.seconds

private const val DEADLINE_S = 120L

/** A board on a line at 9600 baud that stores its commands. */
private class Bench(private vararg val percepts: String, loopMs: Int = 0) : AutoCloseable {
    private val line = MemoryLine.paced("bench", LineSettings.defaults())
    val computer: Transport = line.computer()
    val commands = LinkedBlockingQueue<String>()
    private val sketch = object : Sketch {
        override fun percepts() = this@Bench.percepts.toList()
        override fun act(command: String) = commands.add(command)
    }
    val field = FieldBoard(sketch, loopMs = loopMs)
    private val board = thread(name = "board") {
        try {
            field.run(line.board())
        } catch (_: PortGoneException) {
            // the bench is closed
        } catch (_: InterruptedException) {
            // the board is answering
        }
    }

    fun send(vararg messages: String) = write(messages.joinToString("") { "${Frame.of(it)}" })

    fun write(text: String) = text.toByteArray().let { computer.write(it, 0, it.size, 1000) }

    fun nextCommand(): String? = commands.poll(DEADLINE_S, TimeUnit.SECONDS)

    fun receive(count: Int): String {
        val bytes = ByteArray(count)
        var received = 0
        val deadline = System.nanoTime() + TimeUnit.SECONDS.toNanos(DEADLINE_S)
        while (received < count && System.nanoTime() < deadline) received += computer.read(bytes, received, count - received, 100)
        return String(bytes, 0, received)
    }

    override fun close() {
        line.unplug()
        board.interrupt()
        board.join(TimeUnit.SECONDS.toMillis(DEADLINE_S))
        check(!board.isAlive) { "the board still runs after its line has gone" }
    }
}

class FieldBoardSpec : FunSpec({
    test("a request is answered with the percepts, anything else is a command") {
        Bench("light(f,40)").use { bench ->
            bench.send("getPercepts")
            bench.receive(18) shouldBe "fffe0Clight(f,40);"
            bench.send("speed(120)")
            bench.nextCommand() shouldBe "speed(120)"
        }
    }

    test("commands that arrive while it reads are done one after the other") {
        Bench().use { bench ->
            bench.send("one", "two", "three")
            List(3) { bench.nextCommand() } shouldBe listOf("one", "two", "three")
        }
    }

    test("of the commands that arrive while it answers it does the last one only") {
        val percepts = "x".repeat(200)
        Bench(percepts).use { bench ->
            bench.send("getPercepts", "one", "two") // the answer takes 215 ms, and the two commands take 19 ms
            bench.receive(207) shouldBe "fffeC9$percepts;"
            bench.nextCommand() shouldBe "two"
            bench.send("three")
            bench.nextCommand() shouldBe "three"
        }
    }

    test("a board that finds the beginning of a frame behind a message restarts, and loses both") {
        Bench("x".repeat(200)).use { bench ->
            bench.send("getPercepts", "one")
            bench.write("fff") // arrives while the board answers
            bench.receive(207)
            eventually(60.seconds) { bench.field.restarts shouldBe 1 }
            eventually(60.seconds) {
                bench.send("two")
                bench.commands.poll(200, TimeUnit.MILLISECONDS) shouldBe "two"
            }
        }
    }

    test("a board that looks seldom forgets a message that a whole one follows") {
        Bench(loopMs = 200).use { bench ->
            bench.send("one", "two", "three")
            bench.nextCommand() shouldBe "three"
        }
    }

    test("noise before a message does not cost the message") {
        Bench().use { bench ->
            bench.write("xfff")
            bench.send("one")
            bench.nextCommand() shouldBe "one"
        }
    }
})
