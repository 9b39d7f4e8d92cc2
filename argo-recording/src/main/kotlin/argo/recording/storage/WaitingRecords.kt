package argo.recording.storage

import java.util.concurrent.CountDownLatch
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/** What waits to be written. */
internal sealed interface Waiting {
    /** Its JSON is made by [encode] and takes about [bytes]. */
    class Message(val channel: RecordChannel, val timeNs: Long, val bytes: Int, private val encode: () -> ByteArray) : Waiting {
        constructor(gap: Gap) : this(Gap.CHANNEL, gap.untilNs, 0, gap::json)

        /** With its JSON; a gap if that cannot be made. */
        fun encoded(): Encoded = try {
            Encoded(channel, timeNs, encode())
        } catch (_: Throwable) { // of a term nested too deeply, too: who writes must go on
            Gap.of(timeNs).encoded()
        }
    }

    class Attachment(val name: String, val mediaType: String, val data: ByteArray) : Waiting

    class Metadata(val name: String, val values: Map<String, String>) : Waiting

    class Flush(val done: CountDownLatch) : Waiting
}

/** A message as it is stored. */
internal class Encoded(val channel: RecordChannel, val timeNs: Long, val data: ByteArray)

/**
 * Records on their way to the thread that writes them, at most [maxBytes] of messages. Those that find no room become a [Gap], in their
 * place among the others. Any thread may call; the lock is never held while something is written.
 */
internal class WaitingRecords(private val maxBytes: Long) {
    private val lock = ReentrantLock()
    private val changed = lock.newCondition()
    private var waiting = ArrayList<Waiting>()
    private var bytes = 0L
    private var gap: Gap? = null
    private var isUrgent = false
    private var isClosed = false

    /** Adds [message] if there is room. */
    fun offer(message: Waiting.Message): Boolean = lock.withLock {
        if (isClosed) return false
        if (bytes + message.bytes > maxBytes) {
            gap = gap?.and(message.timeNs) ?: Gap.of(message.timeNs)
            return false
        }
        endGap()
        bytes += message.bytes
        waiting += message
        if (bytes > maxBytes / 2) hurry()
        return true
    }

    /** Adds [other] in any case. False: this is closed. */
    fun add(other: Waiting): Boolean = lock.withLock {
        if (isClosed) return false
        endGap()
        waiting += other
        if (other is Waiting.Flush) hurry()
        return true
    }

    /** Returns when all that was added before has been taken and dealt with; at once if this is closed. */
    fun flush() {
        val done = CountDownLatch(1)
        if (add(Waiting.Flush(done))) done.await()
    }

    /**
     * Calls [work] with what waits after [patienceNs], or as soon as half of the room is taken, somebody waits for a flush, or this is
     * closed. Who waits for a flush goes on afterwards, also if [work] throws. Returns false if this is closed and nothing will come.
     */
    fun take(patienceNs: Long, work: (List<Waiting>) -> Unit): Boolean {
        val batch = next(patienceNs) ?: return false
        try {
            work(batch)
        } finally {
            batch.forEach { if (it is Waiting.Flush) it.done.countDown() }
        }
        return true
    }

    private fun next(patienceNs: Long): List<Waiting>? = lock.withLock {
        var rest = patienceNs
        while (!isUrgent && !isClosed && rest > 0) rest = changed.awaitNanos(rest)
        isUrgent = false
        endGap()
        if (waiting.isEmpty()) return if (isClosed) null else emptyList()
        bytes = 0
        return waiting.also { waiting = ArrayList() }
    }

    /** Takes no more. What waits can still be taken. */
    fun close() = lock.withLock {
        isClosed = true
        changed.signalAll()
    }

    /** Takes no more, and drops what waits: nothing can be written any more. */
    fun giveUp() {
        close()
        while (take(0) {}) continue
    }

    private fun endGap() {
        gap?.let { waiting += Waiting.Message(it) }
        gap = null
    }

    private fun hurry() {
        isUrgent = true
        changed.signalAll()
    }
}
