package argo.ros.bridge

import argo.filters.foreignText
import argo.ros.mapping.Credentials
import javino.NoSuchPortException
import javino.PortException
import javino.PortFaultException
import javino.PortInterruptedException
import kotlinx.serialization.json.JsonObject
import java.io.IOException
import java.lang.ref.WeakReference
import java.net.ConnectException
import java.net.URI
import java.net.http.HttpClient
import java.net.http.HttpConnectTimeoutException
import java.net.http.WebSocket
import java.net.http.WebSocketHandshakeException
import java.nio.ByteBuffer
import java.nio.channels.UnresolvedAddressException
import java.security.cert.CertPathBuilderException
import java.time.Duration
import java.time.Instant
import java.util.concurrent.CompletableFuture
import java.util.concurrent.CompletionStage
import java.util.concurrent.ExecutionException
import java.util.concurrent.TimeUnit
import java.util.concurrent.TimeoutException

/**
 * Receives a bridge's messages on a thread of the HTTP client, and reads its operations in their order. No function may block. [warn] takes
 * unreadable messages and the bridge's complaints, each text once.
 */
internal abstract class BridgeListener(private val warn: (String) -> Unit) {
    /** Handles [operation]; returns false if this class does not know the operation. */
    protected abstract fun hear(operation: JsonObject): Boolean

    fun text(message: String) {
        val operation = operationIn(message)
            ?: return warn("the bridge sends a text that is no operation of the rosbridge protocol: \"${message.take(QUOTED)}\"")
        if (hear(operation)) return
        val kind = operation.text("op")
        if (kind != "status") warn("the bridge sends the operation $kind, which is not read")
        else if (operation.text("level") in TROUBLE) warn("the bridge reports: ${operation.text("msg")}")
    }

    /** The bridge is alive, as any message or pong shows. */
    abstract fun isAlive()

    /** The bridge has answered a [Bridge.ping]. The bridge has therefore read everything that was sent before the ping. */
    open fun answered() = isAlive()

    /** A message was dropped unread; [what] describes it. */
    fun dropped(what: String) = warn("the bridge sends $what; it is not read")

    /** Takes a [sentence] for the user about the bag that is played. [isTrouble] is true if a part of the bag is left out. */
    open fun told(sentence: String, isTrouble: Boolean) = Unit

    /** The connection has ended, for [reason]. May be called more than once. */
    abstract fun gone(reason: String)

    private companion object {
        val TROUBLE = setOf("error", "warning")
        const val QUOTED = 60
    }
}

/** A connection to a bridge. No function blocks. Safe for use by several threads. */
internal interface Bridge : AutoCloseable {
    /** Sends [message]. The caller must hold no lock, since callbacks of sent messages may run on its thread. */
    fun send(message: Outgoing) {
        queue(message)
        flush()
    }

    /** Queues [message] for the next [send] or [flush]; runs no callbacks. */
    fun queue(message: Outgoing)

    /** Sends the queued messages. The caller must hold no lock; [send] tells why. */
    fun flush()

    fun ping()
}

/**
 * A WebSocket to a bridge. Urgent messages overtake others; otherwise messages keep their order. The reference to [client] keeps the client
 * of [socket] alive.
 */
internal class BridgeSocket private constructor(private val client: HttpClient, private val socket: WebSocket) : Bridge {
    private val outbox = Outbox { socket.sendText(it, true) }

    override fun queue(message: Outgoing) = outbox.add(message)

    override fun flush() = outbox.flush()

    override fun ping() {
        try {
            socket.sendPing(ByteBuffer.allocate(0))
        } catch (_: IllegalStateException) {
            // an earlier ping has no answer yet
        }
    }

    /** Closes the connection within [CLOSING_MS]. Messages that the bridge does not read within this time are lost. */
    override fun close() {
        outbox.close()
        socket.sendClose(WebSocket.NORMAL_CLOSURE, "")
        CompletableFuture.delayedExecutor(CLOSING_MS, TimeUnit.MILLISECONDS).execute { socket.abort() }
    }

    private class Receiver(private val listener: BridgeListener, private val hasLoggedIn: Boolean) : WebSocket.Listener {
        private val text = StringBuilder()
        private var isSilent = true // true until the bridge's first message
        private var isTooLong = false

        override fun onText(socket: WebSocket, data: CharSequence, last: Boolean): CompletionStage<*>? {
            if (!isTooLong && text.length + data.length > MAX_LENGTH) {
                isTooLong = true
                text.append(data).setLength(SHOWN_LENGTH)
            }
            if (!isTooLong) text.append(data)
            isSilent = false
            if (last) {
                if (isTooLong) listener.dropped("a message of more than $MAX_LENGTH characters, which begins $text")
                else listener.text(text.toString())
                if (text.capacity() > KEPT_LENGTH) text.apply { setLength(0) }.trimToSize() else text.setLength(0)
                isTooLong = false
            }
            listener.isAlive()
            socket.request(1)
            return null
        }

