package argo.view

import argo.filters.PerceptionFilter
import argo.observing.CommandFailure
import argo.observing.ObservedAgent
import argo.observing.ObservedPort
import argo.observing.Order
import argo.observing.Outcome
import argo.observing.WatchedRule
import io.kotest.assertions.nondeterministic.eventually
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import jason.asSemantics.Circumstance
import jason.asSemantics.TransitionSystem
import jason.bb.BeliefBase
import jason.bb.DefaultBeliefBase
import javino.PerceptKind
import javino.link.SendOptions
import javino.wire.BoardAction
import java.net.InetSocketAddress
import java.net.Socket
import java.util.concurrent.atomic.AtomicLong
import java.util.logging.Logger
import kotlin.concurrent.thread

private val LARGE = "\"" + "x".repeat(1_000_000) + "\""

class StalledBrowserSpec : FunSpec({
    test("a browser that has not taken what was written to it for too long is given up") {
        val now = AtomicLong()
        val page = AgentPage(Nobody)
        val pages = page.states
        val server = ViewServer("bob", 0, now::get).apply { site.add(page) }
        thread(isDaemon = true) { server.start() }.join()
        try {
            Socket().use { browser ->
                browser.receiveBufferSize = 1024
                browser.connect(InetSocketAddress("127.0.0.1", server.address.port))
                browser.getOutputStream().write("GET /bob/events HTTP/1.1\r\nHost: ${server.address.authority}\r\n\r\n".toByteArray())
                eventually(LIMIT) { pages.isWatched shouldBe true }
                eventually(LIMIT) {
                    pages.publish(LARGE, isLast = false)
                    now.addAndGet(RequestThreads.MAX_WAIT_NANOS / 100)
                    server.closeStalled()
                    pages.isWatched shouldBe false
                }
            }
        } finally {
            server.closePort()
            server.endThreads()
        }
    }

    test("a browser that takes what is written to it is not given up, however long it watches") {
        val now = AtomicLong()
        val threads = RequestThreads("bob", now::get)
        threads.waiting { now.set(RequestThreads.MAX_WAIT_NANOS) }
        now.set(10 * RequestThreads.MAX_WAIT_NANOS)
        threads.interruptStalled()
        Thread.interrupted() shouldBe false
    }

    test("an interrupt that comes too late does not hit what the thread does next") {
        val now = AtomicLong()
        val threads = RequestThreads("bob", now::get)
        threads.waiting {
            now.set(2 * RequestThreads.MAX_WAIT_NANOS)
            threads.interruptStalled()
        }
        Thread.interrupted() shouldBe false
    }
})

internal object Nobody : ObservedAgent {
    override val name = "bob"
    override val policy = "fresh"
    override val intervalMs = 50
    override val skewMs: Long? = null
    override val isPerceiving = false
    override val beliefs: BeliefBase = DefaultBeliefBase()
    override val circumstance = Circumstance()
    override val reasoning: TransitionSystem get() = throw UnsupportedOperationException()
    override val printed: Logger = Logger.getLogger("argo.view.test.nobody")
    override val pausing = Pauses()
    override val actions: List<BoardAction>? = null
    override fun act(command: String, options: SendOptions, done: (CommandFailure?) -> Unit) = done(null)
    override fun nanos() = System.nanoTime()
    override fun ports() = emptyList<ObservedPort>()
    override fun perceptKinds(portName: String) = emptyList<PerceptKind>()
    override fun filterNames() = emptyList<String>()
    override fun filter(name: String): PerceptionFilter? = throw UnsupportedOperationException()
    override fun explain(percept: String) = percept
    override fun criticalRules() = emptyList<WatchedRule>()
    override fun perceiveThrough(filter: PerceptionFilter?, done: () -> Unit) = done()
    override fun perceive(open: Boolean, done: () -> Unit) = done()
    override fun order(order: Order, done: (Outcome) -> Unit) = done(Outcome(null))
    override fun reload(done: (Outcome) -> Unit) = done(Outcome(null))
    override fun sources() = emptyList<java.nio.file.Path>()
    override fun wake() = Unit
    override fun wakeUntil(seen: () -> Boolean) = Unit
}
