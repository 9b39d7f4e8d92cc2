package argo.sensing

import argo.jason.NetworkBoard
import argo.platform.TestTime
import argo.ports.OpenPort
import argo.ports.PortOptions
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import javino.Link
import javino.PerceptsRequest
import javino.PortException
import javino.PortTimeoutException
import javino.Protocol
import javino.sim.FakeBoard

/** What sensing makes of a board that does not answer any more. */
class UnansweredRequestsSpec : FunSpec({
    val time = TestTime()
    val events = ArrayList<String>()
    val listener = object : SensingListener {
        override fun request(port: OpenPort) = PerceptsRequest.ALL
        override fun received(port: OpenPort, message: String, receivedNanos: Long) = events.plusAssign("received")
        override fun unanswered(port: OpenPort, trouble: PortTimeoutException) = events.plusAssign("unanswered")
        override fun lost(port: OpenPort, trouble: PortException) = events.plusAssign("lost: ${trouble.message}")
    }
    val options = PortOptions(timeoutMs = 20).run { copy(link = link.withBootMillis(0).withProtocol(Protocol.V1).withBaud(1_000_000)) }

    fun onPort(name: String, work: (OpenPort) -> Unit) = Link.open(name, options.link, "bob").use { link ->
        events.clear()
        work(OpenPort(emptyMap(), link, options, 0, 0, "bob", listener, time))
    }

    fun OpenPort.exchangeUntil(event: String) {
        do sensing.exchange() while (events.last() != event) // a busy machine may be slower than a time limit
    }

    test("in a network one that used to answer is taken to have vanished after ten seconds") {
        NetworkBoard().use { board ->
            onPort(board.port) { port ->
                port.exchangeUntil("received")
                board.isMute = true
                port.exchangeUntil("unanswered")
                time.pass(9_000)
                port.sensing.exchange() shouldBe true
                time.pass(2_000)
                port.sensing.exchange() shouldBe false
                events.last() shouldContain "has not answered for 10 s"
            }
        }
    }

    test("one that has never answered, or answers now and then, is not") {
        NetworkBoard().use { board ->
            onPort(board.port) { port ->
                board.isMute = true
                repeat(3) {
                    port.sensing.exchange() shouldBe true
                    time.pass(60_000)
                }
                board.isMute = false
                port.exchangeUntil("received")
                board.isMute = true
                repeat(5) {
                    port.exchangeUntil("unanswered")
                    time.pass(9_000)
                    board.isMute = false
                    port.exchangeUntil("received")
                    board.isMute = true
                }
                events.filter { it.startsWith("lost") }.shouldBeEmpty()
            }
        }
    }

    test("on a serial line one that is silent is silent: opening its port anew would reset it") {
        FakeBoard.plugIn("silence").use { board ->
            onPort(board.port()) { port ->
                port.exchangeUntil("received")
                board.whenAsked(PerceptsRequest.ALL).staySilent()
                repeat(3) {
                    port.exchangeUntil("unanswered")
                    time.pass(60_000)
                }
                events.filter { it.startsWith("lost") }.shouldBeEmpty()
            }
        }
    }
})