        override fun onBinary(socket: WebSocket, data: ByteBuffer, last: Boolean): CompletionStage<*>? {
            if (last) listener.dropped("a binary message, though ARGO asks for none")
            socket.request(1)
            return null
        }

        override fun onPong(socket: WebSocket, message: ByteBuffer): CompletionStage<*>? {
            listener.answered()
            socket.request(1)
            return null
        }

        override fun onClose(socket: WebSocket, statusCode: Int, reason: String): CompletionStage<*>? {
            val hint = if (hasLoggedIn && isSilent) "; does it know another secret, or differ its clock by 5 s?" else ""
            val why = reason.takeIf { it.isNotBlank() }?.let { ": ${foreignText(it)}" }.orEmpty()
            listener.gone("the bridge has closed the connection$why$hint")
            return null
        }

        override fun onError(socket: WebSocket, error: Throwable) =
            listener.gone("the connection to the bridge is broken: ${reasonIn(error)}")
    }

    companion object {
        private const val CONNECTING_S = 3L
        private const val CLOSING_MS = 1_000L

        /** The length limit of a message, in characters. Longer messages are dropped. */
        const val MAX_LENGTH = 4 * 1024 * 1024
        private const val KEPT_LENGTH = 64 * 1024

        /** The number of characters of a dropped message in the log. The topic's name is among them. */
        private const val SHOWN_LENGTH = 60

        /** One client for each address, since each client has its own thread. A client ends when no socket uses it. */
        private val clients = HashMap<String, WeakReference<HttpClient>>()

        /**
         * Returns the client for the bridge at [address]. The client's thread reads the bytes and also handles the messages. An executor
         * would have to wake a thread for each message.
         */
        @Synchronized
        private fun clientFor(address: URI): HttpClient = clients[address.authority]?.get()
            ?: HttpClient.newBuilder().connectTimeout(Duration.ofSeconds(CONNECTING_S)).executor(Runnable::run).build()
                .also { clients[address.authority] = WeakReference(it) }

        /**
         * Connects to the bridge at [address].
         *
         * @throws NoSuchPortException if the host does not exist, or nothing answers there
         * @throws PortInterruptedException if the thread is interrupted
         * @throws PortFaultException if the server that answers is no bridge
         */
        fun connect(port: String, address: URI, listener: BridgeListener, credentials: Credentials = Credentials()): BridgeSocket {
            val client = clientFor(address)
            val builder = client.newWebSocketBuilder().connectTimeout(Duration.ofSeconds(CONNECTING_S))
            if (credentials.token != null) builder.header("Authorization", "Bearer ${credentials.token}")
            val opening: CompletableFuture<WebSocket> = builder.buildAsync(address, Receiver(listener, credentials.secret != null))
            var isTaken = false
            try {
                return BridgeSocket(client, opening.get(2 * CONNECTING_S, TimeUnit.SECONDS)).also { socket ->
                    isTaken = true
                    credentials.secret?.let { socket.send(Outgoing(login(it, address.host, Instant.now().epochSecond))) }
                }
            } catch (_: InterruptedException) {
                throw PortInterruptedException.remarking(port)
            } catch (failed: ExecutionException) {
                throw refusal(port, address, failed.cause ?: failed)
            } catch (_: TimeoutException) {
                throw NoSuchPortException(port, "port $port cannot be opened: ${address.authority} accepts, but does not answer")
            } finally {
                if (!isTaken) opening.thenAccept(WebSocket::abort)
            }
        }

        /**
         * Returns the first message in [error] and its causes: that of a broken rule of WebSocket is in a cause. It may quote what a program
         * that is no bridge has sent.
         */
        private fun reasonIn(error: Throwable): String =
            foreignText(generateSequence(error) { it.cause }.firstNotNullOfOrNull { it.message } ?: error.javaClass.simpleName)

        private fun refusal(port: String, address: URI, cause: Throwable): PortException {
            val start = "port $port cannot be opened: "
            val place = address.authority
            return when {
                cause is HttpConnectTimeoutException ->
                    NoSuchPortException(port, "$start$place did not answer within $CONNECTING_S s; is the robot on, and in this network?")
                generateSequence(cause) { it.cause }.any { it is UnresolvedAddressException } ->
                    NoSuchPortException(port, "${start}there is no host ${address.host}")
                cause is ConnectException -> NoSuchPortException(
                    port, "${start}nothing listens at $place; does rosbridge_server run, and is ${address.port} its port?",
                )
                cause is WebSocketHandshakeException ->
                    PortFaultException(port, "${start}$place is no bridge: it answers ${cause.response.statusCode()}", cause)
                generateSequence(cause) { it.cause }.any { it is CertPathBuilderException } -> PortFaultException(
                    port, "${start}nobody who is trusted has signed the certificate of $place; -Djavax.net.ssl.trustStore names a file " +
                        "of others to be trusted", cause,
                )
                cause is IOException ->
                    PortFaultException(port, "${start}the program at $place does not answer as a bridge: ${reasonIn(cause)}", cause)
                else -> PortFaultException(port, "$start$cause", cause)
            }
        }
    }
}
