package benchmarks

import javino.Frame
import javino.FrameDecoder
import javino.PerceptsRequest
import java.io.File
import java.io.FileInputStream
import java.io.FileOutputStream
import java.util.concurrent.TimeUnit

/**
 * A board on a pseudo-terminal. The board answers each request with twelve changing percepts. One of them is `ping(N)`. The board measures
 * the time until the first byte of the command `pong(N)` arrives.
 *
 * @param exchanges the number of measured commands
 */
class PingBoard(device: File, private val exchanges: Int) {
    private val input = FileInputStream(device)
    private val output = FileOutputStream(device)
    private val latencies = LongArray(exchanges)
    private var measured = 0
    private var sent = 0
    private var answeredAt = 0L

    fun measure(): LongArray {
        var readAt = 0L
        val decoder = FrameDecoder(TimeUnit.MILLISECONDS.toNanos(100)) { frame -> handle(frame.text(), readAt) }
        val buffer = ByteArray(256)
        var firstByteAt = 0L
        while (measured < exchanges) {
            val count = input.read(buffer)
            check(count >= 0) { "the pseudo-terminal is closed" }
            val now = System.nanoTime()
            if (firstByteAt == 0L) firstByteAt = now
            readAt = firstByteAt
            val before = decoder.frames()
            decoder.accept(buffer, 0, count, now)
            if (decoder.frames() != before) firstByteAt = 0L
        }
        return latencies
    }

    private fun handle(message: String, firstByteAt: Long) {
        if (message == PerceptsRequest.ALL) answer()
        else if (message == "pong($sent)") latencies[measured++] = firstByteAt - answeredAt
    }

    private fun answer() {
        sent++
        val sides = listOf("f", "b", "l", "r")
        val percepts = listOf("ping($sent)") + sides.map { "dist($it,${sent % 100 + 20})" } +
            sides.map { "light($it,${sent % 90})" } + sides.take(3).map { "temp($it,${sent % 30})" }
        output.write(Frame.of(percepts.joinToString(";", postfix = ";")).toBytes())
        answeredAt = System.nanoTime()
    }
}
