package argo.behaviour

import argo.testkit.agentOf
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainAll
import io.kotest.matchers.collections.shouldNotContain
import io.kotest.matchers.ints.shouldBeLessThanOrEqual
import io.kotest.matchers.shouldBe
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds

class ReturningSpec : FunSpec({
    test("commands that wait when the cable is pulled fail, and those given while it is out") {
        agentOf("""
            !start.
            +!start <- argo.port(ttyACM0, [baud(300), protocol(1), boot(0)]); for (.range(I,1,20)) { !!send(I) }.
            +!send(I) <- argo.act(takes_a_second_or_so(I)).
            -!send(I)[error(E)] <- +failed(I,E).
            +port(P,off) <- !!send(21).
            +port(P,on) : failed(20,_) & failed(21,_) <- argo.act(back).
        """).use { bob ->
            bob.shouldSend("takes_a_second_or_so(1)", within = 2.seconds).after(500.milliseconds).board.disconnects()
            bob.shouldBelieve("failed(21,port_gone)").beliefs shouldContainAll (3..20).map { "failed($it,port_gone)" }
            bob.beliefs shouldNotContain "failed(1,port_gone)"
            bob.board.reconnects()
            bob.shouldSend("back", within = 5.seconds).shouldSendNothingElse()
        }
    }

    test("the policy in_cycle notices a pulled cable and its return while nothing is asked of the board") {
        agentOf("!start.\n+!start <- argo.port(ttyACM0); +open.\n+!greet <- argo.act(hello).") {
            options("argo_sensing" to "in_cycle")
        }.use { bob ->
            bob.shouldBelieve("open").board.disconnects()
            bob.shouldBelieve("port(ttyACM0,off)").board.reconnects()
            bob.shouldBelieve("port(ttyACM0,on)", within = 3.seconds)
            bob.hears("user", "achieve", "greet").shouldSend("hello", within = 5.seconds)
        }
    }

    test("a pulled cable and its return leave no more lines in the log than changes of state, and no threads") {
        agentOf("""
            !start.
            +!start <- argo.port(ttyACM0, [baud(115200)]); argo.limit(5); argo.percepts(open).
            +seen(X) <- argo.act(saw(X)).
        """).use { bob ->
            val threads = bob.perceives("seen(0)").shouldSend("saw(0)").mas.time.living().size
            repeat(20) {
                bob.perceives("seen(a$it)").shouldSend("saw(a$it)").board.disconnects()
                bob.shouldBelieve("port(ttyACM0,off)", within = 100.milliseconds).board.reconnects()
                bob.shouldBelieve("port(ttyACM0,on)", within = 1.seconds)
            }
            bob.perceives("seen(last)").shouldSend("saw(last)").log.count { "port ttyACM0 is " in it } shouldBeLessThanOrEqual 41
            bob.mas.time.living().size shouldBe threads
        }
    }
})
