package argo.view

import com.sun.net.httpserver.HttpExchange
import com.sun.net.httpserver.HttpServer
import java.io.IOException
import java.net.InetAddress
import java.net.InetSocketAddress
import java.net.URI
import java.util.concurrent.Executor

/**
 * Makes a server for browsers on this computer. Drops a connection if its browser has gone or its thread was interrupted.
 *
 * @param port 0 to 65535; 0 for any free port
 * @param threads runs [handle] for each exchange
 * @throws IOException if the port cannot be opened
 */
internal fun localServer(port: Int, threads: Executor, handle: (HttpExchange) -> Unit): HttpServer {
    val server = HttpServer.create(InetSocketAddress(InetAddress.getByName("127.0.0.1"), port), 0)
    server.executor = threads
    server.createContext("/") { exchange ->
        try {
            handle(exchange)
        } catch (_: IOException) {
            // the browser has gone
        } catch (_: InterruptedException) {
            // the server is being closed, or has waited too long
        } finally {
            exchange.close()
        }
    }
    return server
}

internal val HttpServer.uri: URI get() = URI("http://127.0.0.1:${address.port}/")

/** Returns the reason for refusing a request for [path], in words; null if it is accepted. */
internal fun HttpExchange.refusal(path: String): String? {
    val (host, origin, fetchSite) = listOf("Host", "Origin", "Sec-Fetch-Site").map(requestHeaders::getFirst)
    return RequestOrigin.refusal(host, origin, fetchSite, isPage = path == "/")
}

internal fun HttpExchange.send(response: HttpResponse) {
    response.location?.let { responseHeaders.add("Location", it) }
    response.allow?.let { responseHeaders.add("Allow", it) }
    val body = if (requestMethod == "HEAD") ByteArray(0) else response.body // for HEAD, the server's library would log a warning
    begin(response.status, response.type, if (body.isEmpty()) -1 else body.size.toLong())
    responseBody.use { it.write(body) } // sent before the server reads the rest of a long request
}

/** Begins a response with [status], content of [type] and [length] bytes, see [HttpExchange.sendResponseHeaders]. */
internal fun HttpExchange.begin(status: Int, type: String, length: Long) {
    HEADERS.forEach { (name, value) -> responseHeaders.add(name, value) }
    responseHeaders.add("Content-Type", "$type; charset=utf-8")
    sendResponseHeaders(status, length)
}

private val HEADERS = mapOf(
    "Cache-Control" to "no-store",
    "Content-Security-Policy" to "default-src 'none'; script-src 'self'; style-src 'self'; connect-src 'self'; img-src data:; " +
        "base-uri 'none'; form-action 'none'; frame-ancestors 'none'",
    "Referrer-Policy" to "no-referrer",
    "X-Content-Type-Options" to "nosniff",
    "X-Frame-Options" to "DENY",
)
