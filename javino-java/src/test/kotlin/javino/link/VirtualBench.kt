package javino.link

import javino.Frame
import javino.FrameDecoder
import javino.LineClock
import javino.Protocol
import javino.Transport
import javino.sim.MemoryLine
import javino.virtual.LineEnd
import java.util.concurrent.atomic.AtomicInteger
import java.util.concurrent.locks.Condition

/**
 * A link and a board on one thread, in virtual time. Whenever the link waits, time advances by a step and the board reads its end of the
 * line. Such tests take almost no time and give one result on any machine.
 *
 * @param protocol the version that the link speaks; overrides the settings
 * @param name the port's name; unique unless a test opens a port twice
 */
internal class VirtualBench(
    settings: LinkSettings = LinkSettings.defaults(),
    private val board: LineEnd,
    protocol: Protocol = Protocol.V1,
    private val name: String = "virtual${benches.incrementAndGet()}",
) : AutoCloseable {
    private val clock = Time()
    private val line: MemoryLine = MemoryLine.paced(name, settings.line(), clock)
    val link = Link(line.computer(), settings.withProtocol(protocol), PortOwners.claim(name, "the test"), clock)

    val millis: Double get() = clock.now / 1e6

    fun awayFor(millis: Int) {
        val until = clock.now + millis * 1_000_000L
        while (clock.now < until) clock.step(STEP_NANOS)
    }

    override fun close() = link.close()

    private inner class Time : LineClock {
        var now = 0L

        override fun nanos(): Long = now

        override fun await(condition: Condition, nanos: Long) = step(minOf(nanos, STEP_NANOS))

        fun step(nanos: Long) {
            now += nanos
            board.look(line.board(), millis)
        }
    }

    private companion object {
        const val STEP_NANOS = 100_000L
        val benches = AtomicInteger()
    }
}

/**
 * A board that answers the n-th request with `n;`.
 *
 * @param startsAt the time in ms until which arriving bytes are lost
 * @param answersAfter ms between the last byte of a request and the first byte of its answer
 */
internal class VirtualBoard(private val startsAt: Double = 0.0, var answersAfter: Double = 0.0, private val padding: Int = 0) : LineEnd {
    val received = mutableListOf<Pair<String, Double>>()
    var stopped = false
    var silent = false
    private var count = 0
    private val outgoing = ArrayDeque<Pair<Double, String>>()
    private val decoder = FrameDecoder(Long.MAX_VALUE) { pending += it.text() }
    private val pending = mutableListOf<String>()

    val texts get() = received.map { it.first }

    fun say(atMillis: Double, message: String) {
        outgoing += atMillis to message
    }

    override fun look(end: Transport, now: Double) {
        if (stopped) return
        val bytes = ByteArray(1024)
        val length = end.read(bytes, 0, bytes.size, 0)
        if (now < startsAt) return
        decoder.accept(bytes, 0, length, 0)
        pending.forEach { handle(it, now) }
        pending.clear()
        while (outgoing.isNotEmpty() && outgoing.first().first <= now) {
            val frame = Frame.of(outgoing.removeFirst().second).toBytes()
            end.write(frame, 0, frame.size, 0)
        }
    }

    private fun handle(message: String, now: Double) {
        received += message to now
        if (message == "getPercepts" && !silent) {
            val begins = maxOf(now, outgoing.lastOrNull()?.first ?: 0.0) + answersAfter
            outgoing += begins to "${++count};".padEnd(padding, ' ')
        }
    }
}
