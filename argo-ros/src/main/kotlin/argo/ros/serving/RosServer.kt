package argo.ros.serving

import argo.platform.ThinnedLog
import argo.platform.foreignText
import org.java_websocket.WebSocket
import org.java_websocket.WebSocketAdapter
import org.java_websocket.WebSocketImpl
import org.java_websocket.WebSocketServerFactory
import org.java_websocket.drafts.Draft
import org.java_websocket.drafts.Draft_6455
import org.java_websocket.exceptions.InvalidDataException
import org.java_websocket.exceptions.WebsocketNotConnectedException
import org.java_websocket.framing.CloseFrame
import org.java_websocket.framing.Framedata
import org.java_websocket.framing.PingFrame
import org.java_websocket.handshake.ClientHandshake
import org.java_websocket.handshake.ServerHandshakeBuilder
import org.java_websocket.server.WebSocketServer
import java.io.IOException
import java.nio.ByteBuffer
import java.nio.channels.ByteChannel
import java.nio.channels.SelectionKey
import java.nio.channels.SocketChannel
import java.util.concurrent.CompletableFuture
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.ExecutionException
import java.util.concurrent.RejectedExecutionException
import java.util.concurrent.ScheduledThreadPoolExecutor
import java.util.concurrent.ThreadLocalRandom
import java.util.concurrent.TimeUnit
import java.util.logging.Level
import java.util.logging.Logger

/**
 * A server of the rosbridge protocol, version 2, with [graph] behind it. It listens when this is made.
 *
 * A client cannot hurt another, nor a board: the server limits what it may send and leave unread, and disconnects a client that exceeds a
 * limit.
 *
 * @throws RefusedServer if the address cannot be had
 */
internal class RosServer(private val access: Access, private val graph: Graph, private val tell: (String) -> Unit) : AutoCloseable {
    private val started = CompletableFuture<Unit>()
    private val rosApi = RosApiServices(graph, System::currentTimeMillis)
    private val channels = ConcurrentHashMap.newKeySet<LimitedChannel>()
    private val timer = ScheduledThreadPoolExecutor(1) { Thread(it, "argo-ros-timer").apply { isDaemon = true } }
        .apply { removeOnCancelPolicy = true }
    private val lines = ThinnedLog({ TimeUnit.NANOSECONDS.toMillis(System.nanoTime()) }) { delayMs, action ->
        later(TimeUnit.MILLISECONDS.toNanos(delayMs), action)
    }
    private val server = Server()

    init {
        server.start()
        try {
            started.get(START_S, TimeUnit.SECONDS)
        } catch (failed: ExecutionException) {
            close()
            val place = "${access.address.hostString}:${access.address.port}"
            throw RefusedServer("$place cannot be had, it is in use or not allowed (${failed.cause?.message})")
        }
        timer.scheduleWithFixedDelay(::check, CHECK_S, CHECK_S, TimeUnit.SECONDS)
    }

    /** The port that it listens at. */
    val port: Int get() = server.port

    /** The number of connections. */
    val connections: Int get() = channels.size

    /** Logs [line], bounded, since anybody on the network may cause it. */
    private fun log(kind: String, line: String) = lines.report(kind) { more -> tell(foreignText(line) + more) }

    private fun check() = try {
        val now = System.nanoTime()
        channels.filter { it.isLate(now) }.forEach { it.close() }
        server.connections.forEach { sessionOf(it)?.subscriber?.check() }
    } catch (broken: Throwable) { // thrown, it would end the timer
        log("check", "the server's look after its clients failed: $broken")
    }

    /** Ends all connections, and frees the port. Waits only for the end of the server's threads. */
    override fun close() {
        timer.shutdownNow()
        try {
            server.stop(STOP_MS)
        } catch (_: InterruptedException) {
            Thread.currentThread().interrupt()
        }
        channels.toList().forEach { it.close() }
    }

    private class Session(val client: Client, val subscriber: Subscriber)

    private fun sessionOf(connection: WebSocket?): Session? = connection?.getAttachment()

    private fun sessionFor(connection: WebSocket): Session {
        val socket = Socket(connection)
        val subscriber = Subscriber(socket, System::nanoTime, { ThreadLocalRandom.current().nextLong() }, ::later)
        return Session(Client(graph, rosApi, subscriber, socket::end, System::nanoTime), subscriber)
    }

    private fun later(nanos: Long, action: () -> Unit) {
        try {
            timer.schedule(action, nanos, TimeUnit.NANOSECONDS)
        } catch (_: RejectedExecutionException) {
            // the server is being closed
        }
    }

    private inner class Socket(private val connection: WebSocket) : ClientSocket {
        override fun send(text: String) = ifOpen { connection.send(text) }

        override fun ping(number: Long) = ifOpen {
            connection.sendFrame(PingFrame().apply { setPayload(ByteBuffer.allocate(Long.SIZE_BYTES).putLong(number).flip()) })
        }

        override fun end(reason: String) {
            log("left", "the client at ${connection.remoteSocketAddress} is left: $reason")
            (connection as WebSocketImpl).closeConnection(CloseFrame.POLICY_VALIDATION, reason)
        }

        private fun ifOpen(work: () -> Unit) {
            try {
                work()
            } catch (_: WebsocketNotConnectedException) {
                // it has gone
            }
        }
    }

