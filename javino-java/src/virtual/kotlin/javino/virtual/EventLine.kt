package javino.virtual

import javino.LineClock
import javino.LineSettings
import javino.PortGoneException
import javino.Transport
import javino.link.Link
import javino.link.LinkSettings
import java.util.concurrent.atomic.AtomicInteger
import java.util.concurrent.locks.Condition

/** Bytes that arrive together, [lateNanos] later than the line's rate requires. */
internal class Piece(val bytes: ByteArray, val lateNanos: Long = 0)

/** Faults of one direction of a line, for the bytes of one write. */
internal fun interface LineFaults {
    fun pass(bytes: ByteArray): List<Piece>
}

/** Leaves the bytes as they are. */
internal val FAULTLESS = LineFaults { listOf(Piece(it)) }

internal fun interface LineEnd {
    /** Does the work that is due at [now], in ms since the link was opened. Called repeatedly. */
    fun look(end: Transport, now: Double)
}

internal interface EventBoard : LineEnd {
    /** The next time, in ms, at which the board has work even if nothing arrives. Infinite if there is none. */
    val dueMillis: Double
}

/**
 * A paced line, a link and a board on one thread. Virtual time jumps from event to event, so a million exchanges take seconds. Written
 * bytes arrive in one piece at the time of the last byte. Faults may divide them.
 *
 * @param open creates the link
 * @param goneAfter total number of bytes after which the line is gone
 * @param startMillis time of the clock when the line is opened
 */
internal class EventLine(
    settings: LinkSettings,
    private val board: EventBoard,
    toBoard: LineFaults = FAULTLESS,
    toComputer: LineFaults = FAULTLESS,
    private val goneAfter: Long = Long.MAX_VALUE,
    startMillis: Double = 0.0,
    open: (Transport, LinkSettings, LineClock) -> Link = Link::over,
) : AutoCloseable {
    private val name = "event${lines.incrementAndGet()}"
    private val byteNanos = settings.line().byteNanos()
    private var now = (startMillis * 1e6).toLong()
    private var carried = 0L
    private var isWoken = false
    private val there = Way(toBoard)
    private val back = Way(toComputer)
    private val computer = End(back, there, settings.line()) { deadline -> step(deadline) }
    private val boardEnd = End(there, back, settings.line()) { }
    val clock = object : LineClock {
        override fun nanos(): Long = now

        override fun await(condition: Condition, nanos: Long) = step(now + nanos)
    }
    val link: Link = open(computer, settings, clock)
    val transport: Transport get() = computer
    val millis: Double get() = now / 1e6

    override fun close() = link.close()

    /** Ends the waiting read. The only thread then writes the queued commands. */
    fun wake() {
        isWoken = true
    }

    /** Advances the time to the next event, at most by [nanos]. */
    fun pass(nanos: Long) = step(now + nanos)

    /** Advances the time to the next event, at most to [deadline]. */
    private fun step(deadline: Long) {
        val due = board.dueMillis.let { if (it.isInfinite()) Long.MAX_VALUE else (it * 1e6).toLong() + 1 }
        val unread = back.nextAt <= now // bytes have arrived, and no read is waiting
        now = maxOf(now, minOf(deadline, there.nextAt, if (unread) deadline else back.nextAt, due))
        if (there.nextAt <= now || due <= now) board.look(boardEnd, millis)
    }

    private inner class Way(private val faults: LineFaults) {
        private val pieces = ArrayDeque<Pair<Long, ByteArray>>()
        private var freeAt = 0L
        val nextAt: Long get() = pieces.firstOrNull()?.first ?: Long.MAX_VALUE

        fun put(bytes: ByteArray) {
            val whole = if (carried + bytes.size > goneAfter) bytes.copyOf((goneAfter - carried).toInt()) else bytes
            carried += bytes.size
            for (piece in faults.pass(whole)) {
                freeAt = maxOf(freeAt, now) + piece.bytes.size * byteNanos + piece.lateNanos
                if (piece.bytes.isNotEmpty()) pieces += freeAt to piece.bytes
            }
        }

        fun take(b: ByteArray, off: Int): Int {
            if (nextAt > now) return 0
            val bytes = pieces.removeFirst().second
            bytes.copyInto(b, off)
            return bytes.size
        }
    }

    private inner class End(
        private val incoming: Way,
        private val outgoing: Way,
        private val settings: LineSettings,
        private val wait: (Long) -> Unit,
    ) : Transport {
        override fun name() = name

        override fun line() = settings

        override fun read(b: ByteArray, off: Int, len: Int, timeoutMillis: Int): Int {
            val deadline = now + timeoutMillis * 1_000_000L
            while (true) {
                val count = incoming.take(b, off)
                if (count > 0) return count
                if (carried > goneAfter) throw PortGoneException(name, "port $name is gone: the plug was pulled")
                if (now >= deadline || isWoken) return 0.also { isWoken = false }
                wait(deadline)
            }
        }

        override fun isWritableNow(unread: Long) = true

        override fun write(b: ByteArray, off: Int, len: Int, timeoutMillis: Int) {
            if (carried > goneAfter) throw PortGoneException(name, "port $name is gone: the plug was pulled")
            outgoing.put(b.copyOfRange(off, off + len))
        }

        override fun close() = Unit
    }

    private companion object {
        val lines = AtomicInteger()
    }
}
