package javino.tcp

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.longs.shouldBeLessThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import javino.LineSettings
import javino.NoSuchPortException
import javino.PortGoneException
import javino.PortInterruptedException
import javino.PortTimeoutException
import javino.Transports
import javino.async
import javino.readFully
import java.net.InetAddress
import java.net.UnknownHostException
import java.util.concurrent.Callable
import java.util.concurrent.CompletableFuture
import java.util.concurrent.TimeUnit
import java.util.concurrent.atomic.AtomicInteger
import kotlin.concurrent.thread
import kotlin.time.Duration.Companion.seconds

private const val LONG_MILLIS = 20_000

class TcpPortSpec : FunSpec({
    timeout = 60.seconds.inWholeMilliseconds
    blockingTest = true

    val line = LineSettings.defaults()

    fun refusal(port: String): String {
        val refusal = shouldThrow<NoSuchPortException> { Transports.open(port, line) }
        refusal.port() shouldBe port
        return refusal.message.orEmpty()
    }

    test("a host and a port number, an address in brackets, with or without the slashes") {
        TcpAddress.of("", "//robot.local:4000") shouldBe TcpAddress("robot.local", 4000)
        TcpAddress.of("", "my_robot:1") shouldBe TcpAddress("my_robot", 1)
        TcpAddress.of("", "robot:1") shouldBe TcpAddress("robot", 1)
        TcpAddress.of("", "//[fe80::1%eth0]:65535/") shouldBe TcpAddress("fe80::1%eth0", 65535)
    }

    test("a name that cannot be one is refused in words that say how it is written") {
        mapOf(
            "tcp://robot" to "port number is missing",
            "tcp://robot:" to "port number is missing",
            "tcp://[::1]" to "port number is missing",
            "tcp://:4000" to "host is missing",
            "tcp:4000" to "port number is missing",
            "tcp://robot:0" to "\"0\" is no port number",
            "tcp://robot:65536" to "\"65536\" is no port number",
            "tcp://robot:http" to "\"http\" is no port number",
            "tcp://robot:-1" to "\"-1\" is no port number",
            "tcp://robot:99999999999" to "is no port number",
            "tcp://fe80::1:4000" to "brackets",
            "tcp://me@robot:4000" to "no host's name",
            "tcp://robot/x:4000" to "no host's name",
        ).forEach { (port, words) ->
            refusal(port) shouldContain words
            refusal(port) shouldContain "tcp://HOST:PORT"
        }
    }

    test("all spellings of one place are one port") {
        for (port in listOf("tcp://Robot:4000", "tcp:robot:4000", "TCP://robot:04000/")) {
            Transports.canonicalName(port) shouldBe "tcp://robot:4000"
        }
        Transports.canonicalName("tcp://[FE80::1]:1") shouldBe "tcp://[fe80::1]:1"
        Transports.canonicalName("tcp://robot") shouldBe "tcp://robot"
    }

    test("where nothing listens, the port number is asked about") {
        val closed = Loopback().apply { close() }
        refusal(closed.port) shouldContain "nothing listens at 127.0.0.1:${closed.number}"
    }

    test("a host that does not exist is named") {
        val host = "r".repeat(64) + ".invalid" // too long for a host name, so no server is asked
        refusal("tcp://$host:4000") shouldContain "no host $host"
    }

    test("looking up a host has a time limit, ends with an interrupt, and is not begun again while it is under way") {
        val asked = AtomicInteger()
        val begun = CompletableFuture<Unit>()
        val answer = CompletableFuture<Array<InetAddress>>()
        val resolver = Callable {
            asked.incrementAndGet()
            begun.complete(Unit)
            answer.get()
        }
        repeat(3) {
            shouldThrow<UnknownHostException> { HostLookup.addresses("slow", 1_000_000, resolver) }.message shouldContain "host slow"
        }
        Thread.currentThread().interrupt()
        shouldThrow<InterruptedException> { HostLookup.addresses("slow", Long.MAX_VALUE, resolver) }
        begun.get(20, TimeUnit.SECONDS)
        asked.get() shouldBe 1
        val loopback = arrayOf(InetAddress.getLoopbackAddress())
        val waiting = async { HostLookup.addresses("slow", Long.MAX_VALUE, resolver) }
        answer.complete(loopback)
        waiting.get(20, TimeUnit.SECONDS) shouldBe loopback
    }

    test("a network has no rate, so a board there is not held to 9600 baud") {
        Transports.usualLine("tcp://robot:4000").byteNanos() shouldBeLessThan 1_000
        Transports.usualLine("ttyACM0") shouldBe line
        Transports.usualLine("sim:robot") shouldBe line
        Transports.usualLine("nonsense:") shouldBe line
    }

    test("an opening whose thread is interrupted ends at once, and the thread stays interrupted") {
        val outcome = CompletableFuture<Throwable?>()
        val stillInterrupted = CompletableFuture<Boolean>()
        thread(isDaemon = true) {
            Thread.currentThread().interrupt()
            // an address reserved for documentation, at which nobody answers
            outcome.complete(runCatching { Transports.open("tcp://192.0.2.1:4000", line).close() }.exceptionOrNull())
            stillInterrupted.complete(Thread.currentThread().isInterrupted)
        }
        val trouble = outcome.get(20, TimeUnit.SECONDS)
        // without a network the system refuses earlier
        check(trouble is PortInterruptedException || trouble is NoSuchPortException) { "$trouble" }
        stillInterrupted.get(20, TimeUnit.SECONDS) shouldBe true
    }

    test("what was written right before a connection is closed arrives, though answers to it were not read") {
        Loopback().use { server ->
            val computer = Transports.open(server.port, line)
            val board = TcpTransport(server.accept(), "the board's end", line)
            board.write(ByteArray(1000), 0, 1000, LONG_MILLIS)
            computer.readFully(1)
            computer.write("stop".toByteArray(), 0, 4, LONG_MILLIS)
            computer.close()
            board.readFully(4).decodeToString() shouldBe "stop"
            shouldThrow<PortGoneException> { board.read(ByteArray(1), 0, 1, LONG_MILLIS) }.message shouldContain "far end closed"
            board.close()
        }
    }

    test("of a far end that is silent it is said that a longer timeout may help") {
        Loopback().use { server ->
            Transports.open(server.port, line).use { it.doubt() shouldContain "needs a longer timeout" }
        }
    }

    test("closing does not wait for a far end that does not read") {
        Loopback().use { server ->
            val computer = Transports.open(server.port, line)
            server.accept().use {
                val writer =
                    thread(isDaemon = true) { runCatching { repeat(1000) { computer.write(ByteArray(4096), 0, 4096, LONG_MILLIS) } } }
                shouldThrow<PortTimeoutException> { repeat(1000) { computer.write(ByteArray(4096), 0, 4096, 50) } }
                async { computer.close() }.get(20, TimeUnit.SECONDS)
                writer.join(TimeUnit.SECONDS.toMillis(20))
                writer.isAlive shouldBe false
            }
        }
    }
})
