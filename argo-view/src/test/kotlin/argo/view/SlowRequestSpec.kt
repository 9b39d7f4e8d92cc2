package argo.view

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import java.net.Socket
import java.util.concurrent.CompletableFuture
import java.util.concurrent.atomic.AtomicLong
import kotlin.concurrent.thread

class SlowRequestSpec : FunSpec({
    fun threads(agent: String) = Thread.getAllStackTraces().keys.count { it.name.startsWith("argo-$agent-view-") }

    listOf(
        "a header" to "GET / HT",
        "a body" to "POST /filter HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Type: application/json\r\nContent-Length: 100\r\n\r\n{",
    ).forEach { (what, begin) ->
        test("requests with $what that does not end do not keep pages out for good, and are given up sooner while others wait") {
            val now = AtomicLong()
            val agent = "slow-${what.length}"
            val server = ViewServer(agent, 0, Routes(Nobody), Broadcast(4), now::get)
            thread(isDaemon = true) { server.start() }.join()
            val unfinished = List(24) { Socket(server.address.host, server.address.port).apply { getOutputStream().write(begin.toByteArray()) } }
            try {
                eventually({ "${threads(agent)} threads" }) { threads(agent) == unfinished.size }
                now.set(RequestThreads.MAX_WAIT_NANOS / 5)
                val page = CompletableFuture.supplyAsync { server.address.get("/").statusCode() }
                eventually({ "no page" }) {
                    server.closeStalled()
                    page.isDone
                }
                page.get() shouldBe 200
            } finally {
                unfinished.forEach(Socket::close)
                server.stop()
            }
        }
    }

    test("a browser that watches for long is not given up as a request that does not end") {
        val now = AtomicLong()
        val pages = Broadcast(4)
        val server = ViewServer("long", 0, Routes(Nobody), pages, now::get)
        thread(isDaemon = true) { server.start() }.join()
        try {
            Socket(server.address.host, server.address.port).use { browser ->
                browser.getOutputStream().write("GET /events HTTP/1.0\r\nHost: ${server.address.authority}\r\n\r\n".toByteArray())
                val lines = browser.getInputStream().bufferedReader()
                while (lines.readLine() != "retry: 1000") Unit // it is let in
                now.set(2 * RequestThreads.MAX_WAIT_NANOS)
                server.closeStalled()
                val told = CompletableFuture.supplyAsync { generateSequence(lines::readLine).first { it.startsWith("data") } }
                eventually({ "it is told nothing" }) {
                    pages.publish("1", isLast = false) // again, since it is sent only what is published after it was let in
                    told.isDone
                }
                told.get() shouldBe "data: 1"
            }
        } finally {
            server.stop()
        }
    }
})
