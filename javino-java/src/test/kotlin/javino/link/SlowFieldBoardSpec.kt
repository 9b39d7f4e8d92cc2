package javino.link

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.ints.shouldBeLessThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import javino.Frame
import javino.FrameDecoder
import javino.PortTimeoutException
import javino.Transport
import javino.logged
import javino.virtual.LineEnd

private const val COMMANDS = 100

/** A board that reads and acts once in [loopMillis]. The board answers while [answers] returns true. */
private class SlowBoard(private val loopMillis: Double, private val answers: (Double) -> Boolean) : LineEnd {
    val commands = mutableListOf<String>()
    private val buffer = ArrayDeque<Byte>()
    val unread get() = buffer.toByteArray().decodeToString()
    private val decoder = FrameDecoder(Long.MAX_VALUE) { pending += it.text() }
    private val pending = mutableListOf<String>()
    private var nextLoop = 0.0

    override fun look(end: Transport, now: Double) {
        val bytes = ByteArray(256)
        for (i in 0 until end.read(bytes, 0, bytes.size, 0)) buffer += bytes[i]
        if (now < nextLoop || !answers(now)) return
        nextLoop = now + loopMillis
        decoder.accept(buffer.toByteArray(), 0, buffer.size, 0)
        buffer.clear()
        for (message in pending) {
            if (message == "getPercepts") Frame.of("n;").toBytes().let { end.write(it, 0, it.size, 0) } else commands += message
        }
        pending.clear()
    }
}

/** Tests a board of version 1 that does not answer in time. */
class SlowFieldBoardSpec : FunSpec({
    val settings = LinkSettings.defaults().withBootMillis(0).withBaud(115_200)

    fun Link.asks() = runCatching { request({ "getPercepts" }, 500, 50) }

    test("a board that stops reading gets requests and no commands until it answers, and then all of them") {
        val board = SlowBoard(1.0) { it < 100 || it > 3_000 }
        VirtualBench(settings, board).use { bench ->
            bench.link.asks().isSuccess shouldBe true
            bench.awayFor(100)
            bench.link.asks().isSuccess shouldBe false
            val sent = List(COMMANDS) { bench.link.send("c$it", SendOptions.defaults()) }
            repeat(5) { bench.link.asks() }
            sent.count { it.isDone } shouldBe 0
            board.unread.windowed(2).none { it == "c1" } shouldBe true
            while (bench.millis < 3_000) bench.link.asks()
            bench.link.asks().isSuccess shouldBe true
            bench.link.sendAndAwait("last", 20_000)
            bench.awayFor(100)
            board.commands shouldContainExactly List(COMMANDS) { "c$it" } + "last"
        }
    }

    test("a board that has never answered a request gets its commands all the same") {
        val board = object : LineEnd {
            val commands = mutableListOf<String>()
            private val decoder = FrameDecoder(Long.MAX_VALUE) { if (it.text() != "getPercepts") commands += it.text() }

            override fun look(end: Transport, now: Double) {
                val bytes = ByteArray(256)
                decoder.accept(bytes, 0, end.read(bytes, 0, bytes.size, 0), 0)
            }
        }
        VirtualBench(settings, board).use { bench ->
            repeat(3) { bench.link.asks().isSuccess shouldBe false }
            repeat(COMMANDS) { bench.link.sendAndAwait("c$it", 2_000) }
            board.commands.size shouldBe COMMANDS
        }
    }

    test("a command that is held back fails when its time is over, and says that the board does not answer") {
        VirtualBench(settings, SlowBoard(1.0) { it < 100 }).use { bench ->
            bench.link.asks()
            bench.awayFor(100)
            bench.link.asks()
            val trouble = shouldThrow<PortTimeoutException> { bench.link.sendAndAwait("on", 300) }
            trouble.message shouldContain "the board does not answer"
        }
    }

    test("an urgent command is not held back: a stop that may be lost is better than none") {
        val board = SlowBoard(1.0) { it < 100 || it > 650 }
        VirtualBench(settings, board).use { bench ->
            bench.link.asks()
            bench.awayFor(100)
            bench.link.asks()
            val before = bench.millis
            bench.link.sendAndAwait("stop", SendOptions(true, 0))
            (bench.millis - before).toInt() shouldBeLessThan 100
            bench.awayFor(200)
            board.commands shouldContainExactly listOf("stop")
        }
    }

    test("who does not ask again is told nothing, so commands go out after two seconds") {
        val board = SlowBoard(1.0) { it < 100 || it > 650 }
        VirtualBench(settings, board).use { bench ->
            bench.link.asks()
            bench.awayFor(100)
            bench.link.asks()
            val before = bench.millis
            bench.link.sendAndAwait("on", 5_000)
            (bench.millis - before).toInt() / 1_000 shouldBe 2
            bench.awayFor(100)
            board.commands shouldContainExactly listOf("on")
        }
    }

    test("commands to a board whose answers begin late are warned of once, and the option is named") {
        fun warnings(spacing: Int) = logged {
            VirtualBench(settings.withSpacingMillis(spacing), SlowBoard(300.0) { true }).use { bench ->
                repeat(8) {
                    bench.awayFor(50)
                    bench.link.asks()
                    bench.link.sendAndAwait("on", 2_000)
                }
            }
        }
        warnings(2).single() shouldContain "spacing(Ms)"
        warnings(400).size shouldBe 0
        logged {
            VirtualBench(settings, SlowBoard(20.0) { true }).use { bench ->
                repeat(8) {
                    bench.awayFor(50)
                    bench.link.asks()
                    bench.link.sendAndAwait("on", 2_000)
                }
            }
        }.size shouldBeLessThan 1
    }
})
