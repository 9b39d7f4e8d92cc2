package argo.view

import argo.filters.PerceptionFilter
import argo.observing.ObservedAgent
import argo.observing.ObservedPort
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import jason.bb.BeliefBase
import jason.bb.DefaultBeliefBase
import java.net.InetSocketAddress
import java.net.Socket
import kotlin.concurrent.thread

private val LARGE = ViewServer.Sent("\"" + "x".repeat(1_000_000) + "\"", isLast = false)

class StalledBrowserSpec : FunSpec({
    test("a browser that has not taken what was written to it for too long is given up") {
        val browsers = Browsers(4, System::nanoTime)
        val states = Newest<ViewServer.Sent>()
        val server = ViewServer("bob", 0, ViewCommands(Nobody), browsers, states)
        thread(isDaemon = true) { server.start() }.join()
        try {
            Socket().use { browser ->
                browser.receiveBufferSize = 1024
                browser.connect(InetSocketAddress("127.0.0.1", server.address.port))
                browser.getOutputStream().write("GET /events HTTP/1.1\r\nHost: ${server.address.authority}\r\n\r\n".toByteArray())
                eventually({ "no browser" }) { browsers.areWatching() }
                repeat(20) { states.say(LARGE) }
                eventually({ "it still watches" }) {
                    states.say(LARGE)
                    browsers.giveUpStalled(50_000_000)
                    !browsers.areWatching()
                }
            }
        } finally {
            server.stop()
        }
    }

    test("a browser that is written to for a while is not given up") {
        var now = 0L
        val browsers = Browsers(4) { now }
        browsers.admit { browser ->
            browser.write { now = 10; browsers.giveUpStalled(20) }
            now = 100
            browsers.giveUpStalled(20)
        } shouldBe true
        Thread.interrupted() shouldBe false
    }
})

internal object Nobody : ObservedAgent {
    override val name = "bob"
    override val policy = "fresh"
    override val intervalMs = 50
    override val isPerceiving = false
    override val beliefs: BeliefBase = DefaultBeliefBase()
    override fun nanos() = System.nanoTime()
    override fun ports() = emptyList<ObservedPort>()
    override fun filterNames() = emptyList<String>()
    override fun filter(name: String): PerceptionFilter = throw UnsupportedOperationException()
    override fun explain(percept: String) = percept
    override fun perceiveThrough(filter: PerceptionFilter?, done: () -> Unit) = done()
    override fun perceive(open: Boolean, done: () -> Unit) = done()
    override fun wake() = Unit
}
