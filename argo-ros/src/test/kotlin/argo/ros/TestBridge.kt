package argo.ros

import argo.ros.bridge.operation
import argo.ros.bridge.operationIn
import argo.ros.bridge.part
import argo.ros.bridge.text
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import org.java_websocket.WebSocket
import org.java_websocket.drafts.Draft
import org.java_websocket.exceptions.InvalidDataException
import org.java_websocket.framing.CloseFrame
import org.java_websocket.framing.Framedata
import org.java_websocket.framing.PingFrame
import org.java_websocket.framing.PongFrame
import org.java_websocket.handshake.ClientHandshake
import org.java_websocket.handshake.ServerHandshakeBuilder
import org.java_websocket.server.DefaultSSLWebSocketServerFactory
import org.java_websocket.server.WebSocketServer
import java.net.InetAddress
import java.net.InetSocketAddress
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.ConcurrentLinkedQueue
import java.util.concurrent.CountDownLatch
import java.util.concurrent.Executors
import java.util.concurrent.TimeUnit
import javax.net.ssl.SSLContext

/** Maps the arguments of a service to its success, and to its values or the reason of the failure. */
internal typealias Service = (JsonObject) -> Pair<Boolean, JsonElement>

/**
 * A bridge in this program. The bridge throttles subscriptions like rosbridge 0.11.17: a queue keeps the newest messages and sends one each
 * interval. Without a queue, it drops early messages.
 *
 * @param number its TCP port, or 0 for a free one
 * @param token the token that clients must send, or null for none
 * @param tls the encryption of the connections, or null for none
 */
internal class TestBridge(number: Int = 0, token: String? = null, tls: SSLContext? = null) : AutoCloseable {
    private val started = CountDownLatch(1)
    private val timer = Executors.newSingleThreadScheduledExecutor { Thread(it, "test-bridge-timer").apply { isDaemon = true } }
    private val subscriptions = ConcurrentHashMap<String, Handler>() // by topic, since the tests have one client

    val heard = ConcurrentLinkedQueue<JsonObject>()
    private val services = ConcurrentHashMap<String, Service>()

    private val held = ConcurrentLinkedQueue<() -> Unit>() // answers to pings that are held back

    /** True if it answers pings. When it becomes true, earlier pings are answered. */
    @Volatile
    var answersPings = true
        set(value) {
            field = value
            if (value) generateSequence(held::poll).forEach { it() }
        }

    @Volatile
    var onPublish: (topic: String, message: JsonObject) -> Unit = { _, _ -> }

    @Volatile
    var onGoal: (goal: JsonObject) -> Unit = { }

    private val server = object : WebSocketServer(InetSocketAddress(InetAddress.getLoopbackAddress(), number), 1) {
        override fun onWebsocketHandshakeReceivedAsServer(
            connection: WebSocket, draft: Draft, request: ClientHandshake,
        ): ServerHandshakeBuilder {
            val isMeant = token == null || request.getFieldValue("Authorization") == "Bearer $token"
            if (!isMeant) throw InvalidDataException(CloseFrame.POLICY_VALIDATION)
            return super.onWebsocketHandshakeReceivedAsServer(connection, draft, request)
        }

        override fun onOpen(connection: WebSocket, handshake: ClientHandshake) = subscriptions.clear()

        override fun onClose(connection: WebSocket, code: Int, reason: String, remote: Boolean) = Unit

        override fun onMessage(connection: WebSocket, message: String) = hear(connection, checkNotNull(operationIn(message)))

        override fun onError(connection: WebSocket?, trouble: Exception) = Unit

        override fun onStart() = started.countDown()

        override fun onWebsocketPing(connection: WebSocket, frame: Framedata) {
            val pong = PongFrame(frame as PingFrame)
            if (answersPings) connection.sendFrame(pong) else held += { if (connection.isOpen) connection.sendFrame(pong) }
        }
    }.apply {
        isReuseAddr = true
        isDaemon = true
        isTcpNoDelay = true
        tls?.let { setWebSocketFactory(DefaultSSLWebSocketServerFactory(it)) }
        start()
    }

    init {
        check(started.await(60, TimeUnit.SECONDS)) { "the bridge does not start" }
    }

    val number: Int get() = server.port

    val port: String get() = "ros://127.0.0.1:$number"

    val clients: Int get() = server.connections.size

    fun serve(service: String, answer: Service) {
        services[service] = answer
    }

    private fun hear(connection: WebSocket, operation: JsonObject) {
        heard += operation
        val topic = operation.text("topic").orEmpty()
        when (operation.text("op")) {
            "subscribe" -> {
                val throttleMs = operation.text("throttle_rate")?.toLong() ?: 0
                val length = operation.text("queue_length")?.toInt() ?: 0
                subscriptions.compute(topic) { _, before -> Handler(connection, throttleMs, length, before?.sentNanos) }
            }
            "unsubscribe" -> subscriptions -= topic
            "publish" -> onPublish(topic, checkNotNull(operation.part("msg")))
            "call_service" -> call(connection, operation)
            "send_action_goal" -> onGoal(operation)
        }
    }

    private fun call(connection: WebSocket, operation: JsonObject) {
        val service = operation.text("service").orEmpty()
        val (worked, values) = services[service]?.invoke(operation.part("args") ?: JsonObject(emptyMap()))
            ?: (false to JsonPrimitive("Service $service does not exist"))
        val id = operation.text("id")
        connection.send(operation("service_response", "id" to id, "service" to service, "values" to values, "result" to worked))
    }

    fun publish(topic: String, message: String) {
        subscriptions[topic]?.handle("""{"op":"publish","topic":"$topic","msg":$message}""")
    }

    fun say(text: String) = server.connections.forEach { it.send(text) }

    fun sayBytes(bytes: ByteArray) = server.connections.forEach { it.send(bytes) }

    /** Returns the throttle interval in ms and the queue length of each subscribed topic. */
    fun subscribed(): Map<String, Pair<Long, Int>> = subscriptions.mapValues { (_, it) -> it.throttleMs to it.length }

    fun heard(op: String): List<JsonObject> = heard.filter { it.text("op") == op }

    override fun close() {
        server.stop(0)
        timer.shutdownNow()
    }

    private inner class Handler(val connection: WebSocket, val throttleMs: Long, val length: Int, var sentNanos: Long?) {
        private val queue = ArrayDeque<String>()

        private fun remainingNanos() =
            sentNanos?.let { it + TimeUnit.MILLISECONDS.toNanos(throttleMs) - System.nanoTime() }?.coerceAtLeast(0) ?: 0

        @Synchronized
        fun handle(message: String) {
            if (length == 0) {
                if (throttleMs == 0L || remainingNanos() == 0L) send(message)
                return
            }
            queue.addLast(message)
            if (queue.size > length) queue.removeFirst() else if (queue.size == 1) schedule()
        }

        @Synchronized
        private fun sendNext() {
            queue.removeFirstOrNull()?.let(::send)
            if (queue.isNotEmpty()) schedule()
        }

        private fun schedule() = timer.schedule(::sendNext, remainingNanos(), TimeUnit.NANOSECONDS)

        private fun send(message: String) {
            sentNanos = System.nanoTime()
            if (connection.isOpen) connection.send(message)
        }
    }
}
