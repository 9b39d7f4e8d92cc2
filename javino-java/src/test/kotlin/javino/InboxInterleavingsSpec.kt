package javino

import io.kotest.core.spec.style.FunSpec
import java.util.concurrent.atomic.AtomicReferenceArray

/** A line that gives one of [reads] to each read and after them lets time pass. */
private class ReadyLine(private val time: LineTime, private vararg val reads: ByteArray) : Transport {
    private var next = 0 // one thread at a time reads

    override fun name() = "ready"

    override fun line() = LineSettings(115_200)

    override fun read(b: ByteArray, off: Int, len: Int, timeoutMillis: Int): Int {
        val bytes = reads.getOrNull(next++) ?: return 0.also { time.now += timeoutMillis * 1_000_000L }
        bytes.copyInto(b, off)
        return bytes.size
    }

    override fun write(b: ByteArray, off: Int, len: Int, timeoutMillis: Int) = error("nothing is written")

    override fun close() = Unit
}

private const val LIMIT_NANOS = 100_000_000L
private const val ACTION = 3

class InboxInterleavingsSpec : FunSpec({
    val message = Frame.version2("one".toByteArray(), 0, 0).toBytes()
    val acknowledgement = Frame.version2(ByteArray(0), Frame.ACK, ACTION).toBytes()

    fun check(vararg reads: ByteArray) = inEachInterleaving {
        val time = LineTime()
        val inbox = Inbox(ReadyLine(time, *reads), time, { _, _ -> }, Protocol.V2, Frame.MAX_PAYLOAD)
        inbox.expectOutcome(ACTION)
        val found = AtomicReferenceArray<Any?>(2)
        concurrently({ found[0] = inbox.next(LIMIT_NANOS)?.text() }, { found[1] = inbox.outcome(LIMIT_NANOS) })
        check(found[0] == "one" && found[1] == Inbox.Outcome.DONE) { "found $found" }
    }

    test("whichever thread reads, each gets what it waits for") {
        check(message, acknowledgement)
        check(acknowledgement, message)
    }

    test("one read with something for both ends both waits") {
        check(message + acknowledgement)
    }
})
