package argo.view

import com.sun.net.httpserver.HttpExchange
import com.sun.net.httpserver.HttpServer
import java.io.IOException
import java.net.InetAddress
import java.net.InetSocketAddress
import java.net.URI

/**
 * Serves one agent's view to browsers on this computer.
 *
 * The port is taken when this is made. [start] is to be called by a daemon thread, since the server's own takes after it.
 *
 * @param agent its name, for the threads'
 * @param port 0 to 65535; 0: any that is free
 * @param commands answers what the page's buttons ask for
 * @param browsers those that watch
 * @param states what they are shown, as JSON; nothing follows one that [isLast]
 * @param nanos a clock in ns that never goes back
 * @throws IOException if the port cannot be had
 */
internal class ViewServer(
    agent: String,
    port: Int,
    private val commands: ViewCommands,
    private val browsers: Browsers,
    private val states: Newest<Sent>,
    nanos: () -> Long = System::nanoTime,
) {
    private val server = HttpServer.create(InetSocketAddress(InetAddress.getByName("127.0.0.1"), port), 0)
    private val threads = RequestThreads(agent, nanos)

    init {
        server.executor = threads
        server.createContext("/") { exchange -> exchange.use(::handle) }
    }

    /** Where browsers find it. */
    val address: URI = URI("http://127.0.0.1:${server.address.port}/")

    /** Begins to serve. */
    fun start() = server.start()

    /** Ends all connections and threads. */
    fun stop() {
        server.stop(0)
        threads.stop()
    }

    /** Gives up requests that have not come whole for [limitNanos] ns, or a tenth of it while others wait for their turn. */
    fun giveUpUnfinished(limitNanos: Long) = threads.giveUpUnfinished(limitNanos)

    private fun handle(exchange: HttpExchange) {
        val body = exchange.requestBody.readNBytes(ViewCommands.MOST_BYTES + 1)
        threads.received()
        val path = exchange.requestURI.path.orEmpty()
        val headers = exchange.requestHeaders
        val refusal = RequestGate.refusal(headers.getFirst("Host"), headers.getFirst("Origin"), headers.getFirst("Sec-Fetch-Site"), path == "/")
        val file = ViewFile.of(path)
        when {
            refusal != null -> exchange.answer(Answer.said(403, refusal))
            path == EVENTS -> if (exchange.requestMethod == "GET") stream(exchange) else exchange.answer(Answer.wrongMethod("GET"))
            file != null -> exchange.answer(if (exchange.requestMethod == "GET") file.answer() else Answer.wrongMethod("GET"))
            else -> exchange.answer(commands.answer(exchange.requestMethod, path, exchange.requestURI.rawQuery, headers.getFirst("Content-Type"), body))
        }
    }

    private fun stream(exchange: HttpExchange) {
        val isAdmitted = browsers.admit { browser ->
            exchange.begin(200, "text/event-stream", 0)
            val out = exchange.responseBody
            browser.write { out.write("retry: $RETRY_MS\n\n".toByteArray()) }
            var number = states.count // what was said last is of another time
            var isLast = false
            while (!isLast) {
                val sent = states.await(number, HEARTBEAT_NANOS)
                number = sent?.number ?: number
                isLast = sent?.value?.isLast == true
                browser.write {
                    out.write((sent?.let { "data: ${it.value.json}\n\n" } ?: ":\n\n").toByteArray()) // JSON has no line breaks
                    out.flush()
                }
            }
        }
        if (!isAdmitted) exchange.answer(Answer.said(503, "too many pages show this agent already; close one and load this one again"))
    }

    private fun HttpExchange.answer(answer: Answer) {
        answer.allow?.let { responseHeaders.add("Allow", it) }
        begin(answer.status, answer.type, answer.body.size.toLong())
        responseBody.use { it.write(answer.body) } // before what is left of a long request is read
    }

    private fun HttpExchange.begin(status: Int, type: String, length: Long) {
        HEADERS.forEach { (name, value) -> responseHeaders.add(name, value) }
        responseHeaders.add("Content-Type", "$type; charset=utf-8")
        sendResponseHeaders(status, length)
    }

    /** Serves the exchange with [handle], and drops the connection of a browser that has gone or has been given up. */
    private fun HttpExchange.use(handle: (HttpExchange) -> Unit) {
        try {
            handle(this)
        } catch (_: IOException) {
            // the browser has gone: nobody is left to tell
        } catch (_: InterruptedException) {
            // the view is being closed
        } finally {
            close()
        }
    }

    /** What the browsers are sent: [json], in one line. */
    class Sent(val json: String, val isLast: Boolean)

    companion object {
        private const val EVENTS = "/events"

        /** How long a browser whose connection is lost waits before it tries again. */
        private const val RETRY_MS = 1000

        /** How often a browser is written to at least, so that one which has gone is noticed, in ns. */
        private const val HEARTBEAT_NANOS = 2_000_000_000L
        private val HEADERS = mapOf(
            "Cache-Control" to "no-store",
            "Content-Security-Policy" to "default-src 'none'; script-src 'self'; style-src 'self'; connect-src 'self'; img-src data:; base-uri 'none'; form-action 'none'; frame-ancestors 'none'",
            "Referrer-Policy" to "no-referrer",
            "X-Content-Type-Options" to "nosniff",
            "X-Frame-Options" to "DENY",
        )
    }
}
