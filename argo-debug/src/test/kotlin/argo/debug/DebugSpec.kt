package argo.debug

import argo.testkit.TestAgent
import argo.testkit.agent
import io.kotest.assertions.nondeterministic.eventually
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldStartWith
import org.eclipse.lsp4j.debug.ContinueArguments
import org.eclipse.lsp4j.debug.NextArguments
import org.eclipse.lsp4j.debug.PauseArguments
import org.eclipse.lsp4j.debug.StepInArguments
import org.eclipse.lsp4j.debug.StepOutArguments
import java.net.InetAddress
import java.net.ServerSocket
import java.net.Socket
import java.util.concurrent.CompletableFuture
import java.util.concurrent.TimeUnit
import kotlin.io.path.writeText
import kotlin.time.Duration.Companion.minutes
import kotlin.time.Duration.Companion.seconds

class DebugSpec : FunSpec({
    val file = tempdir().toPath().toRealPath().resolve("bob.asl").apply { writeText(PROGRAM) }

    /** Runs [debug] with a debugger of Bob, on a separate thread, while Bob does [drive] in virtual time. */
    fun debugging(drive: TestAgent.() -> Unit, debug: Debugger.(port: Int) -> Unit) {
        agent(file) { options("argo_debug" to "0") }.use { bob ->
            val port = checkNotNull(Regex("debuggers reach bob at port (\\d+)").find(bob.log.joinToString("\n"))).groupValues[1].toInt()
            val isSet = CompletableFuture<Unit>()
            val end = CompletableFuture.runAsync {
                Debugger(port).use {
                    it.breakAt("$file", 4, 9, 99) shouldBe listOf("4", "9", "no plan or step is at line 99 or behind it")
                    it.configured()
                    isSet.complete(Unit)
                    it.debug(port)
                }
            }
            CompletableFuture.anyOf(isSet, end).get(1, TimeUnit.MINUTES)
            bob.drive()
            end.get(1, TimeUnit.MINUTES)
        }
    }

    test("a debugger sees the plans of an intention as frames, with variables, beliefs and other intentions") {
        debugging({ perceives("dist(f,38)").shouldSend("turn(38)").shouldSend("slow(38)") }) {
            val stop = stop()
            (stop.reason to stop.text) shouldBe ("breakpoint" to "the world stands still with it")
            val frames = frames(stop.threadId)
            frames.map { "${it.name} at ${it.source.path}:${it.line}" } shouldBe listOf("+dist(f,38) at $file:4")
            read(frames[0], "Variables") shouldBe listOf("X = 38")
            read(frames[0], "Beliefs") shouldContain "dist(f,38) = [source(percept)]"
            read(frames[0], "Beliefs") shouldContain "far(40) = [source(self)]"
            read(frames[0], "Intentions").single() shouldContain "+dist(f,38)"
            evaluate("X", frames[0]) shouldBe "38"
            evaluate("X + 2", frames[0]) shouldBe "40"
            evaluate("dist(f,D) & far(L) & D < L", frames[0]) shouldBe "D = 38, L = 40"
            evaluate("near", frames[0]) shouldBe "true"
            evaluate("dist(b,_)", frames[0]) shouldBe "false"
            evaluate(".print(X)", frames[0]) shouldStartWith ".print(X) is an internal action, which may act"
            evaluate("dist(", frames[0]) shouldStartWith "dist( is no formula"
            server.continue_(ContinueArguments().apply { threadId = stop.threadId }).value()
            val below = frames(stop().threadId)
            below.map { "${it.name}:${it.line}" } shouldBe listOf("+!turn(38):9", "+dist(f,38):5")
            evaluate("X", frames[0]) shouldBe "the agent has gone on since"
            disconnect()
        }
    }

    test("steps go over a goal, into it and out of it") {
        fun next(way: Debugger.(Int) -> Unit): Debugger.() -> Int = {
            val thread = stop().threadId
            frames(thread).first().line.also { way(thread) }
        }
        val over = next { server.next(NextArguments().apply { threadId = it }).value() }
        val into = next { server.stepIn(StepInArguments().apply { threadId = it }).value() }
        val out = next { server.stepOut(StepOutArguments().apply { threadId = it }).value() }
        debugging({ perceives("dist(f,38)").shouldSend("slow(38)") }) {
            breakAt("$file", 4)
            listOf(into(), into(), out(), over()) shouldBe listOf(4, 5, 9, 6)
            disconnect()
        }
        debugging({ perceives("dist(f,38)").shouldSend("slow(38)") }) {
            breakAt("$file", 4)
            listOf(over(), over(), over()) shouldBe listOf(4, 5, 6)
            disconnect()
        }
    }

    test("of a large belief base a part is shown, which is told") {
        debugging({ hears("boss", "achieve", "look").shouldBelieve("spot(600)").perceives("dist(f,38)").shouldSend("slow(38)") }) {
            val beliefs = read(frames(stop().threadId).first(), "Beliefs")
            beliefs.size shouldBe 501
            beliefs.last() shouldContain "more; ask for some by a formula, such as dist(_,X)"
            disconnect()
        }
    }

    test("an agent that is paused without an intention has a frame too, and one that runs answers nothing") {
        val isPaused = CompletableFuture<Unit>()
        debugging({ isPaused.get(1, TimeUnit.MINUTES); after(1.seconds).shouldNotSend("turn(38)") }) {
            said { frames(1).toString() } shouldBe "agent bob is not paused; pause it first"
            evaluate("far(_)") shouldBe "no agent is paused; pause one first"
            server.pause(PauseArguments().apply { threadId = 1 }).value()
            isPaused.complete(Unit)
            frames(stop().threadId).single().name shouldBe "no intention"
            evaluate("far(X)") shouldBe "X = 40"
            disconnect()
        }
    }

    test("breakpoints that a reload moves, or takes away, are told to the debugger") {
        val own = tempdir().toPath().toRealPath().resolve("bob.asl").apply { writeText(PROGRAM) }
        agent(own) { options("argo_debug" to "0") }.use { bob ->
            val port = bob.log.first { "debuggers reach bob" in it }.substringAfter("port ").substringBefore(" ").toInt()
            Debugger(port).use { debugger ->
                debugger.breakAt("$own", 5, 9) shouldBe listOf("5", "9")
                debugger.configured()
                own.writeText("\n" + PROGRAM.replace(Regex("(?s)\\+!turn.*turn\\(X\\)\\)\\."), ""))
                bob.hears("boss", "achieve", "renew")
                eventually(1.minutes) {
                    debugger.told shouldContain "changed 1: 6"
                    debugger.told shouldContain "changed 2: the plan of line 9 is gone"
                }
                debugger.disconnect()
            }
        }
    }

    test("a debugger that goes away leaves an agent that goes on, without its breakpoints") {
        debugging({ perceives("dist(f,38)").shouldSend("slow(38)").perceives("dist(f,30)").shouldSend("slow(30)") }) {
            stop()
            close()
        }
    }

    test("a debugger that only looks leaves an agent that another has paused") {
        agent(file) { options("argo_debug" to "0") }.use { bob ->
            val port = bob.log.first { "debuggers reach bob" in it }.substringAfter("port ").substringBefore(" ").toInt()
            val isOver = CompletableFuture.runAsync {
                Debugger(port).use { one ->
                    one.configured()
                    one.server.pause(PauseArguments().apply { threadId = 1 }).value()
                    one.stop()
                    Debugger(port).use {
                        it.configured()
                        it.stop()
                        it.disconnect()
                    }
                    one.frames(1).single().name shouldBe "no intention"
                    one.disconnect()
                }
            }
            while (!isOver.isDone) bob.after(1.seconds)
            isOver.get()
        }
    }

    test("whatever does not speak the protocol is refused, as a page in a browser is") {
        agent(file) { options("argo_debug" to "0") }.use { bob ->
            val port = bob.log.first { "debuggers reach bob" in it }.substringAfter("port ").substringBefore(" ").toInt()
            repeat(2) {
                Socket(InetAddress.getLoopbackAddress(), port).use {
                    it.getOutputStream().write("POST / HTTP/1.1\r\nContent-Length: 2\r\n\r\n{}".toByteArray())
                    it.getInputStream().read() shouldBe -1
                }
            }
            bob.perceives("dist(f,38)").shouldSend("slow(38)")
        }
    }

    test("a port that is none, or that is taken, is told, and the agent runs without") {
        agent(file) { options("argo_debug" to "wide") }.use { bob ->
            bob.log.joinToString("\n") shouldContain "argo_debug=wide: debuggers reach an agent at the number of a port from 0 to 65535"
            withClue("taken") {
                ServerSocket(0, 1, InetAddress.getLoopbackAddress()).use { taken ->
                    agent(file) { options("argo_debug" to "${taken.localPort}") }.use {
                        it.log.joinToString("\n") shouldContain "argo_debug=${taken.localPort}: port ${taken.localPort} cannot be had"
                    }
                }
            }
            bob.perceives("dist(f,38)").shouldSend("slow(38)")
        }
    }
})

private const val PROGRAM = """far(40). near :- dist(f,X) & far(L) & X < L. !start.
+!start <- argo.port(ttyACM0); argo.limit(20); argo.percepts(open).
+dist(f,X) : near
   <- +seen(X);
      !turn(X);
      argo.act(slow(X)).

+!turn(X)
   <- argo.act(turn(X)).

+!look <- for (.range(N,1,600)) { +spot(N) }.
+!renew <- argo.reload.
"""
