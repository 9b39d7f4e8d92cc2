package samples.firmware

import javino.LineSettings
import javino.PortException
import javino.Transports
import java.io.IOException
import java.net.InetAddress
import java.net.ServerSocket
import java.util.Random
import kotlin.concurrent.thread
import kotlin.experimental.xor

/** A connection of one program to the board on [boardPort]. Damages one byte in 200 in both directions, always the same ones. */
internal class DamagedLine(boardPort: String) : AutoCloseable {
    private val server = ServerSocket(0, 1, InetAddress.getLoopbackAddress())
    private val board = Transports.open(boardPort, LineSettings(BAUD))
    private val threads = listOf(thread(isDaemon = true) { runUntilClosed(::serve) })

    val port = "tcp://127.0.0.1:${server.localPort}"

    @Volatile
    var damaged = 0
        private set

    private fun serve() = server.accept().use { program ->
        val back = thread(isDaemon = true) {
            runUntilClosed {
                val random = Random(1)
                val bytes = ByteArray(BLOCK)
                while (true) {
                    val count = board.read(bytes, 0, BLOCK, READ_MS)
                    damage(bytes, count, random)
                    program.getOutputStream().write(bytes, 0, count)
                }
            }
        }
        val random = Random(2)
        val bytes = ByteArray(BLOCK)
        while (true) {
            val count = program.getInputStream().read(bytes)
            if (count < 0) break
            damage(bytes, count, random)
            board.write(bytes, 0, count, WRITE_MS)
        }
        program.close()
        back.join()
    }

    private fun damage(bytes: ByteArray, count: Int, random: Random) {
        for (i in 0 until count) if (random.nextInt(ONE_IN) == 0) {
            bytes[i] = bytes[i] xor (1 + random.nextInt(255)).toByte()
            synchronized(this) { damaged++ }
        }
    }

    private fun runUntilClosed(body: () -> Unit) {
        try {
            body()
        } catch (_: IOException) {
        } catch (_: PortException) {
        }
    }

    override fun close() {
        server.close()
        board.close()
        threads.forEach { it.join() }
    }
}

private const val BAUD = 115_200
private const val BLOCK = 256
private const val ONE_IN = 200
private const val READ_MS = 100
private const val WRITE_MS = 10_000
