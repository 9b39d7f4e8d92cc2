package javino.tcp

import java.net.InetAddress
import java.net.InetSocketAddress
import java.net.StandardSocketOptions
import java.nio.channels.ServerSocketChannel
import java.nio.channels.SocketChannel
import javino.LineSettings
import javino.Transport

/** A program that listens on this machine's loopback address, as a board on a network does. */
internal class Loopback : AutoCloseable {
    private val server: ServerSocketChannel = ServerSocketChannel.open().apply {
        setOption(StandardSocketOptions.SO_RCVBUF, 4096) // so that one who does not read is soon noticed
        bind(InetSocketAddress(InetAddress.getLoopbackAddress(), 0))
    }
    val number: Int = (server.localAddress as InetSocketAddress).port
    val port: String = "tcp://127.0.0.1:$number"

    /** The next one who connects; with [breaks] its end does not close the connection but breaks it. */
    fun accept(breaks: Boolean = false): SocketChannel = server.accept().apply {
        if (breaks) setOption(StandardSocketOptions.SO_LINGER, 0)
    }

    /** The far end's transport of the next connection; as [accept]. */
    fun accepted(line: LineSettings = LineSettings.defaults(), breaks: Boolean = false): Transport =
        TcpTransport.over(accept(breaks), "the board's end", line)

    override fun close() = server.close()
}
