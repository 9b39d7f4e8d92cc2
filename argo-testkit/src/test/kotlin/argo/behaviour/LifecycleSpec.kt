package argo.behaviour

import argo.Arch
import argo.testkit.agentOf
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import jason.architecture.AgArch
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds

/** When a test closes its agents, it checks that no thread is left. */
class LifecycleSpec : FunSpec({
    test("an agent that is killed while a command waits leaves nothing") {
        agentOf("!start.\n+!start <- argo.port(ttyACM0); argo.percepts(open); argo.act(front).") { board.hangs() }.use { bob ->
            bob.after(100.milliseconds).shouldIntend("start").board.isOpen shouldBe true
            bob.stops().after(10.milliseconds).board.isOpen shouldBe false
            bob.mas.time.living().filter { it.startsWith("argo-") }.shouldBeEmpty()
            bob.shouldSendNothingElse()
        }
    }

    test("an agent that is killed while a port is being opened leaves nothing") {
        agentOf("!start.\n+!start <- argo.port(ttyACM0); .print(open).") { board.opensAfter(5.seconds) }.use { bob ->
            bob.after(1.seconds).shouldIntend("start").stops().after(10.seconds).board.isOpen shouldBe false
            bob.mas.time.living().shouldBeEmpty()
            bob.printed.shouldBeEmpty()
        }
    }

    test("argo.port(none) gives all ports back and nothing is believed of them") {
        agentOf("""
            !start.
            +!start <- argo.port(left, [boot(0)]); argo.act(hello); argo.port(right, [boot(0)]); argo.act(hello).
            +!leave <- argo.port(none); +closed.
            +port(P,off) <- .print("off: ", P).
        """).use { bob ->
            bob.shouldSend("hello").shouldSend("hello").shouldBelieve("port(left,on) & port(right,on)")
            listOf("left", "right").map { bob.board(it).isOpen } shouldBe listOf(true, true)
            bob.hears("user", "achieve", "leave").shouldBelieve("closed").after(200.milliseconds).beliefs shouldBe listOf("closed")
            listOf("left", "right").map { bob.board(it).isOpen } shouldBe listOf(false, false)
            bob.printed.shouldBeEmpty()
        }
    }

    test("every snapshot reaches an agent whose sensing policy is every") {
        agentOf("""
            seen(0).
            !start.
            +!start <- argo.port(ttyACM0, [baud(1000000)]); argo.limit(0); argo.percepts(open).
            @c[atomic] +count(N) : seen(M) & N > 1 & N \== M+1 & M > 0 <- .print("missed from ", M, " to ", N); -+seen(N).
            @d[atomic] +count(N) : N < 200 <- -+seen(N).
            +count(200) <- argo.percepts(block); argo.act(done).
        """) {
            options("argo_sensing" to "every")
            var n = 0
            board.shows { listOf("count(${++n})") }
        }.use { bob -> bob.shouldSend("done", within = 20.seconds).printed.shouldBeEmpty() }
    }

    test("in_cycle asks inside the reasoning cycle, says so, and no other thread senses or acts") {
        agentOf("""
            !start.
            +!start <- argo.port(ttyACM0); argo.limit(5); argo.percepts(open).
            +count(5) <- argo.act(done).
        """) {
            options("argo_sensing" to "in_cycle")
            var n = 0
            board.shows { listOf("count(${++n})") }
        }.use { bob ->
            bob.shouldSend("done", within = 5.seconds).mas.time.living().filter { "sensing" in it || "acting" in it }.shouldBeEmpty()
            bob.log.joinToString("\n") shouldContain "for comparison only"
        }
    }

    test("a policy that does not exist, or an option that does not, is reported and the agent works with the default") {
        agentOf("!start.\n+!start <- argo.port(ttyACM0, [boot(0)]); argo.act(ok).") {
            options("argo_sensing" to "freshest", "argo_speed" to "9")
        }.use { bob ->
            val log = bob.shouldSend("ok").log.joinToString("\n")
            log shouldContain "argo_sensing=freshest: a policy is one of fresh, every, in_cycle; fresh is used"
            log shouldContain "argo_speed is not an option of argo.Arch"
        }
    }

    test("an architecture behind it is stopped once where the first one alone is told, as on JADE") {
        val behind = object : AgArch() {
            var stops = 0

            override fun stop() {
                stops++
                super.stop()
            }
        }
        behind.insertAgArch(Arch())
        behind.firstAgArch.stop()
        behind.stops shouldBe 1
    }
})
