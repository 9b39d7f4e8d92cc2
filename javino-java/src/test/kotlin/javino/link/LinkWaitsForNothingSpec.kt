package javino.link

import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.longs.shouldBeLessThanOrEqual
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import javino.ActionUnconfirmedException
import javino.CommandWithdrawnException
import javino.Frame
import javino.Line
import javino.LineClock
import javino.LineSettings
import javino.PortTimeoutException
import javino.Protocol
import javino.Transport
import javino.Transports
import javino.async
import javino.logged
import javino.serial.Terminals
import javino.sim.BoardProgram
import javino.sim.BoardSession
import javino.sim.MemoryLine
import javino.tcp.Loopback
import javino.wire.WireDecoder
import java.lang.management.ManagementFactory
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.ExecutionException
import java.util.concurrent.TimeUnit
import kotlin.concurrent.thread
import kotlin.time.Duration.Companion.seconds

private const val COMMANDS = 10_000
private const val LIMIT_MS = 100
private const val LIMIT_S = 40L
private fun unpaced(protocol: Protocol) =
    LinkSettings.defaults().withBootMillis(0).withSpacingMillis(0).withProtocol(protocol).withPaced(false)

private val COMMAND = "say(" + "x".repeat(200) + ")"

/** The computer's end of a line. Records the bytes and time limits of each thread's writes. */
private class NotedWrites(private val line: Transport) : Transport by line {
    val bytes = ConcurrentHashMap<Thread, Long>()
    val limits = ConcurrentHashMap<Thread, Set<Int>>()

    override fun isWritableNow(unread: Long) = line.isWritableNow(unread)

    override fun write(b: ByteArray, off: Int, len: Int, timeoutMillis: Int) {
        bytes.merge(Thread.currentThread(), len.toLong(), Long::plus)
        limits.merge(Thread.currentThread(), setOf(timeoutMillis), Set<Int>::plus)
        line.write(b, off, len, timeoutMillis)
    }
}

/** A far end that answers as a board until it is [deaf]. A deaf board reads nothing and constantly sends unasked messages. */
private class DeafBoard(private val end: Transport, protocol: Protocol) : AutoCloseable {
    private val session = BoardSession(program, BoardSession.Capacity.FULL) { frame, nonce -> say(frame.toBytes(nonce)) }
    private val decoder = WireDecoder(false, Long.MAX_VALUE / 2, session::nonce, session::receive)
    private val percepts = Frame.of("dist(front,1);").toBytes()

    @Volatile
    var isDeaf = protocol == Protocol.V1

    @Volatile
    private var isOver = false
    private val thread = thread(isDaemon = true) { runCatching { while (!isOver) if (isDeaf) talk() else answer() } }

    private fun answer() {
        val buffer = ByteArray(1024)
        decoder.accept(buffer, 0, end.read(buffer, 0, buffer.size, 1), System.nanoTime())
    }

    private fun talk() {
        if (session.isOpen) session.sendPercepts("dist(front,1);") else say(percepts)
        TimeUnit.MILLISECONDS.sleep(1) // a thousand messages a second
    }

    private fun say(bytes: ByteArray) = end.write(bytes, 0, bytes.size, 60_000)

    override fun close() {
        isOver = true
        thread.interrupt()
    }

    private companion object {
        val program = object : BoardProgram {
            override fun carryOut(command: String) = BoardProgram.Outcome.DONE

            override fun percepts(request: String) = "dist(front,1);"
        }
    }
}

