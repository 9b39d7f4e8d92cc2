package argo.view.timeline

import argo.view.HttpResponse
import argo.view.RequestGate
import argo.view.begin
import com.sun.net.httpserver.HttpExchange
import com.sun.net.httpserver.HttpServer
import java.io.IOException
import java.net.InetAddress
import java.net.InetSocketAddress
import java.net.URI
import java.nio.file.Path
import java.util.concurrent.Executors

/**
 * Serves the page of [timeline], and the pieces that it draws, to browsers on this computer.
 *
 * @param file the recording; its name is the title
 * @param problems the parts of the recording that cannot be read
 * @param port 0 to 65535; 0: any that is free
 * @throws IOException if the port cannot be had
 */
internal class TimelineServer(
    timeline: Timeline,
    file: Path,
    problems: List<String>,
    port: Int,
) : AutoCloseable {
    private val routes = TimelineRoutes(timeline, "${file.fileName}", problems, ToldWhy { ask -> ask(file) })
    private val threads = Executors.newFixedThreadPool(THREADS) { work -> Thread(work, "argo-timeline").apply { isDaemon = true } }
    private val server = HttpServer.create(InetSocketAddress(InetAddress.getByName("127.0.0.1"), port), 0)

    /** Its address for browsers. */
    val address: URI = URI("http://127.0.0.1:${server.address.port}/")

    init {
        server.executor = threads
        server.createContext("/") { exchange -> exchange.use { it.respond() } }
        server.start()
    }

    private fun HttpExchange.respond() {
        val path = requestURI.path.orEmpty()
        val (host, origin, fetchSite) = listOf("Host", "Origin", "Sec-Fetch-Site").map(requestHeaders::getFirst)
        val refusal = RequestGate.refusal(host, origin, fetchSite, isPage = path == "/")
        val response = when {
            refusal != null -> HttpResponse.message(403, refusal)
            requestMethod != "GET" -> HttpResponse.wrongMethod("GET")
            else -> routes.respond(path, parametersOf(requestURI.rawQuery))
        }
        begin(response.status, response.type, response.body.size.toLong())
        responseBody.use { it.write(response.body) }
    }

    /** Serves the exchange with [handle], and drops the connection of a browser that has gone. */
    private fun HttpExchange.use(handle: (HttpExchange) -> Unit) {
        try {
            handle(this)
        } catch (_: IOException) {
            // the browser has gone
        } finally {
            close()
        }
    }

    /** Frees the port. */
    override fun close() {
        server.stop(0)
        threads.shutdownNow()
    }

    private companion object {
        const val THREADS = 4
    }
}
