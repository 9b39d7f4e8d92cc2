package javino.link

import javino.Frame
import javino.FrameDecoder

/**
 * A model of a board with the original library of version 1, with a clock of its own. The board has a receive buffer of 63 bytes. The
 * board's `loop()` handles a message, waits while an answer goes out, and then does other work. Between two loops it reads all bytes that
 * have arrived, with room for one message. The first byte of the next frame empties the message. The sketch then finds no handler and
 * calls a null pointer. From the fifth byte on the message is forgotten.
 *
 * @param buildNanos time to build an answer, between the read that finds the request and the first byte
 * @param startNanos time of a restart
 */
internal class FieldBoardModel(
    private val byteNanos: Long,
    private val loopNanos: Long,
    private val answer: Frame,
    private val buildNanos: Long = 0,
    private val startNanos: Long = 100_000_000L,
) {
    val handled = mutableListOf<String>()
    val lost = mutableListOf<String>()
    var restarts = 0
        private set
    var overflowed = 0
        private set

    private val buffer = ArrayDeque<Byte>()
    private var message: String? = null
    private var bytesBehind = 0 // bytes read after the message
    private var decoder = newDecoder()
    private val outgoing = ArrayDeque<Long>() // times at which the answer's bytes have left
    private var busyUntil = 0L
    private var startsUntil = 0L

    private fun newDecoder() = FrameDecoder(Long.MAX_VALUE) {
        message?.let(lost::add)
        message = it.text()
        bytesBehind = 0
    }

    fun receive(byte: Byte, now: Long) {
        if (now < startsUntil) return
        if (buffer.size == RECEIVE_BUFFER) overflowed++ else buffer.addLast(byte)
    }

    /** Advances the clock to [now]. Returns the number of answer bytes that have left by then. */
    fun advance(now: Long): Int {
        if (now >= busyUntil) loop(now)
        var gone = 0
        while (outgoing.isNotEmpty() && outgoing.first() <= now) {
            outgoing.removeFirst()
            gone++
        }
        return gone
    }

    private fun loop(now: Long) {
        while (buffer.isNotEmpty()) {
            bytesBehind++
            decoder.accept(buffer.removeFirst(), now)
        }
        busyUntil = now + loopNanos
        val complete = message ?: return
        message = null
        when (bytesBehind) {
            0 -> handle(complete, now)
            in 1..CLEARING -> restart(complete, now)
            else -> lost += complete
        }
    }

    private fun handle(text: String, now: Long) {
        handled += text
        if (text != REQUEST) return
        for (i in 1..answer.length()) outgoing += now + buildNanos + i * byteNanos
        busyUntil += buildNanos + maxOf(0, answer.length() - TRANSMIT_BUFFER) * byteNanos // print() waits for room
    }

    private fun restart(text: String, now: Long) {
        restarts++
        lost += text
        outgoing.clear()
        decoder = newDecoder()
        startsUntil = now + startNanos
        busyUntil = startsUntil
    }

    companion object {
        const val REQUEST = "getPercepts"

        /** Number of bytes of the next frame after which the emptied message is forgotten. */
        private const val CLEARING = 4
        private const val RECEIVE_BUFFER = 63
        private const val TRANSMIT_BUFFER = 64
    }
}
