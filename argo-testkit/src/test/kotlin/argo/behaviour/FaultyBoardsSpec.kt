package argo.behaviour

import argo.testkit.TestAgent
import argo.testkit.agentOf
import io.kotest.core.NamedTag
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.ints.shouldBeLessThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import kotlin.random.Random
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds

class FaultyBoardsSpec : FunSpec({
    fun TestAgent.shouldReason(goal: String) = hears("user", "achieve", "reach($goal)").shouldBelieve("reached($goal)", within = 0.seconds)

    test("a board that never answers is in timeout, gets its commands all the same, and does not hold its agent up") {
        agentOf("""
            !start.
            +!start <- argo.port(ttyACM0, [boot(500), timeout(50)]); argo.limit(5); argo.percepts(open); argo.act(hello).
            +!reach(G) <- +reached(G).
        """) { board.ignoresRequests() }.use { bob ->
            bob.shouldReason("at_once").shouldSend("hello", within = 5.seconds)
            bob.shouldBelieve("port(ttyACM0,timeout)").shouldReason("in_timeout")
            bob.log.count { "port ttyACM0 is " in it } shouldBe 2
        }
    }

    test("of a board that prints text in place of messages, the log shows the text and the likely cause") {
        agentOf("!start. +!start <- argo.port(ttyACM0, [protocol(1), boot(0), timeout(50)]); argo.percepts(open).") {
            board.ignoresRequests()
        }.use { bob ->
            bob.board.disturbs("dist(f,30);\r\n")
            bob.shouldBelieve("port(ttyACM0,timeout)")
            bob.log.single { "port ttyACM0 is timeout" in it || "gave no answer" in it } shouldContain
                "13 bytes came since the last message and are no message: \"dist(f,30);\\r\\n\", which is text without a frame"
        }
    }

    test("a board that says garbage all the time is in timeout, fills neither log nor beliefs, and does not hold its agent up") {
        val random = Random(4711)
        agentOf("""
            !start.
            +!start <- argo.port(ttyACM0, [baud(1000000), boot(100), timeout(50)]); argo.limit(0); argo.percepts(open).
            +!reach(G) <- +reached(G).
        """) { board.ignoresRequests() }.use { bob ->
            fun garbage() = bob.board.disturbs(String(random.nextBytes(256), Charsets.ISO_8859_1))
            repeat(100) { garbage(); bob.after(5.milliseconds) }
            bob.shouldBelieve("port(ttyACM0,timeout)")
            val before = bob.beliefs
            repeat(5) {
                bob.shouldReason("g$it")
                repeat(20) { garbage(); bob.after(5.milliseconds) }
            }
            bob.beliefs.filterNot { it.startsWith("reached(") } shouldBe before
            bob.log.size shouldBeLessThan 20
        }
    }

    test("an agent uses 127 boards in turn, each holding its port open, and a 128th is refused").config(tags = thorough) {
        agentOf("""
            +!greet(I,P) <- argo.port(P, [boot(0), baud(115200), protocol(1)]); argo.act(hello(I)); +greeted(I).
            -!greet(I,P)[error(E)] <- +refused(I,E).
        """).use { bob ->
            fun greet(i: Int, port: Int = i) = bob.hears("user", "achieve", "greet($i,port$port)")
            for (i in 0 until 127) {
                greet(i).shouldBelieve("greeted($i)")
                bob.board("port$i").commands shouldBe listOf("hello($i)")
            }
            greet(127).shouldBelieve("refused(127,too_many_ports)")
            (0..127).count { bob.board("port$it").isOpen } shouldBe 127
            greet(128, port = 0).shouldBelieve("greeted(128)").board("port0").commands shouldBe listOf("hello(0)", "hello(128)")
            bob.beliefs shouldContain "greeted(126)"
        }
    }
})

private val thorough = setOf(NamedTag("Thorough"))
