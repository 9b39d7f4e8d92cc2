package argo.view.timeline

import argo.view.HttpResponse
import argo.view.RequestGate
import argo.view.Site
import argo.view.begin
import com.sun.net.httpserver.HttpExchange
import com.sun.net.httpserver.HttpServer
import kotlinx.serialization.KSerializer
import kotlinx.serialization.Serializable
import kotlinx.serialization.builtins.ListSerializer
import kotlinx.serialization.json.Json
import java.io.IOException
import java.net.InetAddress
import java.net.InetSocketAddress
import java.net.URI
import java.util.concurrent.Executors

/**
 * Serves the page of [timeline] to browsers on this computer, and what it draws in pieces.
 *
 * @param name of the recording, for its title
 * @param problems what of the recording cannot be read
 * @param port 0 to 65535; 0: any that is free
 * @throws IOException if the port cannot be had
 */
internal class TimelineServer(
    private val timeline: Timeline,
    private val name: String,
    private val problems: List<String>,
    port: Int,
) : AutoCloseable {
    private val threads = Executors.newFixedThreadPool(THREADS) { work -> Thread(work, "argo-timeline").apply { isDaemon = true } }
    private val server = HttpServer.create(InetSocketAddress(InetAddress.getByName("127.0.0.1"), port), 0)

    /** Where browsers find it. */
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
            else -> responseTo(path, parametersOf(requestURI.query.orEmpty()))
        }
        begin(response.status, response.type, response.body.size.toLong())
        responseBody.use { it.write(response.body) }
    }

    private fun responseTo(path: String, parameters: Map<String, String>): HttpResponse = when (path) {
        "/" -> Site.file("timeline.html", "text/html")
        "/view.css" -> Site.file("view.css", "text/css")
        "/timeline.css" -> Site.file("timeline.css", "text/css")
        "/timeline.js" -> Site.file("timeline.js", "text/javascript")
        "/recording" -> json(Contents.serializer(), Contents(name, timeline.agents, timeline.seconds, timeline.items.size, problems))
        "/items" -> items(parameters)
        "/item" -> item(parameters)
        else -> HttpResponse.message(404, "there is nothing here; the timeline is at /")
    }

    private fun items(parameters: Map<String, String>): HttpResponse {
        val from = parameters["from"]?.toDoubleOrNull()?.takeIf { it.isFinite() }
        val until = parameters["until"]?.toDoubleOrNull()?.takeIf { it.isFinite() }
        if (from == null || until == null || until <= from) {
            return HttpResponse.message(400, "from and until are seconds, as in /items?from=0&until=10")
        }
        val most = parameters["most"]?.toIntOrNull()?.coerceIn(1, MOST_ITEMS) ?: MOST_ITEMS
        return json(ListSerializer(LanePart.serializer()), timeline.between(from, until, most))
    }

    /** The item `id`, or that before or after it, with what it is linked with. */
    private fun item(parameters: Map<String, String>): HttpResponse {
        val id = parameters["id"]?.toIntOrNull()
        val wanted = when (parameters["beside"]) {
            null -> id
            "after" -> id?.let { timeline.beside(it, isAfter = true) }
            else -> id?.let { timeline.beside(it, isAfter = false) }
        }
        val related = wanted?.let { timeline.related(it, MOST_RELATED) } ?: return HttpResponse.message(404, "there is no such item")
        return json(Related.serializer(), related)
    }

    private fun <T> json(serializer: KSerializer<T>, value: T) =
        HttpResponse(200, HttpResponse.JSON, Json.encodeToString(serializer, value).toByteArray())

    private fun parametersOf(query: String) =
        query.split('&').filter { '=' in it }.associate { it.substringBefore('=') to it.substringAfter('=') }

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

    /** Gives the port back. */
    override fun close() {
        server.stop(0)
        threads.shutdownNow()
    }

    @Serializable
    private class Contents(val name: String, val agents: List<String>, val seconds: Double, val items: Int, val problems: List<String>)

    private companion object {
        const val THREADS = 4
        const val MOST_ITEMS = 2_000
        const val MOST_RELATED = 300
    }
}
