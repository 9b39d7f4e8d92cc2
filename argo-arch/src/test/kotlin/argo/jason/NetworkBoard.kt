package argo.jason

import javino.Frame
import javino.FrameDecoder
import java.io.IOException
import java.net.InetAddress
import java.net.ServerSocket
import java.net.Socket
import java.util.concurrent.ConcurrentLinkedQueue
import kotlin.concurrent.thread

/** A board on the network, of version 1: it counts the requests for percepts that it answers. */
internal class NetworkBoard(number: Int = 0) : AutoCloseable {
    private val server = ServerSocket(number, 1, InetAddress.getLoopbackAddress())
    private val connections = ConcurrentLinkedQueue<Socket>()

    /** The number of requests for percepts that it has answered. */
    @Volatile
    var answers = 0
        private set

    /** True if it does not answer, though it reads. */
    @Volatile
    var isMute = false

    /** All messages but requests for percepts. */
    val received = ConcurrentLinkedQueue<String>()
    val number: Int get() = server.localPort
    val port get() = "tcp://127.0.0.1:$number"

    init {
        thread(isDaemon = true) {
            try {
                while (true) serve(server.accept().also(connections::add))
            } catch (_: IOException) {
                // the board was switched off
            }
        }
    }

    private fun serve(connection: Socket) {
        val decoder = FrameDecoder(1_000_000_000) { frame ->
            when {
                frame.text() != "getPercepts" -> received += frame.text()
                !isMute -> connection.getOutputStream().write(Frame.of("count(${++answers});").toBytes())
            }
        }
        val bytes = ByteArray(1024)
        try {
            while (true) {
                val read = connection.getInputStream().read(bytes)
                if (read < 0) return connection.close()
                decoder.accept(bytes, 0, read, System.nanoTime())
            }
        } catch (_: IOException) {
            // this connection broke; the next one may come
        }
    }

    /** Ends all connections. */
    fun cut() = connections.forEach(Socket::close)

    override fun close() {
        server.close()
        cut()
    }
}
