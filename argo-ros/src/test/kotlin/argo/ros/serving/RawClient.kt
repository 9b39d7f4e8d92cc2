package argo.ros.serving

import argo.ros.LIMIT
import argo.ros.bridge.operationIn
import argo.ros.bridge.text
import io.kotest.assertions.nondeterministic.eventually
import io.kotest.matchers.nulls.shouldNotBeNull
import kotlinx.serialization.json.JsonObject
import java.net.URI
import java.net.http.HttpClient
import java.net.http.WebSocket
import java.util.concurrent.CompletionStage
import java.util.concurrent.ConcurrentLinkedQueue
import java.util.concurrent.TimeUnit

/** A client that sends anything to the WebSocket [address]. */
internal class RawClient(address: URI, headers: Map<String, String> = emptyMap()) : WebSocket.Listener, AutoCloseable {
    /** The operations that have come. */
    val heard = ConcurrentLinkedQueue<JsonObject>()

    @Volatile
    var isClosed = false
    private val text = StringBuilder()
    private val socket: WebSocket = HTTP.newWebSocketBuilder().apply { headers.forEach { (name, value) -> header(name, value) } }
        .buildAsync(address, this).get(20, TimeUnit.SECONDS)

    constructor(port: Int) : this(URI("ws://127.0.0.1:$port/"))

    fun send(text: String) {
        socket.sendText(text, true).get(20, TimeUnit.SECONDS)
    }

    /** Waits for the first operation [op]. */
    suspend fun await(op: String): JsonObject {
        var found: JsonObject? = null
        eventually(LIMIT) { found = heard.find { it.text("op") == op }.shouldNotBeNull() }
        return checkNotNull(found).also { heard -= it }
    }

    override fun onText(webSocket: WebSocket, data: CharSequence, last: Boolean): CompletionStage<*>? {
        text.append(data)
        if (last) {
            heard += checkNotNull(operationIn("$text"))
            text.setLength(0)
        }
        webSocket.request(1)
        return null
    }

    override fun onClose(webSocket: WebSocket, statusCode: Int, reason: String): CompletionStage<*>? {
        isClosed = true
        return null
    }

    override fun onError(webSocket: WebSocket, error: Throwable) {
        isClosed = true
    }

    override fun close() = socket.abort()

    private companion object {
        val HTTP: HttpClient = HttpClient.newHttpClient()
    }
}
