package javino.link

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import javino.LineClock
import javino.Protocol
import javino.Transport
import javino.async
import javino.sim.FakeBoard
import javino.sim.MemoryLine
import java.util.concurrent.CopyOnWriteArrayList
import java.util.concurrent.TimeUnit
import java.util.concurrent.atomic.AtomicInteger
import kotlin.time.Duration.Companion.seconds

private val boards = AtomicInteger()

/** A line that records each write's thread and length. Calls [duringWrite] during each write. */
private class WatchedLine(private val line: Transport) : Transport by line {
    val writers = CopyOnWriteArrayList<Pair<Thread, Int>>()

    @Volatile
    var isWritable = true

    @Volatile
    var duringWrite: () -> Unit = { }

    override fun isWritableNow(unread: Long) = isWritable && line.isWritableNow(unread)

    override fun write(b: ByteArray, off: Int, len: Int, timeoutMillis: Int) {
        writers += Thread.currentThread() to len
        duringWrite()
        line.write(b, off, len, timeoutMillis)
    }
}

/** Tests which thread hands a command to the driver. */
class LinkAtOnceSpec : FunSpec({
    val here = Thread::currentThread

    for (protocol in listOf(Protocol.V1, Protocol.V2)) {
        fun link(name: String, baud: Int = 9600, work: (WatchedLine, Link, FakeBoard) -> Unit) =
            test("$protocol: $name").config(timeout = 60.seconds, blockingTest = true) {
                val board = FakeBoard.unplugged("atOnce${boards.incrementAndGet()}", LineClock.system()).version2().lenient()
                val settings = LinkSettings.defaults().withBaud(baud).withBootMillis(0).withSpacingMillis(0).withProtocol(protocol)
                val memory = MemoryLine.unlimited(board.port(), settings.line())
                val running = async { board.program().run(memory.board()) }
                val line = WatchedLine(memory.computer())
                Link.over(line, settings, LineClock.system()).use { link ->
                    link.request("getPercepts", 20_000)
                    while (protocol == Protocol.V2 && link.vocabulary().isEmpty) link.watch(10)
                    line.writers.clear()
                    work(line, link, board)
                }
                memory.unplug()
                running.handle { _, _ -> }.join()
            }

        link("a command on an idle line is written by the thread that sends it") { line, link, _ ->
            val sent = link.send("on", SendOptions.defaults())
            line.writers.map { it.first } shouldContainExactly listOf(here())
            sent.isDone shouldBe false
            async { link.writeCommandsUntilClosed() }
            sent.get(20, TimeUnit.SECONDS)
        }

        link("a command behind another that is leaving is written by the writing thread, in its turn", baud = 300) { line, link, board ->
            async { link.writeCommandsUntilClosed() }
            val sent = listOf("a", "b").map { link.send(it, SendOptions.defaults()) }
            line.writers.map { it.first } shouldContainExactly listOf(here())
            sent.forEach { it.get(20, TimeUnit.SECONDS) }
            line.writers.drop(1).none { it.first == here() } shouldBe true
            board.awaitMessage("a", 20_000)
            board.awaitMessage("b", 20_000)
        }

        link("a command on a line that would wait is left to the writing thread") { line, link, _ ->
            line.isWritable = false
            val sent = link.send("on", SendOptions.defaults())
            line.writers.size shouldBe 0
            async { link.writeCommandsUntilClosed() }
            sent.get(20, TimeUnit.SECONDS)
        }

        link("no lock is held while a command is written") { line, link, board ->
            line.duringWrite = { async { link.vocabulary().also { link.send("b", SendOptions.defaults()) } }.get(20, TimeUnit.SECONDS) }
            val sent = link.send("a", SendOptions.defaults())
            line.duringWrite = { }
            async { link.writeCommandsUntilClosed() }
            sent.get(20, TimeUnit.SECONDS)
            board.awaitMessage("a", 20_000)
            board.awaitMessage("b", 20_000)
        }

        link("the time from the call to the driver is measured", baud = 1_000_000) { line, link, _ ->
            async { link.writeCommandsUntilClosed() }
            val nanos = LongArray(CALLS)
            for (i in nanos.indices) {
                var written = 0L
                line.duringWrite = { if (Thread.currentThread() == here()) written = System.nanoTime() }
                val start = System.nanoTime()
                val sent = link.send("on", SendOptions.defaults())
                nanos[i] = if (written == 0L) Long.MAX_VALUE else written - start
                sent.get(20, TimeUnit.SECONDS)
            }
            val here = nanos.filter { it != Long.MAX_VALUE }.drop(CALLS / 4).sorted()
            val (median, most) = listOf(50, 99).map { here.getOrNull(here.size * it / 100) } // may be null on a busy machine
            println("measured: $protocol, ${here.size} of ${CALLS * 3 / 4} commands written by who sends them, " +
                "$median ns from the call to the driver, 99th percentile $most ns")
        }
    }
})

private const val CALLS = 4_000
