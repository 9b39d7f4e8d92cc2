package argo.view

import io.kotest.assertions.nondeterministic.eventually
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import java.net.Socket
import java.util.concurrent.CompletableFuture
import java.util.concurrent.CountDownLatch
import java.util.concurrent.atomic.AtomicLong
import kotlin.concurrent.thread

class SlowRequestSpec : FunSpec({
    fun threads(agent: String) = Thread.getAllStackTraces().keys.count { it.name.startsWith("argo-$agent-view-") }

    listOf(
        "a header" to "GET / HT",
        "a body" to "POST /bob/filter HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Type: application/json\r\nContent-Length: 100\r\n\r\n{",
    ).forEach { (what, begin) ->
        test("requests with $what that does not end do not keep pages out for good, and are given up sooner while others wait") {
            val now = AtomicLong()
            val agent = "slow-${what.length}"
            val server = ViewServer(agent, 0, now::get).apply { site.add(AgentPage(Nobody)) }
            thread(isDaemon = true) { server.start() }.join()
            val unfinished = List(24) { Socket(server.address.host, server.address.port) }
            unfinished.forEach { it.getOutputStream().write(begin.toByteArray()) }
            try {
                eventually(LIMIT) { threads(agent) shouldBe unfinished.size }
                now.set(RequestThreads.MAX_WAIT_NANOS / 5)
                val page = CompletableFuture.supplyAsync { server.address.get("/bob/").statusCode() }
                eventually(LIMIT) {
                    server.closeStalled()
                    page.isDone shouldBe true
                }
                page.get() shouldBe 200
            } finally {
                unfinished.forEach(Socket::close)
                server.closePort()
                server.endThreads()
            }
        }
    }

    test("a request that has come whole may take long, as that of a page that watches does") {
        val now = AtomicLong()
        val threads = RequestThreads("long", now::get)
        val hasCome = CountDownLatch(1)
        val isOver = CountDownLatch(1)
        val served = CompletableFuture<Boolean>()
        threads.execute {
            threads.stopWaiting()
            hasCome.countDown()
            served.complete(runCatching { isOver.await() }.isSuccess)
        }
        hasCome.await()
        now.set(2 * RequestThreads.MAX_WAIT_NANOS)
        threads.interruptStalled()
        isOver.countDown()
        served.get() shouldBe true
        threads.stop()
    }
})
