package javino.link

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.longs.shouldBeGreaterThanOrEqual
import io.kotest.matchers.nulls.shouldBeNull
import io.kotest.matchers.shouldBe
import javino.JumpingClock
import javino.LineClock
import javino.LineSettings
import javino.PortGoneException
import javino.Protocol
import javino.Transport
import javino.async
import javino.sim.MemoryLine
import java.util.concurrent.CountDownLatch
import java.util.concurrent.TimeUnit

private const val PAST = Long.MIN_VALUE / 4

internal fun inboxOn(line: Transport, clock: LineClock, listener: Inbox.Listener = Inbox.Listener { _, _ -> }): Inbox {
    val monitor = Monitor(clock, line.name())
    return Inbox(monitor, line, clock, BoardStatus(monitor, clock, LinkSettings.defaults().withProtocol(Protocol.V1)), listener)
}

/** An inbox on a line in memory. The test holds the far end. */
private class InboxProbe {
    val clock = JumpingClock()
    private val line = MemoryLine.unlimited("probe", LineSettings.defaults(), clock)
    val receivedAt = mutableListOf<Long>()
    val inbox = inboxOn(line.computer(), clock) { _, now -> receivedAt.add(now) }

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

    test("a message whose reader is held up behind a look that found nothing is no broken one") {
        val clock = JumpingClock()
        val line = MemoryLine.unlimited("probe", LineSettings.defaults(), clock)
        fun arrives(bytes: String) = line.board().write(bytes.toByteArray(), 0, bytes.length, 0)
        val computer = object : Transport by line.computer() {
            override fun read(b: ByteArray, off: Int, len: Int, timeoutMillis: Int): Int {
                val count = line.computer().read(b, off, len, timeoutMillis)
                if (count == 0) clock.advance(1_000_000_000) // the computer pauses, and the rest arrives
                return count
            }
        }
        val inbox = inboxOn(computer, clock)
        arrives("fffe05he")
        inbox.look()
        inbox.look()
        arrives("llo")
        inbox.next(clock.nanos() + PAST)?.text() shouldBe "hello"
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

    test("who waits for a message is not held up by another thread that reads for long") {
        val reading = CountDownLatch(1)
        val free = CountDownLatch(1)
        val line = object : Transport by MemoryLine.unlimited("slow", LineSettings.defaults()).computer() {
            override fun read(b: ByteArray, off: Int, len: Int, timeoutMillis: Int): Int {
                reading.countDown()
                free.await() // a driver may close the port during a read
                return 0
            }
        }
        val inbox = inboxOn(line, LineClock.system())
        val clearing = async { inbox.clear() }
        reading.await()
        async { inbox.next(LineClock.system().nanos() + 1_000_000) }.get(20, TimeUnit.SECONDS).shouldBeNull()
        free.countDown()
        clearing.get(20, TimeUnit.SECONDS)
    }

    test("of messages that nobody takes the newest are kept") {
        val probe = InboxProbe()
        probe.arrives((0 until 100).joinToString("") { "fffe03%03d".format(it) })
        generateSequence { probe.next() }.toList() shouldBe (36 until 100).map { "%03d".format(it) }
    }
})
