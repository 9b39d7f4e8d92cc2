package argo.testkit

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.NamedTag
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import java.util.concurrent.CountDownLatch
import java.util.concurrent.TimeUnit
import java.util.logging.Logger
import kotlin.concurrent.thread
import kotlin.time.Duration
import kotlin.time.Duration.Companion.days
import kotlin.time.Duration.Companion.seconds

/** Misuses of the test kit. */
class StrangeTestsSpec : FunSpec({
    /** Returns the threads of agents and boards that do not end within 60 s. */
    fun threads() = Thread.getAllStackTraces().keys.filter { it.name.startsWith("argo-") || it.name.startsWith("board") }
        .onEach { it.join(60_000) }.filter { it.isAlive }

    fun handlers() = Logger.getLogger("").handlers.count { it is AgentLog }

    test("a program that cannot be read is shown where that is") {
        val message = shouldThrow<IllegalArgumentException> { agentOf("!start.\n+!start <-\n\t.print(a)\n+!go <- true.") }.message.orEmpty()
        message shouldContain "Jason cannot read agent.asl: \"!\" does not belong in line 4, column 2"
        message shouldContain "\n    +!go <- true.\n     ^"
        shouldThrow<IllegalArgumentException> { agentOf("!start.\n+!start <- .print(\"a).") }.message shouldContain "line 2"
        handlers() shouldBe 0
    }

    test("an included file that is not there is told with whatever fails, however much was logged since") {
        agentOf("{ include(\"nowhere.asl\") }\n!start.\n+!start <- for (.range(I,1,100)) { .print(I) }.").use { agent ->
            shouldThrow<AssertionError> { agent.shouldBelieve("x") }.message shouldContain "'nowhere.asl' was not found"
        }
    }

    test("an agent whose rules call themselves for ever is told from one that works") {
        val told = shouldThrow<AssertionError> { agentOf("far(X) :- far(X).\n!start.\n+!start : far(1) <- true.") }
        told.message shouldContain "agent agent calls itself without end"
        told.cause.shouldNotBeNull()
        threads().shouldBeEmpty()
    }

    test("an expectation that fails names what was expected, what was seen, and when each was") {
        agentOf("!start.\n+!start <- argo.port(ttyACM0, [protocol(1)]); argo.act(stop); .wait(1000); .print(late).").use { agent ->
            agent.shouldSend("stop").after(2.seconds)
            val message = shouldThrow<AssertionError> { agent.shouldSend("stop", within = 3.seconds) }.message.orEmpty()
            message shouldContain "expected that agent agent sends stop within 3s\nafter ${agent.now.inWholeMilliseconds} ms\n"
            val stopped = agent.arrivals.single().at.inWholeMilliseconds
            message shouldContain "sent: \n    at $stopped ms: stop, taken by an earlier expectation"
            Regex("at 1\\d\\d\\d ms: INFO late").find(message).shouldNotBeNull()
        }
    }

    test("what Jason says about a plan that failed is in the log, and not printed") {
        agentOf("!start.\n+!start <- .print(fails); .log(warning, soon); .fail.").use { agent ->
            agent.printed shouldBe listOf("fails", "soon")
            agent.log.joinToString("\n") shouldContain "No failure event was generated for +!start"
        }
    }

    context("a percept that no agent would believe is refused with the reason:") {
        mapOf(
            "dist(front" to "Jason cannot read it", "3" to "Jason cannot read it", "Dist(front,3)" to "Jason cannot read it",
            "X" to "it is not a predicate", "dist(Front,3)" to "it holds a variable", "a;b" to "one percept, without a ;",
            "a;" to "one percept, without a ;", "" to "one percept", "stale(ttyACM0)" to "no board can claim",
        ).forEach { (percept, reason) ->
            test("\"$percept\"") {
                agentOf("!start.\n+!start <- argo.port(p); argo.percepts(open).").use { agent ->
                    val calls = listOf<() -> Any>(
                        { agent.perceives("light(3)", percept) }, { agent.board.shows(percept) }, { agent.board.says(percept) },
                    )
                    calls.forEach { call ->
                        val message = shouldThrow<IllegalArgumentException> { call() }.message
                        message shouldContain "no agent would believe the percept \"$percept\": "
                        message shouldContain reason
                    }
                    agent.board.shows { listOf(percept) }
                    shouldThrow<IllegalStateException> { agent.after(1.seconds) }.message shouldContain reason
                }
            }
        }
    }

    context("percepts that do not reach the agent fail the test with the reason:") {
        mapOf(
            "argo.limit(5); argo.percepts(open)" to "no port is in use",
            "argo.port(p)" to "perceiving is blocked",
            "argo.port(p); argo.percepts(open); argo.percepts(block)" to "perceiving is blocked",
            "argo.port(p,[mode(listen)]); argo.percepts(open)" to "there the board says(…) its percepts",
            "argo.port(p); argo.limit(60000); argo.percepts(open); .wait(500)" to "the sensing interval is 60000 ms",
            ".my_name(Me); .kill_agent(Me)" to "it is stopped",
        ).forEach { (start, reason) ->
            test(start) {
                agentOf("!start.\n+!start <- $start; +ready.").use { agent ->
                    if ("kill" !in start) agent.shouldBelieve("ready", within = 10.seconds)
                    val message = shouldThrow<AssertionError> { agent.perceives("a") }.message
                    message shouldContain "expected that agent agent perceives a within 1s, but "
                    message shouldContain reason
                }
            }
        }
        test("no argo.Arch") {
            agentOf("x.") { arch = null }.use { agent ->
                shouldThrow<AssertionError> { agent.perceives("a") }.message shouldContain "it has no board"
            }
        }
    }

    test("a long sensing interval is waited for, if the time for it is given") {
        agentOf("!start.\n+!start <- argo.port(p); argo.limit(5000); argo.percepts(open).\n+a <- argo.act(seen).").use { agent ->
            agent.after(4.seconds).perceives("a", within = 12.seconds).shouldSend("seen")
        }
    }

    test("a board of version 1 refuses nothing") {
        agentOf("x.") {
            listOf<() -> Any>({ board.refuses("fly") }, { board.refuses { true } }).forEach { call ->
                shouldThrow<IllegalStateException> { call() }.message shouldContain "call version2() before refuses(…)"
            }
        }.close()
    }

    test("a line carries no character of more than a byte") {
        agentOf("x.").use { agent ->
            shouldThrow<IllegalArgumentException> { agent.board.disturbs("\u2603") }.message shouldContain "one byte"
        }
    }

    test("a time without end is refused") {
        agentOf("x.").use { agent ->
            agent.after(1.seconds)
            shouldThrow<IllegalArgumentException> { agent.after(Duration.INFINITE) }.message shouldContain "at most"
            shouldThrow<IllegalArgumentException> { agent.shouldBelieve("y", within = 100_000.days) }.message shouldContain "at most"
        }
    }

    test("nothing is expected of agents that are closed; what they did can still be looked at") {
        val agent = agent("robot.asl")
        agent.perceives("dist(front,90)").close()
        agent.close()
        val late = listOf<() -> Any>(
            { agent.shouldSend("front") }, { agent.perceives("x") }, { agent.hears("a", "tell", "b") }, { agent.after(1.seconds) },
            { agent.stops() },
        )
        late.forEach { call -> shouldThrow<IllegalStateException> { call() }.message shouldContain "robot are closed" }
        agent.sent shouldBe listOf("front")
        agent.beliefs shouldContain "dist(front,90)"
    }

    test("a test that is interrupted ends at once, with nothing left") {
        val begun = CountDownLatch(1)
        var end: Throwable? = null
        val test = thread {
            end = runCatching {
                agentOf("!start.\n+!start <- argo.port(ttyACM0); argo.limit(1); argo.percepts(open).\n+x(1) <- .print(x).").use { agent ->
                    agent.perceives("x(1)")
                    begun.countDown()
                    agent.after(3000.days)
                }
            }.exceptionOrNull()
        }
        check(begun.await(60, TimeUnit.SECONDS)) { "the agent has not started" }
        test.interrupt()
        test.join(60_000)
        check(end is InterruptedException) { "$end" }
        end!!.suppressed.toList().shouldBeEmpty()
        threads().shouldBeEmpty()
        handlers() shouldBe 0
    }

    test("a board that is busy when its test ends does not outlive it") {
        agentOf("!start.\n+!start <- argo.port(ttyACM0, [protocol(1)]); argo.act(drive).") { board.takes(60.seconds, "drive") }
            .use { it.shouldSend("drive") }
        threads().shouldBeEmpty()
    }

    test("two hundred agents leave no thread and no handler behind, and neither does one whose set-up fails").config(tags = thorough) {
        repeat(200) { agent("robot.asl").use { it.perceives("dist(front,90)").shouldSend("front") } }
        shouldThrow<IllegalStateException> { agent("robot.asl") { error("no such board here") } }.message shouldNotContain "closed"
        threads().shouldBeEmpty()
        handlers() shouldBe 0
    }
})

private val thorough = setOf(NamedTag("Thorough"))
