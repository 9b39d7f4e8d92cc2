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
 * A bridge of the rosbridge protocol with a robot behind it, at this computer's own address. This bridge knows only the parts of the
 * protocol for the topics `/sonar` and `/cmd_vel`, and for the ROS 1 action `/dock`.
 */
internal class TurtleBridge(private val turtle: Turtle) : AutoCloseable {
    private val throttleMs = ConcurrentHashMap<WebSocket, Long>() // the least time between messages, by subscriber of the sonar
    private val sentNanos = ConcurrentHashMap<WebSocket, Long>()
    private val goals = ConcurrentHashMap<String, WebSocket>()
    private val started = CompletableFuture<Unit>()
    private val timer = Executors.newSingleThreadScheduledExecutor { Thread(it, "turtle").apply { isDaemon = true } }

    private val server = object : WebSocketServer(InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 1) {
        override fun onOpen(client: WebSocket, handshake: ClientHandshake) = Unit

        override fun onClose(client: WebSocket, code: Int, reason: String, remote: Boolean) {
            throttleMs -= client
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
        server.start()
        started.get(START_S, TimeUnit.SECONDS)
        timer.scheduleAtFixedRate(::step, STEP_MS, STEP_MS, TimeUnit.MILLISECONDS)
    }

    /** The bridge's port in an agent's notation. */
    val port: String get() = "ros://127.0.0.1:${server.port}"

    private fun hear(client: WebSocket, operation: JsonObject) {
        val message = operation["msg"] as? JsonObject
        when (operation.text("op") to operation.text("topic")) {
            "subscribe" to "/sonar" -> throttleMs[client] = operation.text("throttle_rate")?.toLong() ?: 0
            "unsubscribe" to "/sonar" -> throttleMs -= client
            "publish" to "/cmd_vel" -> turtle.drive((message?.get("linear") as? JsonObject)?.number("x") ?: 0.0)
            "publish" to "/dock/goal" -> (message?.get("goal_id") as? JsonObject)?.text("id")?.let { dock(it, client) }
            "publish" to "/dock/cancel" -> message?.text("id")?.let { if (goals.remove(it) != null) turtle.drive(0.0) }
            else -> if (operation.text("op") == "call_service") refuse(client, operation)
        }
    }

    private fun refuse(client: WebSocket, operation: JsonObject) {
        val answer = mapOf(
            "op" to JsonPrimitive("service_response"), "id" to JsonPrimitive(operation.text("id")), "result" to JsonPrimitive(false),
            "values" to JsonPrimitive("Service ${operation.text("service")} does not exist"),
        )
        client.send("${JsonObject(answer)}")
    }

    private fun dock(goal: String, client: WebSocket) {
        goals[goal] = client
        turtle.drive(-HOMEWARDS)
    }

    private fun step() {
        val now = System.nanoTime()
        for ((client, ms) in throttleMs) {
            val isDue = sentNanos[client]?.let { now - it >= TimeUnit.MILLISECONDS.toNanos(ms) } != false
            if (!isDue || !client.isOpen) continue
            sentNanos[client] = now
            client.send("""{"op":"publish","topic":"/sonar","msg":{"range":${turtle.range},"min_range":0.02,"max_range":4.0}}""")
        }
        if (goals.isNotEmpty() && turtle.position == 0.0) arrive()
    }

    private fun arrive() {
        turtle.drive(0.0)
        for ((goal, client) in goals) {
            goals -= goal
            if (client.isOpen) client.send(
                """{"op":"publish","topic":"/dock/result","msg":{"status":{"goal_id":{"id":"$goal"},"status":$SUCCEEDED,"text":""}}}""",
            )
        }
    }

    override fun close() {
        timer.shutdownNow()
        server.stop(0)
    }

    private companion object {
        const val START_S = 10L
        const val STEP_MS = 10L
        const val HOMEWARDS = 1.0

        // actionlib_msgs/GoalStatus
        const val SUCCEEDED = 3

        fun JsonObject.text(name: String) = (this[name] as? JsonPrimitive)?.content

        fun JsonObject.number(name: String) = (this[name] as? JsonPrimitive)?.doubleOrNull
    }
}
