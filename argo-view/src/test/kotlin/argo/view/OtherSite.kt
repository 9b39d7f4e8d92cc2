package argo.view

import com.sun.net.httpserver.HttpServer
import java.net.InetAddress
import java.net.InetSocketAddress
import java.net.URI

/** A web page of another origin that runs [script]. */
internal class OtherSite(script: String) : AutoCloseable {
    private val server = HttpServer.create(InetSocketAddress(InetAddress.getByName("127.0.0.1"), 0), 0)

    val address: URI = URI("http://localhost:${server.address.port}/")

    init {
        val page = "<!DOCTYPE html><body><script>$script</script></body>".toByteArray()
        server.createContext("/") { exchange ->
            exchange.responseHeaders.add("Content-Type", "text/html")
            exchange.sendResponseHeaders(200, page.size.toLong())
            exchange.responseBody.use { it.write(page) }
        }
        server.start()
    }

    override fun close() = server.stop(0)
}
