package argo.view.timeline

import argo.view.HttpResponse
import argo.view.localServer
import argo.view.parametersOf
import argo.view.refusal
import argo.view.send
import argo.view.uri
import com.sun.net.httpserver.HttpExchange
import java.io.IOException
import java.net.URI
import java.nio.file.Path
import java.util.concurrent.Executors

/**
 * Serves the page of [timeline], and the parts that the page draws, to browsers on this computer.
 *
 * @param files the recordings; their names are the title
 * @param problems the parts of the recording that cannot be read
 * @param port 0 to 65535; 0 for any free port
 * @throws IOException if the port cannot be opened
 */
internal class TimelineServer(
    timeline: Timeline,
    files: List<Path>,
    problems: List<String>,
    port: Int,
) : AutoCloseable {
    private val routes = TimelineRoutes(timeline, files.joinToString { "${it.fileName}" }, problems, ToldWhy { ask -> ask(files) })
    private val threads = Executors.newFixedThreadPool(THREADS) { work -> Thread(work, "argo-timeline").apply { isDaemon = true } }
    private val server = localServer(port, threads, ::handle)

    val address: URI = server.uri

    init {
        server.start()
    }

    private fun handle(exchange: HttpExchange) {
        val uri = exchange.requestURI
        val refusal = exchange.refusal(uri.path.orEmpty())
        val response = when {
            refusal != null -> HttpResponse.message(403, refusal)
            exchange.requestMethod != "GET" -> HttpResponse.wrongMethod("GET")
            else -> routes.respond(uri.path.orEmpty(), parametersOf(uri.rawQuery))
        }
        exchange.send(response)
    }

    override fun close() {
        server.stop(0)
        threads.shutdownNow()
    }

    private companion object {
        const val THREADS = 4
    }
}
