package javino.tcp

import javino.LineSettings
import javino.Transport
import java.net.InetAddress
import java.net.InetSocketAddress
import java.net.ServerSocket
import java.net.Socket

/** A TCP server on the loopback address, in place of a board on a network. */
internal class Loopback : AutoCloseable {
    private val server = ServerSocket().apply {
        receiveBufferSize = 4096 // the sender soon notices that the far end does not read
        bind(InetSocketAddress(InetAddress.getLoopbackAddress(), 0))
    }
    val number: Int = server.localPort
    val port: String = "tcp://127.0.0.1:$number"

    /** Accepts the next connection. If [breaks], closing this end resets the connection. */
    fun accept(breaks: Boolean = false): Socket = server.accept().apply {
        if (breaks) setSoLinger(true, 0)
    }

    fun accepted(line: LineSettings = LineSettings.defaults(), breaks: Boolean = false): Transport =
        TcpTransport(accept(breaks), "the board's end", line)

    override fun close() = server.close()
}
