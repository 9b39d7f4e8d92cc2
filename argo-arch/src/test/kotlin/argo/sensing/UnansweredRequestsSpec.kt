package argo.sensing

import argo.connecting.OpenPort
import argo.connecting.PortOptions
import argo.jason.NetworkBoard
import argo.links.BoardMessage
import argo.links.JavinoLink
import argo.platform.TestTime
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import javino.PerceptsRequest
import javino.PortException
import javino.PortTimeoutException
import javino.Protocol
import javino.link.Link
import javino.sim.FakeBoard

private const val MOST_EXCHANGES = 1000

class UnansweredRequestsSpec : FunSpec({
    val time = TestTime()
    val events = ArrayList<String>()
    lateinit var sensing: Sensing
    val listener = object : SensingListener {
        override val intervalMs get() = 50
        override fun isSensed(port: OpenPort) = true
        override fun request(port: OpenPort) = PerceptsRequest.ALL
        override fun mayReport(port: OpenPort) = false
        override fun received(port: OpenPort, message: BoardMessage, askedNanos: Long) = events.plusAssign("received")
        override fun unanswered(port: OpenPort, trouble: PortTimeoutException) = events.plusAssign("unanswered")
        override fun answeredAgain(port: OpenPort) = Unit
        override fun lost(port: OpenPort, trouble: PortException) = events.plusAssign("lost: ${trouble.message}")
    }
    val options = PortOptions(timeoutMs = 20).run { copy(link = link.withBootMillis(0).withProtocol(Protocol.V1).withBaud(1_000_000)) }

    fun onPort(name: String, work: (Sensing) -> Unit) = JavinoLink(Link.open(name, options.link, "bob")).use { link ->
        events.clear()
        OpenPort(emptyMap(), link, options, 0, 0) { port ->
            Sensing(port, "bob", listener, time).also { sensing = it }
        }
        work(sensing)
    }

    fun Sensing.exchangeUntil(event: String) {
        repeat(MOST_EXCHANGES) { // on a busy machine an answer may be late
            exchange()
            if (events.last() == event) return
        }
        error("no $event in $MOST_EXCHANGES exchanges: $events")
    }

    test("in a network one that used to answer is taken to have vanished after ten seconds") {
        NetworkBoard().use { board ->
            onPort(board.port) { sensing ->
                sensing.exchangeUntil("received")
                board.isMute = true
                sensing.exchangeUntil("unanswered")
                time.pass(9_000)
                sensing.exchange() shouldBe true
                time.pass(2_000)
                sensing.exchange() shouldBe false
                events.last() shouldContain "has not answered for 10 s"
            }
        }
    }

    test("one that has never answered, or answers now and then, is not") {
        NetworkBoard().use { board ->
            onPort(board.port) { sensing ->
                board.isMute = true
                repeat(3) {
                    sensing.exchange() shouldBe true
                    time.pass(60_000)
                }
                board.isMute = false
                sensing.exchangeUntil("received")
                board.isMute = true
                repeat(5) {
                    sensing.exchangeUntil("unanswered")
                    time.pass(9_000)
                    board.isMute = false
                    sensing.exchangeUntil("received")
                    board.isMute = true
                }
                events.filter { it.startsWith("lost") }.shouldBeEmpty()
            }
        }
    }

    test("on a serial line one that is silent is silent: opening its port anew would reset it") {
        FakeBoard.plugIn("silence").use { board ->
            onPort(board.port()) { sensing ->
                sensing.exchangeUntil("received")
                board.whenAsked(PerceptsRequest.ALL).staySilent()
                repeat(3) {
                    sensing.exchangeUntil("unanswered")
                    time.pass(60_000)
                }
                events.filter { it.startsWith("lost") }.shouldBeEmpty()
            }
        }
    }
})
