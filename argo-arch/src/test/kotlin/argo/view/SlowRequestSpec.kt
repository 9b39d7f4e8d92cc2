package argo.view

import argo.jason.eventually
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import java.net.Socket
import java.util.concurrent.CompletableFuture
import java.util.concurrent.atomic.AtomicLong
import kotlin.concurrent.thread

private const val LIMIT_NANOS = 10_000_000_000L

class SlowRequestSpec : FunSpec({
    fun threads(agent: String) = Thread.getAllStackTraces().keys.count { it.name.startsWith("argo-$agent-view-") }

    test("requests that are begun and never ended do not keep pages out for good") {
        val now = AtomicLong()
        val server = ViewServer("slow", 0, ViewCommands(Nobody), Browsers(4, now::get), Newest(), now::get)
        thread(isDaemon = true) { server.start() }.join()
        val unfinished = List(24) { Socket(server.address.host, server.address.port).apply { getOutputStream().write("GET / HT".toByteArray()) } }
        try {
            eventually({ "${threads("slow")} threads" }) { threads("slow") == unfinished.size }
            now.set(2 * LIMIT_NANOS)
            val page = CompletableFuture.supplyAsync { server.address.get("/").statusCode() }
            eventually({ "no page" }) {
                server.giveUpSlow(LIMIT_NANOS)
                page.isDone
            }
            page.get() shouldBe 200
        } finally {
            unfinished.forEach(Socket::close)
            server.stop()
        }
    }

    test("a browser that watches for long is not given up as a slow request") {
        val now = AtomicLong()
        val browsers = Browsers(4, now::get)
        val states = Newest<ViewServer.Sent>()
        val server = ViewServer("long", 0, ViewCommands(Nobody), browsers, states, now::get)
        thread(isDaemon = true) { server.start() }.join()
        try {
            Socket(server.address.host, server.address.port).use { browser ->
                browser.getOutputStream().write("GET /events HTTP/1.0\r\nHost: ${server.address.authority}\r\n\r\n".toByteArray())
                val lines = browser.getInputStream().bufferedReader()
                while (lines.readLine() != "retry: 1000") Unit // it is let in
                now.set(2 * LIMIT_NANOS)
                server.giveUpSlow(LIMIT_NANOS)
                states.say(ViewServer.Sent("1", isLast = true))
                generateSequence(lines::readLine).last { it.isNotEmpty() } shouldBe "data: 1"
            }
        } finally {
            server.stop()
        }
    }
})
