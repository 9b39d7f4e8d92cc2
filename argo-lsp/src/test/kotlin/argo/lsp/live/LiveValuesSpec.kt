package argo.lsp.live

import com.sun.net.httpserver.HttpServer
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainExactly
import java.net.InetAddress
import java.net.InetSocketAddress
import java.net.Socket
import java.time.Duration

class LiveValuesSpec : FunSpec({
    val server = HttpServer.create(InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0)
    val port = server.address.port
    server.createContext("/robot/events") { exchange ->
        exchange.sendResponseHeaders(200, 0)
        val state = """{"sensors": {"percepts": [{"text": "dist(front,38)", "ageMs": 12}, {"text": "dist(9)", "ageMs": 1}]},
            "beliefs": {"beliefs": [{"text": "led(on)"}]}}""".replace("\n", "")
        exchange.responseBody.write("retry: 1000\n\ndata: $state\n\n".toByteArray())
        exchange.responseBody.flush() // the stream stays open, like that of a view
    }
    server.start()
    afterSpec { server.stop(0) }
    val values = LiveValues(Duration.ofSeconds(20))

    test("percepts come with their ages, and beliefs where no percept has the functor") {
        values.of(port, "robot", "dist", 2) shouldContainExactly listOf("dist(front,38), 12 ms ago")
        values.of(port, "robot", "led", 1) shouldContainExactly listOf("led(on)")
    }

    test("an agent that has no page, or does not run, has no values") {
        values.of(port, "other", "dist", 2).shouldBeEmpty()
        Socket().use { silent -> // no other program can listen at this port
            silent.bind(null)
            values.of(silent.localPort, "robot", "dist", 2).shouldBeEmpty()
        }
    }
})
