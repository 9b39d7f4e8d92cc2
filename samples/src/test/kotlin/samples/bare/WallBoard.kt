package samples.bare

import javino.Frame
import javino.FrameDecoder
import java.io.File
import java.io.FileInputStream
import java.io.FileOutputStream
import java.io.IOException
import java.util.concurrent.CompletableFuture
import java.util.concurrent.ConcurrentLinkedQueue
import java.util.concurrent.TimeUnit
import kotlin.concurrent.thread

/**
 * The board of a robot on a pseudo-terminal. While the robot drives, each answer shows the wall one centimetre nearer.
 *
 * @param device the board's end
 */
class WallBoard(device: File) : AutoCloseable {
    private val input = FileInputStream(device)
    private val output = FileOutputStream(device)
    private var driving = false
    private var distance = 60

    val commands = ConcurrentLinkedQueue<String>()

    val stoppedAt = CompletableFuture<Int>()

    private val sketch = thread(isDaemon = true, name = "board") {
        val decoder = FrameDecoder(TimeUnit.MILLISECONDS.toNanos(100)) { handle(it.text()) }
        val buffer = ByteArray(256)
        try {
            while (true) decoder.accept(buffer, 0, input.read(buffer).also { if (it < 0) return@thread }, System.nanoTime())
        } catch (_: IOException) {
            // the pseudo-terminal was closed
        }
    }

    private fun handle(message: String) {
        if (message == "getPercepts") return answer()
        commands += message
        if (message == "front") driving = true
        if (message == "stop") {
            driving = false
            stoppedAt.complete(distance)
        }
    }

    private fun answer() {
        if (driving) distance--
        val n = commands.size
        val percepts = "dist(f,$distance);dist(b,${200 + n % 9});light(f,${95 + n % 10});light(b,3);temp(f,${21 + n % 9});temp(b,20);"
        output.write(Frame.of(percepts).toBytes())
    }

    override fun close() {
        input.close()
        output.close()
        sketch.join(TimeUnit.SECONDS.toMillis(10))
    }
}
