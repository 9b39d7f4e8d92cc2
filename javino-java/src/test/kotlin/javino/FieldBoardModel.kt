package javino

/**
 * A board as they are in the field, in a time of its own: a receive buffer of 63 bytes, one received message that a second one overwrites,
 * and a `loop()` that handles a message, waits while an answer goes out, and then does something else.
 */
internal class FieldBoardModel(private val byteNanos: Long, private val loopNanos: Long, private val answer: Frame) {
    val handled = mutableListOf<String>()
    val lost = mutableListOf<String>()
    var overflowed = 0
        private set

    private val buffer = ArrayDeque<Byte>()
    private val messages = mutableListOf<String>()
    private val decoder = FrameDecoder(Long.MAX_VALUE) { messages += it.text() }
    private val outgoing = ArrayDeque<Long>() // when the bytes of the answer have left
    private var busyUntil = 0L

    fun receive(byte: Byte) {
        if (buffer.size == RECEIVE_BUFFER) overflowed++ else buffer.addLast(byte)
    }

    /** Lets time go on to [now]; returns the number of bytes of an answer that have left by then. */
    fun advance(now: Long): Int {
        if (now >= busyUntil) loop(now)
        val gone = outgoing.count { it <= now }
        repeat(gone) { outgoing.removeFirst() }
        return gone
    }

    private fun loop(now: Long) {
        while (buffer.isNotEmpty()) decoder.accept(buffer.removeFirst(), now)
        lost += messages.dropLast(1)
        val message = messages.lastOrNull()
        messages.clear()
        busyUntil = now + loopNanos
        if (message == null) return
        handled += message
        if (message == REQUEST) {
            for (i in 1..answer.length()) outgoing += now + i * byteNanos
            busyUntil += maxOf(0, answer.length() - TRANSMIT_BUFFER) * byteNanos // print() waits for room
        }
    }

    companion object {
        const val REQUEST = "getPercepts"
        private const val RECEIVE_BUFFER = 63
        private const val TRANSMIT_BUFFER = 64
    }
}
