package javino.sim

import javino.Frame
import javino.FrameDecoder
import javino.Transport
import javino.wire.CommandItem
import javino.wire.FrameKind
import javino.wire.PerceptDecoder
import javino.wire.WireDecoder
import javino.wire.WireFrame

/** A version 2 computer at the near end of a board's line. The test sends its frames. */
internal class ComputerEnd(private val line: Transport) {
    private val arrived = ArrayDeque<WireFrame>()
    private val decoder = WireDecoder(true, Long.MAX_VALUE / 2, { NONCE }) { arrived += it }
    private val reader = PerceptDecoder()
    private var number = 0

    fun write(bytes: ByteArray) = line.write(bytes, 0, bytes.size, LIMIT_MILLIS)

    /** Sends a frame of the session that [hello] begins. */
    fun write(kind: FrameKind, number: Int, payload: String) = write(WireFrame.of(kind, number, payload).toBytes(NONCE))

    fun next(): WireFrame {
        val buffer = ByteArray(1024)
        while (arrived.isEmpty()) {
            val count = line.read(buffer, 0, buffer.size, LIMIT_MILLIS)
            check(count > 0) { "the board sent nothing within $LIMIT_MILLIS ms" }
            decoder.accept(buffer, 0, count, 0)
        }
        return arrived.removeFirst()
    }

    fun exchange(kind: FrameKind, number: Int, payload: String): WireFrame {
        write(kind, number, payload)
        return next()
    }

    fun hello(): ComputerEnd = apply {
        number = 0
        check(exchange(FrameKind.HELLO, NONCE, "").kind() == FrameKind.WELCOME)
    }

    fun command(text: String) = command(CommandItem.Text(text))

    fun command(item: CommandItem) = exchange(FrameKind.COMMANDS_WITH_RESUME, number++, item.payload())

    fun ask(functors: String = "", known: Int = reader.known()): String {
        write(FrameKind.ASK, 1, known.toChar() + functors)
        return percepts()
    }

    /** The next answer, or percepts that were sent unasked. */
    fun percepts(): String {
        val first = next()
        if (first.kind() == FrameKind.PERCEPTS) return reader.read(first.payload().drop(1), LIMIT).get()
        val parts = mutableListOf(first)
        while (parts.last().kind() == FrameKind.PERCEPTS_PART) parts += next()
        check(parts.last().kind() == FrameKind.PERCEPTS_LAST) { "an answer ended with ${parts.last()}" }
        return reader.read(parts.joinToString("") { it.payload().drop(2) }, LIMIT).get()
    }

    /** Asks in version 1 until an answer comes. On a busy machine the pause before a request may be too short. */
    fun askInVersion1(): String {
        val answers = mutableListOf<String>()
        val decoder = FrameDecoder(Long.MAX_VALUE / 2) { answers += it.text() }
        val buffer = ByteArray(1024)
        repeat(LIMIT_MILLIS / PAUSE_MILLIS) {
            line.read(buffer, 0, buffer.size, PAUSE_MILLIS).let { check(it == 0) { "the board sent something unasked" } }
            write(Frame.of("getPercepts").toBytes())
            do {
                val count = line.read(buffer, 0, buffer.size, PAUSE_MILLIS)
                decoder.accept(buffer, 0, count, 0)
            } while (count > 0 && answers.isEmpty())
            if (answers.isNotEmpty()) return answers.single()
        }
        error("the board answered nothing within $LIMIT_MILLIS ms")
    }

    private companion object {
        const val NONCE = 7
        const val LIMIT_MILLIS = 20_000
        const val PAUSE_MILLIS = 100
    }
}

private const val LIMIT = 65_536
