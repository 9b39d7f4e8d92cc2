package argo.recording.storage

import java.util.concurrent.CountDownLatch
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/** A record that waits for the writing thread, or a flush that waits for the records before it. */
internal sealed interface Waiting {
    /** A message. [encode] makes its JSON, which takes about [bytes] bytes. [beside] makes the messages that follow it. */
    class Message(
        val channel: RecordChannel,
        val timeNs: Long,
        val bytes: Int,
        private val beside: () -> List<Encoded> = ::emptyList,
        private val encode: () -> ByteArray,
    ) : Waiting {
        constructor(gap: Gap) : this(Gap.CHANNEL, gap.untilNs, 0, encode = gap::json)

        /** Returns the message with its JSON, or a gap if [encode] fails. The messages of [beside] follow. */
        fun encoded(): List<Encoded> = try {
            listOf(Encoded(channel, timeNs, encode())) + beside()
        } catch (_: Throwable) { // even for a stack overflow by a deep term, since the writing thread must continue
            listOf(Gap.of(timeNs).encoded())
        }
    }

    class Attachment(val name: String, val mediaType: String, val data: ByteArray) : Waiting

    class Metadata(val name: String, val values: Map<String, String>) : Waiting

    class Flush(val done: CountDownLatch) : Waiting
}

/**
 * The queue of records for the writing thread, with at most [maxBytes] bytes of messages. If there is no room for a message, a [Gap] takes
 * its place in the order of the records. Any thread may call the functions. No thread holds the lock while a record is written.
 */
internal class WaitingRecords(private val maxBytes: Long) {
    private val lock = ReentrantLock()
    private val changed = lock.newCondition()
    private var waiting = ArrayList<Waiting>()
    private var bytes = 0L
    private var gap: Gap? = null
    private var isUrgent = false
    private var isClosed = false

    /** Adds [message]. Returns false if there is no room, or if this queue is closed. */
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

    /** Adds [other] even if the queue is full. Returns false if this queue is closed. */
    fun add(other: Waiting): Boolean = lock.withLock {
        if (isClosed) return false
        endGap()
        waiting += other
        if (other is Waiting.Flush) hurry()
        return true
    }

    /** Waits until all records added before have been taken and handled. Returns at once if this queue is closed. */
    fun flush() {
        val done = CountDownLatch(1)
        if (add(Waiting.Flush(done))) done.await()
    }

    /**
     * Calls [work] with the waiting records after [patienceNs] ns. Calls [work] earlier if half of the room is taken, [flush] is called, or
     * this queue is closed. Callers of [flush] then continue, even if [work] throws. Returns false if the queue is closed and empty.
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

    /** Refuses later records. Waiting records can still be taken. */
    fun close() = lock.withLock {
        isClosed = true
        changed.signalAll()
    }

    /** Refuses later records and drops waiting ones. Called when nothing more can be written. */
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