/** A thread that sends a command never waits for the line. */
class LinkWaitsForNothingSpec : FunSpec({
    fun deaf(name: String, mostAtOnce: Long, available: Enabled = Enabled.enabled, open: () -> Line) {
        for (protocol in listOf(Protocol.V1, Protocol.V2)) {
            test("$name that talks and does not read takes no time of who sends: $protocol")
                .config(enabledOrReasonIf = { available }, timeout = 120.seconds, blockingTest = true) {
                    open().use { line ->
                        val computer = NotedWrites(line.computer)
                        val settings = unpaced(protocol)
                        val board = DeafBoard(line.board, protocol)
                        Link.over(computer, settings, LineClock.system()).use { link ->
                            link.request("getPercepts", 20_000)
                            board.isDeaf = true
                            thread(isDaemon = true) { runCatching { link.writeCommandsUntilClosed() } }
                            thread(isDaemon = true) { while (link.isOpen) runCatching { link.request("getPercepts", 50) } }
                            var longest = 0L
                            var longestAtWork = 0L
                            val cpu = ManagementFactory.getThreadMXBean()
                            val sender = async {
                                val sent = List(COMMANDS) {
                                    val start = System.nanoTime()
                                    val workedBefore = cpu.currentThreadCpuTime
                                    val outcome = link.send(COMMAND, SendOptions(false, LIMIT_MS))
                                    longest = maxOf(longest, System.nanoTime() - start)
                                    longestAtWork = maxOf(longestAtWork, cpu.currentThreadCpuTime - workedBefore)
                                    outcome
                                }
                                Thread.currentThread() to sent
                            }
                            val (thread, sent) = sender.get(LIMIT_S, TimeUnit.SECONDS)
                            (computer.bytes[thread] ?: 0) shouldBeLessThanOrEqual mostAtOnce
                            (computer.limits[thread].orEmpty() - 0).shouldBeEmpty()
                            val trouble = sent.mapNotNull { runCatching { it.get(LIMIT_S, TimeUnit.SECONDS) }.exceptionOrNull() }
                            trouble.size shouldBeGreaterThan COMMANDS / 2 // the others were carried out, or the driver had them
                            trouble.map { (it as ExecutionException).cause }
                                .filterNot { it is CommandWithdrawnException || it is ActionUnconfirmedException }.shouldBeEmpty()
                            println("measured: $name, $protocol: ${computer.bytes[thread] ?: 0} bytes written by who sends, " +
                                "longest of $COMMANDS calls ${longest / 1000} µs, of processor time ${longestAtWork / 1000} µs")
                        }
                        board.close()
                    }
                }
        }
    }

    deaf("a line in memory", MemoryLine.CAPACITY.toLong()) {
        val line = MemoryLine.unlimited("deaf", LineSettings(1_000_000))
        Line(line.computer(), line.board(), line::unplug) { }
    }

    deaf("a pseudo-terminal", 1024, Terminals.available) {
        val terminals = Terminals.open()
        val line = LineSettings(1_000_000)
        Line(Transports.open(terminals.computer, line), Transports.open(terminals.board, line), terminals::unplug, terminals::close)
    }

    deaf("a network connection", 0) {
        val server = Loopback()
        val computer = Transports.open(server.port, LineSettings(1_000_000))
        val board = server.accepted()
        Line(computer, board, board::close, server::close)
    }

    test("what the driver does not take is reported once, until it takes something again") {
        var isDeaf = true
        val memory = MemoryLine.unlimited("deaf", LineSettings(1_000_000))
        val line = object : Transport by memory.computer() {
            override fun isWritableNow(unread: Long) = false

            override fun write(b: ByteArray, off: Int, len: Int, timeoutMillis: Int) {
                if (isDeaf) throw PortTimeoutException(name(), "port ${name()} did not take $len bytes; the far end does not read")
            }
        }
        val settings = unpaced(Protocol.V1)
        fun Link.tries() = runCatching { sendAndAwait("on", 20_000) }.exceptionOrNull()?.message.orEmpty()
        Link.over(line, settings, LineClock.system()).use { link ->
            val first = logged { repeat(3) { link.tries() shouldContain "the far end does not read" } }
            first.size shouldBe 1
            first.single() shouldContain "port deaf did not take"
            isDeaf = false
            logged { link.tries() shouldBe "" }.shouldBeEmpty()
            isDeaf = true
            logged { repeat(3) { link.tries() } }.size shouldBe 1
        }
    }
})
