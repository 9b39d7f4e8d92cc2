package javino

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.longs.shouldBeGreaterThanOrEqual
import io.kotest.matchers.nulls.shouldBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import javino.sim.MemoryLine
import java.util.concurrent.CountDownLatch
import java.util.concurrent.TimeUnit
import java.util.logging.Handler
import java.util.logging.LogRecord
import java.util.logging.Logger

private const val PAST = Long.MIN_VALUE / 4

/** An inbox on a line in memory, whose far end a test holds. */
private class InboxProbe(protocol: Protocol = Protocol.V1, messageLimit: Int = Frame.MAX_PAYLOAD) {
    val clock = JumpingClock()
    private val line = MemoryLine.unlimited("probe", LineSettings.defaults(), clock)
    val receivedAt = mutableListOf<Long>()
    val inbox = Inbox(line.computer(), clock, { _, now -> receivedAt.add(now) }, protocol, messageLimit)

    fun arrives(bytes: String) = line.board().write(bytes.toByteArray(Charsets.ISO_8859_1), 0, bytes.length, 0)

    fun next(): String? = inbox.next(clock.nanos() + 1_000_000_000)?.text()

    fun unplug() = line.unplug()
}

class InboxSpec : FunSpec({
    test("messages come in their order") {
        val probe = InboxProbe()
        probe.arrives("fffe03onefffe03two")
        probe.next() shouldBe "one"
        probe.next() shouldBe "two"
    }

    test("a wait ends with nothing when its time is over") {
        val probe = InboxProbe()
        val start = probe.clock.nanos()
        probe.next().shouldBeNull()
        probe.clock.nanos() - start shouldBeGreaterThanOrEqual 1_000_000_000
    }

    test("a deadline that has passed still takes what is there") {
        val probe = InboxProbe()
        probe.arrives("fffe03one")
        probe.inbox.next(probe.clock.nanos() + PAST)?.text() shouldBe "one"
        probe.inbox.next(probe.clock.nanos() + PAST).shouldBeNull()
    }

    test("the newest message is the last of all that are there") {
        val probe = InboxProbe()
        probe.inbox.newest().shouldBeNull()
        probe.arrives("fffe03onefffe03twofffe05three")
        probe.next() shouldBe "one"
        probe.inbox.newest().text() shouldBe "three"
        probe.inbox.newest().shouldBeNull()
    }

    test("clearing forgets what has come, an unfinished message too") {
        val probe = InboxProbe()
        probe.arrives("fffe03onefffe03twofffe05thr")
        probe.inbox.clear()
        probe.arrives("eefffe03new")
        probe.next() shouldBe "new"
    }

    test("a message inside a damaged one is found when the line falls silent, before the time is over") {
        val probe = InboxProbe()
        val start = probe.clock.nanos()
        probe.arrives("fffeFFfffe05hello")
        probe.inbox.next(start + 60_000_000_000)?.text() shouldBe "hello"
        probe.clock.nanos() - start shouldBe 101_000_000
    }

    test("an unfinished message is given up after a silence, not because its reader was away") {
        val probe = InboxProbe()
        probe.arrives("fffe05hel")
        probe.inbox.next(probe.clock.nanos() + 1_000_000).shouldBeNull()
        probe.clock.advance(5_000_000_000)
        probe.arrives("lo")
        probe.next() shouldBe "hello"
        probe.arrives("fffe05hel")
        probe.next().shouldBeNull()
        probe.arrives("lo")
        probe.next().shouldBeNull()
    }

    test("the time of the last byte is known, and told") {
        val probe = InboxProbe()
        probe.clock.advance(7_000_000)
        probe.arrives("x")
        probe.next()
        probe.receivedAt shouldBe listOf(probe.inbox.lastByteNanos())
    }

    test("a line that is gone is told of") {
        val probe = InboxProbe()
        probe.unplug()
        shouldThrow<PortGoneException> { probe.next() }
    }

    test("who waits for an outcome is not held up by another thread that reads for long") {
        val reading = CountDownLatch(1)
        val free = CountDownLatch(1)
        val line = object : Transport by MemoryLine.unlimited("slow", LineSettings.defaults()).computer() {
            override fun read(b: ByteArray, off: Int, len: Int, timeoutMillis: Int): Int {
                reading.countDown()
                free.await() // as while a driver closes the port
                return 0
            }
        }
        val inbox = Inbox(line, LineClock.system()) { _, _ -> }
        val clearing = async { inbox.clear() }
        reading.await()
        async { inbox.outcome(LineClock.system().nanos() + 1_000_000) }.get(20, TimeUnit.SECONDS).shouldBeNull()
        free.countDown()
        clearing.get(20, TimeUnit.SECONDS)
    }

    test("of messages that nobody takes the newest are kept") {
        val probe = InboxProbe()
        probe.arrives((0 until 100).joinToString("") { "fffe03%03d".format(it) })
        generateSequence { probe.next() }.toList() shouldBe (36 until 100).map { "%03d".format(it) }
    }

    test("messages that are too long are dropped with a warning, and with another one only after one that is not") {
        val probe = InboxProbe(Protocol.V2, 300)
        var sequence = 0
        fun says(vararg parts: String) = parts.forEachIndexed { i, part ->
            val flags = if (i < parts.lastIndex) Frame.MORE else 0
            probe.arrives(String(Frame.version2(part.toByteArray(), flags, sequence++ % 16).toBytes(), Charsets.ISO_8859_1))
        }
        val long = "x".repeat(200)
        val warnings = warningsOf(Inbox::class.java) {
            repeat(5) { says(long, long) }
            probe.next().shouldBeNull()
            says("short")
            probe.next() shouldBe "short"
            says(long, "x".repeat(100))
            probe.next() shouldBe "x".repeat(300)
            repeat(5) { says(long, long) }
            probe.next().shouldBeNull()
        }
        warnings.size shouldBe 2
        warnings.first() shouldContain "port probe sent a message of more than 300 bytes"
    }
})

/** The warnings that [type] logs during [work]. */
private fun warningsOf(type: Class<*>, work: () -> Unit): List<String> {
    val messages = ArrayList<String>()
    val handler = object : Handler() {
        override fun publish(record: LogRecord) { messages += record.message }
        override fun flush() = Unit
        override fun close() = Unit
    }
    val logger = Logger.getLogger(type.name)
    logger.addHandler(handler)
    try {
        work()
    } finally {
        logger.removeHandler(handler)
    }
    return messages
}
