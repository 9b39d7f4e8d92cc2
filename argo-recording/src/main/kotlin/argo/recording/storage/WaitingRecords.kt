package argo.recording.storage

import java.util.concurrent.CountDownLatch
import java.util.concurrent.TimeUnit
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/** A record that waits for the writing thread, or a flush that waits for the records before it. */
internal sealed interface Waiting {
    /** A message. [encode] makes its JSON, which takes about [bytes] bytes; [beside] makes the messages that follow it. */
    class Message(
        val channel: RecordChannel,
        val timeNs: Long,
        val bytes: Int,
        private val beside: () -> List<Encoded> = ::emptyList,
        private val encode: () -> ByteArray,
    ) : Waiting {
        constructor(gap: Gap) : this(Gap.CHANNEL, gap.untilNs, 0, encode = gap::json)

        /** Returns the message with its JSON, or a gap if [encode] fails, followed by the messages of [beside]. */
        fun encoded(): List<Encoded> = try {
            listOf(Encoded(channel, timeNs, encode())) + beside()
        } catch (_: Throwable) { // even a stack overflow by a deep term, since the writing thread must go on
            listOf(Gap.of(timeNs).encoded())
        }
    }

    class Attachment(val name: String, val mediaType: String, val data: ByteArray) : Waiting

    class Metadata(val name: String, val values: Map<String, String>) : Waiting

    class Flush(val done: CountDownLatch) : Waiting
}

/**
 * The queue of records for the writing thread, with at most [maxBytes] bytes of messages that wait or are being handled. Messages for which
 * there is no room are left out. A [Gap] takes their place in the order of the records. Any thread may call. No thread holds the lock while
 * a record is written.
 *
 * A hundred threads that compute without pause leave the writing thread hardly any processor time. So the threads that offer messages then
 * rest, each [restNs] at most, until the writing thread has handled the records that it has taken.
 *
 * @param nanos returns the time in ns
 */
internal class WaitingRecords(
    private val maxBytes: Long,
    private val restNs: Long = REST_NS,
    private val nanos: () -> Long = System::nanoTime,
) {
    private val lock = ReentrantLock()
    private val changed = lock.newCondition()
    private val handled = lock.newCondition()
    private var waiting = ArrayList<Waiting>()
    private var bytes = 0L
    private var takenNs: Long? = null // the time of the records that are being handled; null: there are none
    private var gap: Gap? = null
    private var isUrgent = false
    private var isClosed = false

    @Volatile
    private var isAtDisk = false

    /** Adds [message]; returns false if there is no room, or this queue is closed. The thread may [rest] first. */
    fun offer(message: Waiting.Message): Boolean = lock.withLock {
        if (isLate()) rest()
        if (isClosed) return false
        if (bytes + message.bytes > maxBytes) {
            gap = gap?.and(message.timeNs) ?: Gap.of(message.timeNs)
            return false
        }
        endGap()
        bytes += message.bytes
        waiting += message
        if (isMuch()) hurry()
        return true
    }

    private fun isMuch() = bytes > maxBytes / MUCH_PART

    private fun isLate() = isMuch() && !isAtDisk && takenNs?.let { nanos() - it > LATE_NS } == true

    /** Waits at most [restNs] until the taken records have been handled. An interrupted thread does not wait. */
    private fun rest() {
        try {
            handled.awaitNanos(restNs)
        } catch (_: InterruptedException) {
            Thread.currentThread().interrupt()
        }
    }

    /** Does [work] of the writing thread, which waits for a disk. Meanwhile no thread rests. */
    fun <T> atDisk(work: () -> T): T {
        isAtDisk = true
        try {
            return work()
        } finally {
            isAtDisk = false
        }
    }

    /** Adds [other], however full the queue is; returns false if this queue is closed. */
    fun add(other: Waiting): Boolean = lock.withLock {
        if (isClosed) return false
        endGap()
        waiting += other
        if (other is Waiting.Flush) hurry()
        return true
    }

    /** Waits until all records added before have been taken and handled; returns at once if this queue is closed. */
    fun flush() {
        val done = CountDownLatch(1)
        if (add(Waiting.Flush(done))) done.await()
    }

    /**
     * Calls [work] with the waiting records after [patienceNs] ns. Calls [work] earlier if many records wait, if a caller waits in [flush],
     * or if this queue is closed. Callers of [flush] then go on, even if [work] throws. Returns false if the queue is closed and empty.
     */
    fun take(patienceNs: Long, work: (List<Waiting>) -> Unit): Boolean {
        val batch = next(patienceNs) ?: return false
        try {
            work(batch)
        } finally {
            release(batch)
        }
        return true
    }

    private fun release(batch: List<Waiting>) = lock.withLock {
        bytes -= batch.sumOf { (it as? Waiting.Message)?.bytes ?: 0 }
        takenNs = null
        handled.signalAll()
        batch.forEach { if (it is Waiting.Flush) it.done.countDown() }
    }

    private fun next(patienceNs: Long): List<Waiting>? = lock.withLock {
        var rest = patienceNs
        while (!isUrgent && !isClosed && rest > 0) rest = changed.awaitNanos(rest)
        isUrgent = false
        endGap()
        if (waiting.isEmpty()) return if (isClosed) null else emptyList()
        takenNs = nanos()
        return waiting.also { waiting = ArrayList() }
    }

    /** Refuses later records. Records that wait can still be taken. */
    fun close() = lock.withLock {
        isClosed = true
        changed.signalAll()
    }

    /** Refuses later records and drops those that wait, since nothing can be written any more. */
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

    private companion object {
        /** The room is divided by this number. If more than the result is taken, the writing thread begins early, and threads may rest. */
        const val MUCH_PART = 64

        /** Records that the writing thread has had for this long are late. */
        val LATE_NS = TimeUnit.MILLISECONDS.toNanos(50)

        val REST_NS = TimeUnit.MILLISECONDS.toNanos(100)
    }
}
