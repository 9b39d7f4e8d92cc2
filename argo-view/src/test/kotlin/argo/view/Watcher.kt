package argo.view

import kotlinx.serialization.json.Json
import java.net.URI
import java.net.http.HttpClient
import java.net.http.HttpRequest
import java.net.http.HttpResponse
import java.util.concurrent.LinkedBlockingQueue
import java.util.concurrent.TimeUnit
import kotlin.concurrent.thread

/** A browser without a window. A separate thread reads the states that the page at [address] receives. */
internal class Watcher(address: URI) : AutoCloseable {
    private val unread = LinkedBlockingQueue<ViewState>()
    private val stream = java.net.Socket(address.host, address.port)

    /** The received text, unchanged. */
    val sent = StringBuffer()

    private val reader = thread(isDaemon = true, name = "watcher") {
        try {
            stream.getOutputStream().write("GET ${address.rawPath}events HTTP/1.0\r\nHost: ${address.authority}\r\n\r\n".toByteArray())
            stream.getInputStream().bufferedReader().forEachLine(::read)
        } catch (_: java.io.IOException) {
            // the test has closed the stream
        }
    }

    private fun read(line: String) {
        sent.append(line).append('\n')
        if (line.startsWith("data: ")) unread.put(Json.decodeFromString(ViewState.serializer(), line.removePrefix("data: ")))
    }

    /** Reads states until [condition] holds for one, and returns this state. */
    fun await(condition: (ViewState) -> Boolean): ViewState {
        val deadline = System.nanoTime() + TimeUnit.SECONDS.toNanos(DEADLINE_S)
        var last: ViewState? = null
        while (true) {
            val state = unread.poll(deadline - System.nanoTime(), TimeUnit.NANOSECONDS)
                ?: throw AssertionError("not so within $DEADLINE_S s: $last; sent: ${sent.takeLast(500)}")
            if (condition(state)) return state
            last = state
        }
    }

    /** Waits until the server has closed the connection. */
    fun awaitEnd() = check(reader.join(java.time.Duration.ofSeconds(DEADLINE_S))) { "still open after $DEADLINE_S s" }

    override fun close() = stream.close()

    private companion object {
        const val DEADLINE_S = 60L
    }
}

private fun Thread.join(limit: java.time.Duration): Boolean {
    join(limit.toMillis())
    return !isAlive
}

private val client: HttpClient = HttpClient.newHttpClient() // follows no redirects

/** Returns the answer to GET [path]. If [path] has no slash at its beginning, it belongs to a page. */
internal fun URI.get(path: String): HttpResponse<String> =
    client.send(HttpRequest.newBuilder(resolve(path)).build(), HttpResponse.BodyHandlers.ofString())

/** Returns the answer to POST [path] with [json]. [headers] are sent in addition to the headers of the page. */
internal fun URI.post(path: String, json: String, vararg headers: Pair<String, String>): HttpResponse<String> {
    val request = HttpRequest.newBuilder(resolve(path)).header("Content-Type", "application/json")
        .POST(HttpRequest.BodyPublishers.ofString(json))
    headers.forEach { (name, value) -> request.setHeader(name, value) }
    return client.send(request.build(), HttpResponse.BodyHandlers.ofString())
}

/** Returns the first line of the answer to a request with exactly the lines of [head]. */
internal fun URI.raw(vararg head: String): String = java.net.Socket(host, port).use { socket ->
    socket.getOutputStream().write((head.joinToString("\r\n") + "\r\n\r\n").toByteArray())
    socket.getInputStream().bufferedReader().readLine()
}
