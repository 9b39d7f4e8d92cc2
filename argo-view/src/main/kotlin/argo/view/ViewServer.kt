package argo.view

import com.sun.net.httpserver.HttpExchange
import java.io.IOException
import java.net.URI
import java.util.concurrent.Semaphore
import java.util.concurrent.atomic.AtomicBoolean

/**
 * Serves the views of agents to browsers on this computer. The constructor opens the port. Call [start] on a daemon thread, since otherwise
 * the server's own thread is no daemon.
 *
 * @param name the beginning of the threads' names
 * @param port 0 to 65535; 0 for any free port
 * @param nanos a clock in ns that never goes back
 * @throws IOException if the port cannot be opened
 */
internal class ViewServer(name: String, port: Int, nanos: () -> Long = System::nanoTime) {
    val site = Site()
    private val freePages = Semaphore(MAX_PAGES) // of all agents
    private val isStarted = AtomicBoolean()
    private val threads = RequestThreads(name, nanos)
    private val server = localServer(port, threads, ::handle)

    val address: URI = server.uri

    fun start() {
        if (!isStarted.getAndSet(true)) server.start()
    }

    /** Frees the port and ends all connections. Returns at once. Called once. */
    fun closePort() = server.stop(0)

    /** Ends all threads. Called after [closePort]. */
    fun endThreads() = threads.stop()

    /** Closes the connections of clients that take too long, see [RequestThreads.interruptStalled]. */
    fun closeStalled() = threads.interruptStalled()

    private fun handle(exchange: HttpExchange) {
        val uri = exchange.requestURI
        val body = exchange.requestBody.readNBytes(Route.MAX_BYTES + 1)
        threads.stopWaiting()
        val found = site.find(uri.rawPath.orEmpty())
        val request = Request(exchange.requestMethod, found.path, uri.rawQuery, exchange.requestHeaders.getFirst("Content-Type"), body)
        val refusal = exchange.refusal(request.path)
        when {
            refusal != null -> exchange.respond(HttpResponse.message(403, refusal))
            found.page == null -> exchange.respond(site.respond(request))
            request.path != EVENTS -> exchange.respond(found.page.routes.respond(request))
            request.method != "GET" -> exchange.respond(HttpResponse.wrongMethod("GET"))
            !freePages.tryAcquire() -> exchange.respond(FULL)
            else -> try {
                stream(exchange, found.page.states)
            } finally {
                freePages.release()
            }
        }
    }

    private fun stream(exchange: HttpExchange, states: Broadcast) {
        fun write(text: String) = threads.waiting {
            exchange.responseBody.write(text.toByteArray())
            exchange.responseBody.flush()
        }
        states.serve(
            begin = {
                exchange.begin(200, "text/event-stream", 0)
                write("retry: $RETRY_MS\n\n")
            },
            send = { json -> write(if (json == null) ":\n\n" else "data: $json\n\n") }, // JSON has no line breaks
            end = { threads.waiting(exchange.responseBody::close) }, // without its last chunk, a response counts as cut off
        )
    }

    private fun HttpExchange.respond(response: HttpResponse) = threads.waiting { send(response) }

    private companion object {
        const val EVENTS = "/events"
        const val MAX_PAGES = 12

        val FULL = HttpResponse.message(503, "too many pages are open; close one and load this one again")

        /** If a browser has lost its connection, it tries again after this time, in ms. */
        const val RETRY_MS = 1000
    }
}
