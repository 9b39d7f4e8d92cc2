package argo.lsp.live

import com.sun.net.httpserver.HttpServer
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import java.io.IOException
import java.net.InetAddress
import java.net.InetSocketAddress
import java.net.Socket
import java.time.Duration
import java.util.concurrent.CountDownLatch
import java.util.concurrent.TimeUnit

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
    val isCut = CountDownLatch(1)
    server.createContext("/camera/events") { exchange ->
        exchange.sendResponseHeaders(200, 0)
        try {
            while (true) exchange.responseBody.write(ByteArray(1000)) // a picture without end, and no line
        } catch (_: IOException) {
            isCut.countDown()
        }
    }
    server.createContext("/page/events") { exchange ->
        exchange.sendResponseHeaders(200, 0)
        exchange.responseBody.use { it.write("data: {reload\n\n".toByteArray()) }
    }
    server.start()
    afterSpec { server.stop(0) }
    val values = LiveValues(Duration.ofSeconds(20))

    test("percepts come with their ages, and beliefs where no percept has the functor") {
        values.of(port, "robot", "dist", 2) shouldContainExactly listOf("dist(front,38), 12 ms ago")
        values.of(port, "robot", "led", 1) shouldContainExactly listOf("led(on)")
    }

    test("another program at the port has no values, and is not read for ever") {
        LiveValues(Duration.ofMillis(300)).of(port, "camera", "dist", 2).shouldBeEmpty()
        isCut.await(20, TimeUnit.SECONDS) shouldBe true
        values.of(port, "page", "dist", 2).shouldBeEmpty()
    }

    test("an agent that has no page, or does not run, has no values") {
        values.of(port, "other", "dist", 2).shouldBeEmpty()
        Socket().use { silent -> // no other program can listen at this port
            silent.bind(null)
            values.of(silent.localPort, "robot", "dist", 2).shouldBeEmpty()
        }
    }
})
