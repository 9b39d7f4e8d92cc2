package samples.turtle

import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.doubleOrNull
import kotlinx.serialization.json.jsonObject
import org.java_websocket.WebSocket
import org.java_websocket.handshake.ClientHandshake
import org.java_websocket.server.WebSocketServer
import java.net.InetAddress
import java.net.InetSocketAddress
import java.util.concurrent.CompletableFuture
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.Executors
import java.util.concurrent.TimeUnit

/**
 * Simulates a rosbridge server with turtlesim on this computer. The server has the topics `/NAME/pose` and `/NAME/cmd_vel` of each turtle,
 * and the service `/spawn`. Only the necessary parts of the protocol are supported.
 */
internal class TurtleBridge(private val nanos: () -> Long = System::nanoTime) : AutoCloseable {
    private data class Subscription(val client: WebSocket, val topic: String)

    private val throttleMs = ConcurrentHashMap<Subscription, Long>() // the shortest time between two messages
    private val sentNanos = ConcurrentHashMap<Subscription, Long>()
    private val turtles = ConcurrentHashMap<String, Turtle>()
    private val started = CompletableFuture<Unit>()
    private val timer = Executors.newSingleThreadScheduledExecutor { Thread(it, "turtlesim").apply { isDaemon = true } }

    private val server = object : WebSocketServer(InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 1) {
        override fun onOpen(client: WebSocket, handshake: ClientHandshake) = Unit

        override fun onClose(client: WebSocket, code: Int, reason: String, remote: Boolean) {
            throttleMs.keys.removeIf { it.client == client }
        }

        override fun onMessage(client: WebSocket, message: String) = hear(client, Json.parseToJsonElement(message).jsonObject)

        override fun onError(client: WebSocket?, trouble: Exception) {
            if (client == null) started.completeExceptionally(trouble)
        }

        override fun onStart() {
            started.complete(Unit)
        }
    }.apply { isDaemon = true }

    init {
        spawn(Turtle.WINDOW / 2, Turtle.WINDOW / 2, 0.0)
        server.start()
        started.get(START_S, TimeUnit.SECONDS)
        timer.scheduleAtFixedRate(::publish, STEP_MS, STEP_MS, TimeUnit.MILLISECONDS)
    }

    /** The name of the bridge's port for agents. */
    val port: String get() = "ros://127.0.0.1:${server.port}"

    val turtle: Turtle get() = turtles.getValue("turtle1")

    private fun spawn(x: Double, y: Double, heading: Double): String =
        "turtle${turtles.size + 1}".also { turtles[it] = Turtle(x, y, heading, nanos) }

    private fun hear(client: WebSocket, operation: JsonObject) {
        val topic = operation.text("topic").orEmpty()
        when (operation.text("op")) {
            "subscribe" -> throttleMs[Subscription(client, topic)] = operation.text("throttle_rate")?.toLong() ?: 0
            "unsubscribe" -> throttleMs -= Subscription(client, topic)
            "publish" -> if (topic.endsWith("/cmd_vel")) drive(topic.split('/')[1], operation["msg"] as? JsonObject ?: return)
            "call_service" -> answer(client, operation)
        }
    }

    private fun drive(name: String, twist: JsonObject) {
        fun part(name: String, axis: String) = (twist[name] as? JsonObject)?.number(axis) ?: 0.0
        turtles[name]?.drive(part("linear", "x"), part("angular", "z"))
    }

    private fun answer(client: WebSocket, operation: JsonObject) {
        val service = operation.text("service")
        val request = operation["args"] as? JsonObject ?: JsonObject(emptyMap())
        val isKnown = service == "/spawn"
        val values = if (isKnown) {
            val name = spawn(request.number("x") ?: 0.0, request.number("y") ?: 0.0, request.number("theta") ?: 0.0)
            JsonObject(mapOf("name" to JsonPrimitive(name)))
        } else {
            JsonPrimitive("Service $service does not exist")
        }
        val answer = mapOf(
            "op" to JsonPrimitive("service_response"), "id" to JsonPrimitive(operation.text("id")), "result" to JsonPrimitive(isKnown),
            "values" to values,
        )
        client.send("${JsonObject(answer)}")
    }

    private fun publish() {
        val now = System.nanoTime()
        for ((one, ms) in throttleMs) {
            val turtle = turtles[one.topic.split('/').getOrNull(1)].takeIf { one.topic.endsWith("/pose") } ?: continue
            val isDue = sentNanos[one]?.let { now - it >= TimeUnit.MILLISECONDS.toNanos(ms) } != false
            if (!isDue || !one.client.isOpen) continue
            sentNanos[one] = now
            val (x, y, heading, speed, turn) = turtle.pose
            val pose = """{"x":$x,"y":$y,"theta":$heading,"linear_velocity":$speed,"angular_velocity":$turn}"""
            one.client.send("""{"op":"publish","topic":"${one.topic}","msg":$pose}""")
        }
    }

    override fun close() {
        timer.shutdownNow()
        server.stop(0)
    }

    private companion object {
        const val START_S = 10L
        const val STEP_MS = 10L

        fun JsonObject.text(name: String) = (this[name] as? JsonPrimitive)?.content

        fun JsonObject.number(name: String) = (this[name] as? JsonPrimitive)?.doubleOrNull
    }
}