    private inner class Server : WebSocketServer(access.address, DECODERS, listOf(Draft_6455(emptyList(), MAX_MESSAGE))) {
        init {
            isReuseAddr = true
            isDaemon = true
            isTcpNoDelay = true
            connectionLostTimeout = 0 // each subscriber looks after its client
            setWebSocketFactory(Connections())
        }

        override fun onWebsocketHandshakeReceivedAsServer(
            connection: WebSocket, draft: Draft, request: ClientHandshake,
        ): ServerHandshakeBuilder {
            val (authorization, origin) = listOf("Authorization", "Origin").map(request::getFieldValue)
            val refusal = access.refusal(request.resourceDescriptor, authorization, origin) ?: return super
                .onWebsocketHandshakeReceivedAsServer(connection, draft, request)
            log("refused", "the client at ${connection.remoteSocketAddress} is refused: $refusal")
            throw InvalidDataException(CloseFrame.POLICY_VALIDATION, refusal)
        }

        override fun onOpen(connection: WebSocket, handshake: ClientHandshake) {
            channelOf(connection)?.isAdmitted = true
            val session = sessionFor(connection)
            connection.setAttachment(session)
            graph.topics.add(session.subscriber)
        }

        override fun onClose(connection: WebSocket, code: Int, reason: String, remote: Boolean) {
            val session = sessionOf(connection) ?: return
            graph.topics.remove(session.subscriber)
            session.subscriber.stop()
        }

        override fun onMessage(connection: WebSocket, message: String) {
            channelOf(connection)?.messageEnded()
            sessionOf(connection)?.client?.hear(message)
        }

        override fun onMessage(connection: WebSocket, message: ByteBuffer) {
            channelOf(connection)?.messageEnded()
            sessionOf(connection)?.client?.hear("(binary)")
        }

        override fun onWebsocketPing(connection: WebSocket, frame: Framedata) {
            channelOf(connection)?.messageEnded()
            if (sessionOf(connection)?.client?.counts() != true) return
            super.onWebsocketPing(connection, frame)
            sessionOf(connection)?.subscriber?.sent(CONTROL_CHARS)
        }

        override fun onWebsocketPong(connection: WebSocket, frame: Framedata) {
            channelOf(connection)?.messageEnded()
            if (sessionOf(connection)?.client?.counts() != true) return
            val payload = frame.payloadData
            if (payload.remaining() == Long.SIZE_BYTES) sessionOf(connection)?.subscriber?.answered(payload.duplicate().getLong())
        }

        override fun onError(connection: WebSocket?, trouble: Exception) {
            if (connection == null && !started.completeExceptionally(trouble)) log("trouble", "the server is in trouble: $trouble")
        }

        override fun onStart() {
            started.complete(Unit)
        }
    }

    private inner class Connections : WebSocketServerFactory {
        override fun createWebSocket(adapter: WebSocketAdapter, draft: Draft) = WebSocketImpl(adapter, draft)

        override fun createWebSocket(adapter: WebSocketAdapter, drafts: List<Draft>) = WebSocketImpl(adapter, drafts)

        override fun wrapChannel(channel: SocketChannel, key: SelectionKey): ByteChannel = LimitedChannel(channel)

        override fun close() = Unit
    }

    private fun channelOf(connection: WebSocket): LimitedChannel? = (connection as? WebSocketImpl)?.channel as? LimitedChannel

    /**
     * A connection whose client must show soon that it speaks WebSocket, and may not send a message without an end.
     *
     * @throws IOException if there are too many
     */
    private inner class LimitedChannel(private val channel: SocketChannel) : ByteChannel {
        private val sinceNanos = System.nanoTime()
        private var unended = 0L

        @Volatile
        var isAdmitted = false

        init {
            if (channels.size >= MAX_CONNECTIONS) refuse()
            channels += this
        }

        private fun refuse(): Nothing {
            val reason = "there are $MAX_CONNECTIONS connections already"
            log("full", "the client at ${channel.remoteAddress} is refused: $reason")
            channel.write(ByteBuffer.wrap(FULL.toByteArray()))
            throw IOException(reason)
        }

        fun messageEnded() {
            synchronized(this) { unended = 0 }
        }

        fun isLate(nowNanos: Long) = !isAdmitted && nowNanos - sinceNanos > HANDSHAKE_NANOS

        override fun read(target: ByteBuffer): Int {
            val count = channel.read(target)
            val sum = synchronized(this) { (unended + maxOf(0, count)).also { unended = it } }
            if (sum > if (isAdmitted) 2L * MAX_MESSAGE else MAX_HANDSHAKE) throw IOException("a message does not end")
            return count
        }

        override fun write(source: ByteBuffer): Int = channel.write(source)

        override fun isOpen(): Boolean = channel.isOpen

        override fun close() {
            channels -= this
            channel.close()
        }
    }

    companion object {
        /** Silences the library's log, since this class reports clients and ports; kept, since loggers are garbage collected. */
        private val libraryLog = Logger.getLogger(WebSocket::class.java.packageName).apply { if (level == null) level = Level.OFF }

        private const val START_S = 10L
        private const val STOP_MS = 200
        private const val CHECK_S = 1L
        private const val DECODERS = 2
        private const val CONTROL_CHARS = 130

        /** The longest message of a client, in bytes. */
        const val MAX_MESSAGE = 256 * 1024
        private const val MAX_HANDSHAKE = 16L * 1024
        private val HANDSHAKE_NANOS = TimeUnit.SECONDS.toNanos(5)

        /** The response to a client for which there is no room. */
        private const val FULL = "HTTP/1.1 503 Service Unavailable\r\nConnection: close\r\nContent-Length: 0\r\n\r\n"

        /** The largest number of clients at once. */
        const val MAX_CONNECTIONS = 64
    }
}
