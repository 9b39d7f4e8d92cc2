package argo.jason

import javino.Frame
import javino.FrameDecoder
import java.io.IOException
import java.net.InetAddress
import java.net.ServerSocket
import java.net.Socket
import java.util.concurrent.ConcurrentLinkedQueue
import kotlin.concurrent.thread

/** A board on the network, of version 1. The board counts the requests for percepts that it answers. */
internal class NetworkBoard(number: Int = 0) : AutoCloseable {
    private val server = ServerSocket(number, 1, InetAddress.getLoopbackAddress())
    private val connections = ConcurrentLinkedQueue<Socket>()

    @Volatile
    var answers = 0
        private set

    /** True if the board reads but does not answer. */
    @Volatile
    var isMute = false

    /** All messages except requests for percepts. */
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
            // this connection is broken; the next one may come
        }
    }

    fun cut() = connections.forEach(Socket::close)

    override fun close() {
        server.close()
        cut()
    }
}
