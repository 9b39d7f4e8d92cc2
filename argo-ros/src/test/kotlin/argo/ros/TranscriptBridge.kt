package argo.ros

import argo.ros.bridge.operationIn
import argo.ros.bridge.part
import argo.ros.bridge.text
import kotlinx.serialization.json.JsonObject
import org.java_websocket.WebSocket
import org.java_websocket.handshake.ClientHandshake
import org.java_websocket.server.WebSocketServer
import java.net.InetAddress
import java.net.InetSocketAddress
import java.util.concurrent.CountDownLatch
import java.util.concurrent.Executors
import java.util.concurrent.TimeUnit

/**
 * Replays the bridge's side of a transcript, which `src/test/ros/record.py` writes. An operation of the client gets the recorded answers,
 * after the recorded times. Operations that are not in the transcript get no answer.
 */
internal class TranscriptBridge(transcript: String) : AutoCloseable {
    /** An operation of the client, and the bridge's answers with their delays in ms. */
    private class Exchange(val operation: JsonObject, val atMs: Long) {
        val answers = ArrayList<Pair<Long, String>>()
        var isOver = false
    }

    private val exchanges = exchangesOf(checkNotNull(javaClass.getResource("/transcripts/$transcript.jsonl")).readText())
    private val started = CountDownLatch(1)
    private val timer = Executors.newSingleThreadScheduledExecutor { Thread(it, "transcript-timer").apply { isDaemon = true } }

    private val server = object : WebSocketServer(InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 1) {
        override fun onOpen(connection: WebSocket, handshake: ClientHandshake) = Unit

        override fun onClose(connection: WebSocket, code: Int, reason: String, remote: Boolean) = Unit

        override fun onMessage(connection: WebSocket, message: String) = answer(connection, checkNotNull(operationIn(message)))

        override fun onError(connection: WebSocket?, trouble: Exception) = Unit

        override fun onStart() = started.countDown()
    }.apply {
        isReuseAddr = true
        isDaemon = true
        isTcpNoDelay = true
        start()
    }

    init {
        check(started.await(60, TimeUnit.SECONDS)) { "the bridge does not start" }
    }

    val number: Int get() = server.port

    private fun exchangesOf(transcript: String): List<Exchange> {
        val exchanges = ArrayList<Exchange>()
        for (line in transcript.lines().filter { it.isNotBlank() }.map { checkNotNull(operationIn(it)) }) {
            val ms = line.text("ms")!!.toLong()
            val operation = line.part("message")!!
            if (line.text("from") == "client") exchanges += Exchange(operation, ms)
            else exchanges.last { isCause(it.operation, operation) }.let { it.answers += ms - it.atMs to "$operation" }
        }
        return exchanges
    }

    private fun isCause(operation: JsonObject, answer: JsonObject): Boolean {
        if (answer.text("op") == "service_response") return operation.text("id") == answer.text("id")
        val goal = answer.part("msg")?.part("status")?.part("goal_id")?.text("id") ?: return isSubscriptionTo(operation, answer)
        return idOf(operation) == goal // the goal itself, or its cancellation, which has the goal's id
    }

    private fun isSubscriptionTo(operation: JsonObject, answer: JsonObject) =
        operation.text("op") == "subscribe" && operation.text("topic") == answer.text("topic")

    private fun idOf(operation: JsonObject): String? {
        val message = operation.part("msg") ?: return operation.text("id")
        return message.part("goal_id")?.text("id") ?: message.text("id")
    }

    @Synchronized
    private fun answer(connection: WebSocket, operation: JsonObject) {
        val exchange = exchanges.find { !it.isOver && withoutIds(it.operation) == withoutIds(operation) } ?: return
        exchange.isOver = true
        val id = idOf(operation)
        val recorded = idOf(exchange.operation)
        for ((ms, text) in exchange.answers) {
            val answer = if (id == null) text else text.replace("\"$recorded\"", "\"$id\"")
            timer.schedule({ if (connection.isOpen) connection.send(answer) }, ms, TimeUnit.MILLISECONDS)
        }
    }

    /** Returns [operation] without its ids, which differ in each run. */
    private fun withoutIds(operation: JsonObject): JsonObject =
        JsonObject(operation - "id" + listOfNotNull(operation.part("msg")?.let { "msg" to JsonObject(it - "goal_id" - "id") }))

    override fun close() {
        server.stop(0)
        timer.shutdownNow()
    }
}
