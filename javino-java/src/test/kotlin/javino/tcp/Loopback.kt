package javino.tcp

import javino.LineSettings
import javino.Transport
import java.net.InetAddress
import java.net.InetSocketAddress
import java.net.ServerSocket
import java.net.Socket

/** A program that listens on this machine's loopback address, as a board on a network does. */
internal class Loopback : AutoCloseable {
    private val server = ServerSocket().apply {
        receiveBufferSize = 4096 // so that the sender soon notices a far end that does not read
        bind(InetSocketAddress(InetAddress.getLoopbackAddress(), 0))
    }
    val number: Int = server.localPort
    val port: String = "tcp://127.0.0.1:$number"

    /** The next connection; with [breaks] its end does not close it but breaks it. */
    fun accept(breaks: Boolean = false): Socket = server.accept().apply {
        if (breaks) setSoLinger(true, 0)
    }

    /** The far end's transport of the next connection; as [accept]. */
    fun accepted(line: LineSettings = LineSettings.defaults(), breaks: Boolean = false): Transport =
        TcpTransport(accept(breaks), "the board's end", line)

    override fun close() = server.close()
}
