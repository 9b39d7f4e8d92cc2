package argo.testkit

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds

class CommandsSpec : FunSpec({
    fun worker(port: String, setUp: AgentSetUp.() -> Unit = {}) = agentOf("""
        !start.
        +!start <- argo.port(ttyACM0, [$port]).
        +!do(W) <- argo.act(W); .print(done(W)).
        -!do(W)[error(E)] <- .print(failed(W,E)).
        +!do(W,Options) <- argo.act(W,Options); .print(done(W)).
        -!do(W,_)[error(E)] <- .print(failed(W,E)).
    """, setUp).after(500.milliseconds)

    fun TestAgent.isTo(vararg goals: String) = apply { goals.forEach { hears("user", "achieve", it) } }

    test("of commands that wait for a slow line the urgent one goes first, and one whose time is over never goes") {
        worker("baud(300), protocol(1), boot(0)").use { agent ->
            agent.isTo("do(slow)", "do(late,[timeout(100)])", "do(patient,[timeout(5000)])", "do(first,[urgent])")
            agent.after(200.milliseconds).printed shouldBe listOf("failed(late,act_timeout)")
            agent.after(5.seconds).sent shouldBe listOf("slow", "first", "patient")
            agent.printed shouldBe listOf("failed(late,act_timeout)", "done(slow)", "done(first)", "done(patient)")
        }
    }

    test("a command whose time is over while it is on its way is unconfirmed, and those behind it go out") {
        worker("protocol(2)") { board.version2().takes(2.seconds, "drive") }.use { agent ->
            agent.isTo("do(drive,[timeout(300)])", "do(ledOn)").after(290.milliseconds).printed.shouldBeEmpty()
            agent.after(20.milliseconds).printed shouldBe listOf("failed(drive,act_unconfirmed)")
            agent.shouldSend("drive").shouldSend("ledOn", within = 3.seconds)
            agent.isTo("do(ledOff,[timeout(5000)])").shouldPrint("done(ledOff)").sent shouldBe listOf("drive", "ledOn", "ledOff")
        }
    }

    test("commands fail, whatever their options, while the board hangs, and arrive again when it recovers") {
        worker("protocol(2)") { board.version2() }.use { agent ->
            agent.board.hangs()
            agent.isTo("do(a)", "do(b,[timeout(200)])")
            agent.shouldPrint("failed(b,act_unconfirmed)").shouldPrint("failed(a,act_unconfirmed)", within = 20.seconds)
            agent.board.recovers()
            agent.after(5.seconds).isTo("do(c)").shouldPrint("done(c)")
        }
    }

    test("a board refuses what it does not know until it is told to accept it") {
        worker("protocol(2)") { board.version2().refuses("fly").refuses { it.startsWith("swim") } }.use { agent ->
            agent.isTo("do(fly)").shouldPrint("failed(fly,act_refused)")
            agent.board.accepts("fly").accepts("swim(1)")
            agent.isTo("do(fly)").shouldPrint("done(fly)")
            agent.isTo("do(swim(1))").shouldPrint("done(swim(1))").isTo("do(swim(2))").shouldPrint("failed(swim(2),act_refused)")
        }
    }

    test("commands that wait fail when the cable is pulled, and the port is as it was when it is back") {
        worker("baud(300), protocol(1), boot(0)").use { agent ->
            agent.isTo("do(one)", "do(two)", "do(three)").after(50.milliseconds)
            agent.board.disconnects()
            agent.shouldBelieve("port(ttyACM0,off)").after(100.milliseconds).printed.sorted() shouldBe
                listOf("failed(one,port_gone)", "failed(three,port_gone)", "failed(two,port_gone)")
            agent.isTo("do(four)").shouldPrint("failed(four,port_gone)")
            agent.board.reconnects()
            // still at 300 baud
            agent.shouldBelieve("port(ttyACM0,on)", within = 3.seconds).isTo("do(five)").after(300.milliseconds).sent.shouldBeEmpty()
            agent.after(300.milliseconds).sent shouldBe listOf("five")
        }
    }
})
