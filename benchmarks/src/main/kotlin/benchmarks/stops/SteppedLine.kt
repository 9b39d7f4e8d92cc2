package benchmarks.stops

import javino.LineClock
import javino.LineSettings
import javino.PortGoneException
import javino.PortInterruptedException
import javino.PortTimeoutException
import javino.Transport
import java.util.concurrent.TimeUnit
import kotlin.concurrent.withLock

/**
 * The computer's end of the line to the board [uno], in the time of [clock]. A byte takes its real time in both directions. The board is
 * advanced to the current time at least once per byte time, and before bytes are sent to it. The board delivers a byte one byte time before
 * the byte arrives.
 */
internal class SteppedLine(
    private val name: String, private val settings: LineSettings, private val clock: LineClock, private val uno: SteppedUno,
    private val timeline: Timeline,
) : Transport {
    private class Arrival(val byte: Byte, val atNanos: Long)

    private val lock = clock.newLock(false)
    private val changed = lock.newCondition()
    private val arriving = ArrayDeque<Arrival>()
    private var freeAt = clock.nanos()
    private var isClosed = false
    private var hangs = false
    private var isArrivalNew = false // other callers also advance the board

    /** The bytes written to the line and read from it. */
    var traffic = Traffic(0, 0)
        private set

    /** Called with all bytes written to the line. */
    var tap: (ByteArray) -> Unit = {}

    init {
        uno.sent = { byte, atNanos ->
            arriving += Arrival(byte, maxOf(atNanos, clock.nanos()))
            isArrivalNew = true
            timeline.addByte("board", atNanos)
        }
        advance()
    }

    override fun name() = name

    override fun line() = settings

    private fun advance(): Unit = lock.withLock {
        if (isClosed) return@withLock
        if (!hangs) uno.runTo(clock.nanos())
        if (isArrivalNew) changed.signalAll()
        isArrivalNew = false
        clock.schedule(settings.byteNanos() * 4 / 5, ::advance) // the board may send up to 2 % faster than its nominal rate
    }

    /** The board stops and takes no more bytes. [flood] then arrives again and again, or nothing if it is null. */
    fun hang(flood: ByteArray?) = lock.withLock {
        hangs = true
        if (flood != null) repeatBytes(flood, 0)
    }

    private fun repeatBytes(bytes: ByteArray, next: Int): Unit = lock.withLock {
        if (isClosed) return@withLock
        val at = clock.nanos() + settings.byteNanos()
        arriving += Arrival(bytes[next], at)
        timeline.addByte("board", at)
        changed.signalAll()
        clock.schedule(settings.byteNanos()) { repeatBytes(bytes, (next + 1) % bytes.size) }
    }

    override fun read(b: ByteArray, off: Int, len: Int, timeoutMillis: Int): Int = lock.withLock {
        val deadline = clock.nanos() + TimeUnit.MILLISECONDS.toNanos(timeoutMillis.toLong())
        var count = take(b, off, len)
        while (count == 0 && clock.nanos() < deadline) {
            await(minOf(deadline, arriving.firstOrNull()?.atNanos ?: deadline) - clock.nanos())
            count = take(b, off, len)
        }
        count
    }

    private fun take(b: ByteArray, off: Int, len: Int): Int {
        requireOpen()
        val now = clock.nanos()
        var count = 0
        while (count < len && arriving.isNotEmpty() && arriving.first().atNanos <= now) b[off + count++] = arriving.removeFirst().byte
        traffic += Traffic(0, count)
        return count
    }

    override fun write(b: ByteArray, off: Int, len: Int, timeoutMillis: Int) = lock.withLock {
        val deadline = clock.nanos() + TimeUnit.MILLISECONDS.toNanos(timeoutMillis.toLong())
        requireOpen()
        while (freeAt - clock.nanos() + len * settings.byteNanos() > DRIVER_BYTES * settings.byteNanos()) {
            if (clock.nanos() >= deadline) throw PortTimeoutException(name, "port $name took 0 of $len bytes within $timeoutMillis ms")
            await(minOf(deadline - clock.nanos(), settings.byteNanos()))
            requireOpen()
        }
        send(b.copyOfRange(off, off + len))
    }

    private fun send(bytes: ByteArray) {
        val now = clock.nanos()
        freeAt = maxOf(freeAt, now)
        if (!hangs) {
            uno.runTo(now)
            uno.send(bytes, freeAt, settings.byteNanos())
        }
        repeat(bytes.size) {
            freeAt += settings.byteNanos()
            timeline.addByte("computer", freeAt)
        }
        traffic += Traffic(bytes.size, 0)
        tap(bytes)
        changed.signalAll()
    }

    private fun requireOpen() {
        if (isClosed) throw PortGoneException(name, "port $name is gone: it was closed")
    }

    private fun await(nanos: Long) {
        try {
            clock.await(changed, nanos)
        } catch (_: InterruptedException) {
            Thread.currentThread().interrupt()
            throw PortInterruptedException(name)
        }
    }

    override fun close() = lock.withLock {
        isClosed = true
        changed.signalAll()
    }

    private companion object {
        const val DRIVER_BYTES = 2048
    }
}

internal data class Traffic(val toBoard: Int, val toComputer: Int) {
    operator fun plus(other: Traffic) = Traffic(toBoard + other.toBoard, toComputer + other.toComputer)

    operator fun minus(other: Traffic) = Traffic(toBoard - other.toBoard, toComputer - other.toComputer)
}
