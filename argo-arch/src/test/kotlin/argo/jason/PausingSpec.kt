package argo.jason

import argo.architectures
import argo.observing.BreakpointOwner
import argo.observing.Order
import argo.observing.Outcome
import argo.observing.PausePhase
import argo.observing.PauseState
import argo.observing.Pausing
import argo.observing.StopAt
import argo.pausing.AgentPausing
import argo.pausing.PauseWorld
import argo.pausing.refusalToPause
import io.kotest.assertions.nondeterministic.eventually
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import jason.asSemantics.Agent
import jason.asSemantics.TransitionSystem
import jason.infra.local.LocalAgArchAsynchronous
import jason.runtime.Settings
import javino.sim.FakeBoard
import java.util.concurrent.CompletableFuture
import java.util.concurrent.TimeUnit
import java.util.concurrent.atomic.AtomicInteger
import java.util.logging.Logger
import io.kotest.matchers.string.shouldContain as shouldContainText

class PausingSpec : FunSpec({
    val reading = AtomicInteger()

    fun board(): FakeBoard = FakeBoard.plugIn("robot").lenient().version2().knows("seen/1", "stop/0", "slow/0").apply {
        whenAsked("getPercepts").answer { "dist(f,${reading.incrementAndGet()});" }
    }

    /** Does [go] and returns the next state in which the agent is paused. */
    fun Pausing.standing(go: Pausing.() -> Unit): PauseState {
        val next = CompletableFuture<PauseState>()
        follow { if (it.phase == PausePhase.PAUSED) next.complete(it) }.use {
            go()
            return next.get(LIMIT.inWholeSeconds, TimeUnit.SECONDS)
        }
    }

    fun <T> Pausing.ask(question: () -> T): T {
        val answer = CompletableFuture<T>()
        look { answer.complete(question()) } shouldBe true
        return answer.get(LIMIT.inWholeSeconds, TimeUnit.SECONDS)
    }

    fun seen(board: FakeBoard) = board.received().filter { it.startsWith("seen") }

    test("a paused agent makes its board safe, is sensed while it is paused, and goes on with the newest snapshot") {
        board().use { board ->
            LocalMas().use { mas ->
                mas.agent("bob", WATCHING, mapOf("argo_safe" to "stop"))
                eventually(LIMIT) { seen(board).size shouldBeGreaterThan 2 }
                val pausing = mas.observed("bob").pausing
                pausing.standing { pause() }.run {
                    why shouldBe "by request"
                    boards shouldBe listOf("the board on \"sim:robot\" has got stop")
                }
                board.received().last { !it.startsWith("getPercepts") } shouldBe "stop"
                val before = seen(board)
                val last = reading.get() + 5
                eventually(LIMIT) { reading.get() shouldBeGreaterThan last }
                seen(board) shouldBe before
                pausing.goOn()
                eventually(LIMIT) { seen(board).size shouldBeGreaterThan before.size }
                val next = seen(board)[before.size].removePrefix("seen(").removeSuffix(")").toInt()
                next shouldBeGreaterThan last - 1
                mas.log shouldContainText "the agent is paused: by request; the board on"
            }
        }
    }

    test("with argo_sensing=every, the snapshots that came while it was paused are left out, which is told") {
        board().use { board ->
            LocalMas().use { mas ->
                mas.agent("bob", WATCHING, mapOf("argo_sensing" to "every"))
                eventually(LIMIT) { seen(board).size shouldBeGreaterThan 2 }
                val pausing = mas.observed("bob").pausing
                pausing.standing { pause() }.boards shouldBe listOf("its boards go on with what they do, since it has no option argo_safe")
                val last = reading.get() + 5
                eventually(LIMIT) { reading.get() shouldBeGreaterThan last }
                pausing.goOn()
                eventually(LIMIT) { mas.log shouldContainText "snapshots that came while the agent was paused are left out" }
            }
        }
    }

    test("the safe command overtakes waiting commands, and is sent behind them once more") {
        board().use { board ->
            board.whenAsked("slow").outcomeAfter(500) // the pause comes before the last
            LocalMas().use { mas ->
                mas.agent("bob", """
                    !start.
                    +!start <- argo.port("sim:robot"); argo.percepts(open); !!go(1); !!go(2); !!go(3).
                    +!go(N) <- argo.act(slow).
                """, mapOf("argo_safe" to "stop"))
                eventually(LIMIT) { board.received() shouldContain "slow" }
                val pausing = mas.observed("bob").pausing
                pausing.standing { pause() }
                board.received().last { !it.startsWith("getPercepts") } shouldBe "stop"
                board.received().filter { it == "stop" }.size shouldBe 2
            }
        }
    }

    test("an agent is paused before the step at a breakpoint, once, and can be asked there") {
        board().use { board ->
            LocalMas().use { mas ->
                mas.agent("bob", WATCHING)
                eventually(LIMIT) { seen(board).size shouldBeGreaterThan 2 }
                val pausing = mas.observed("bob").pausing
                pausing.breakAt(this, "other.asl", listOf(4)).single().refusal shouldBe
                    "the agent has no plan of this file; it has plans of bob.asl"
                val state = pausing.standing {
                    breakAt(this, "bob.asl", listOf(4, 99)).map { it.line to it.refusal } shouldBe
                        listOf(5 to null, null to "no plan or step is at line 99 or behind it")
                }
                state.place?.line shouldBe 5
                val reasoning = mas.observed("bob").reasoning
                val x = pausing.ask { reasoning.c.runningIntentions.single { it.id == state.intention }.peek().unif.toString() }
                val next = "seen(${x.substringAfter("X=").substringBefore("}")})"
                seen(board).contains(next) shouldBe false
                pausing.standing { goOn() }.place?.line shouldBe 5
                eventually(LIMIT) { seen(board) shouldContain next }
                pausing.release(pausing)
                pausing.goOn()
                val before = seen(board).size
                eventually(LIMIT) { seen(board).size shouldBeGreaterThan before + 3 }
            }
        }
    }

    test("an agent goes on for one cycle, until a plan is chosen, until it believes something, and step by step") {
        LocalMas().use { mas ->
            mas.agent("bob", COUNTING)
            val observed = mas.observed("bob")
            val pausing = observed.pausing
            pausing.standing { pause() }
            val cycle = pausing.ask { observed.reasoning.agArch.cycleNumber }
            pausing.standing { goOnUntil(StopAt.NextCycle) }.why shouldBe "one cycle is over"
            pausing.ask { observed.reasoning.agArch.cycleNumber } shouldBe cycle + 1
            pausing.standing { goOnUntil(StopAt.Belief("at(_)")) }.why.orEmpty() shouldContainText "it believes at("
            val chosen = pausing.standing { goOnUntil(StopAt.ChosenPlan("+!next")) }
            chosen.why shouldBe "the plan counting for +!next(N) was chosen"
            shouldThrow<IllegalArgumentException> { pausing.goOnUntil(StopAt.ChosenPlan("+!gone")) }.message shouldBe
                "the agent has no plan +!gone; name one by its label, or by its trigger without arguments, as in +!drive"
            shouldThrow<IllegalArgumentException> { pausing.goOnUntil(StopAt.Belief("at(")) }.message.orEmpty() shouldContainText "'at('"
            val step = StopAt.Step(checkNotNull(chosen.intention), StopAt.Way.INTO)
            List(3) { pausing.standing { goOnUntil(step) }.place?.line } shouldBe listOf(5, 4, 5)
        }
    }

    test("an order to an agent that is paused is carried out at once") {
        LocalMas().use { mas ->
            mas.agent("bob", COUNTING)
            val observed = mas.observed("bob")
            observed.pausing.standing { pause() }
            val outcome = CompletableFuture<Outcome>()
            observed.order(Order.Believe("limit(60)")) { outcome.complete(it) }
            outcome.get(LIMIT.inWholeSeconds, TimeUnit.SECONDS).refusal shouldBe null
            observed.pausing.ask { "limit(60)[source(self)]" in observed.beliefs.map { "$it" } } shouldBe true
            observed.pausing.state.phase shouldBe PausePhase.PAUSED
        }
    }

    test("a command and a change of what is perceived are carried out while the agent is paused") {
        board().use { board ->
            LocalMas().use { mas ->
                mas.agent("bob", WATCHING)
                eventually(LIMIT) { seen(board).size shouldBeGreaterThan 2 }
                val observed = mas.observed("bob")
                observed.pausing.standing { pause() }
                val outcome = CompletableFuture<String>()
                observed.act("stop") { outcome.complete("${it?.cause}") }
                outcome.get(LIMIT.inWholeSeconds, TimeUnit.SECONDS) shouldBe "null"
                board.received() shouldContain "stop"
                val isDone = CompletableFuture<Unit>()
                observed.perceiveThrough(null) { observed.perceive(open = false) { isDone.complete(Unit) } }
                isDone.get(LIMIT.inWholeSeconds, TimeUnit.SECONDS)
                observed.isPerceiving shouldBe false
                observed.pausing.state.phase shouldBe PausePhase.PAUSED
            }
        }
    }

    test("a debugger that leaves has only an agent go on that stands for it and for nobody else") {
        LocalMas().use { mas ->
            mas.agent("bob", COUNTING)
            val pausing = mas.observed("bob").pausing
            val (one, other) = "one" to "other"
            suspend fun runs() = eventually(LIMIT) { pausing.state.phase shouldBe PausePhase.RUNNING }
            pausing.standing { pause() }
            pausing.release(one)
            pausing.ask { pausing.state.why } shouldBe "by request"
            pausing.standing { goOnUntil(StopAt.NextCycle, one) }
            pausing.pause(other)
            pausing.release(one)
            pausing.ask { pausing.state.why } shouldBe "one cycle is over"
            pausing.release(other)
            runs()
            pausing.standing { pause() }
            for (owner in listOf(one, other)) pausing.breakAt(owner, "bob.asl", listOf(4))
            pausing.standing { goOn() }
            pausing.release(one)
            pausing.ask { pausing.state.why } shouldBe "breakpoint"
            pausing.breakpoints(other).map { it.line } shouldBe listOf(4)
            pausing.release(other)
            runs()
            pausing.breakpoints(other).shouldBeEmpty()
        }
    }

    test("an agent that is to be paused does not fall asleep first, though it has nothing to do") {
        LocalMas().use { mas ->
            mas.agent("bob", "idle.")
            val observed = mas.observed("bob")
            val pausing = observed.pausing
            pausing.standing { pause() }
            val isGiven = CompletableFuture<Unit>()
            pausing.goOnUntil(StopAt.Belief("limit(_)"))
            pausing.standing { observed.order(Order.Believe("limit(60)")) { isGiven.complete(Unit) } }.why shouldBe
                "it believes limit(60)[source(self)]"
            repeat(20) { pausing.standing { goOnUntil(StopAt.NextCycle) }.why shouldBe "one cycle is over" }
        }
    }

    test("breakpoints move with their plans when a reload has changed them, or are lost, which is told") {
        LocalMas().use { mas ->
            val told = AtomicInteger()
            val owner = object : BreakpointOwner {
                override fun breakpointsChanged() {
                    told.incrementAndGet()
                }
            }
            val program = "$COUNTING+!other(N) : N > 1\n   <- -+b(N).\n+!other(N)\n   <- -+c(N).\n"
            mas.agent("bob", program)
            val observed = mas.observed("bob")
            val pausing = observed.pausing
            suspend fun shouldBeAfter(text: String, lines: List<Int?>) {
                mas.file("bob.asl", text)
                val outcome = CompletableFuture<Outcome>()
                observed.reload { outcome.complete(it) }
                outcome.get(LIMIT.inWholeSeconds, TimeUnit.SECONDS).refusal shouldBe null
                eventually(LIMIT) { pausing.breakpoints(owner).map { it.line } shouldBe lines }
            }
            pausing.breakAt(owner, "bob.asl", listOf(5, 3, 7, 9, 12)).map { it.line } shouldBe listOf(5, 3, 7, 9, null)
            withClue("plans move") { shouldBeAfter("// one\n\n$program", listOf(7, 5, 9, 11, null)) }
            eventually(LIMIT) { mas.log shouldContainText "bob.asl:5: the program has changed, and the breakpoint is at line 7 now" }
            withClue("plans are changed") {
                val changed = program.replace("<- -+at(N)", "<- +begun; -+at(N)").replace("-+c(N)", "-+c(N); -+d(N)")
                    .replace("b(N)", "e(N)")
                shouldBeAfter("$changed+!last <- +x.\n", listOf(5, 3, 7, 9, null))
            }
            withClue("a plan is gone") { shouldBeAfter(COUNTING.replace("\n+!next", "\n\n+!next"), listOf(6, 4, null, null, null)) }
            pausing.breakpoints(owner)[3].refusal shouldBe "the plan of line 9 is gone"
            mas.log shouldContainText "bob.asl:9: the program has changed, and there is no breakpoint any more: the plan of line 9 is gone"
            eventually(LIMIT) { told.get() shouldBe 3 }
            withClue("nothing has changed") { shouldBeAfter(COUNTING.replace("\n+!next", "\n\n+!next"), listOf(6, 4, null, null, null)) }
            told.get() shouldBe 3
        }
    }

    test("a breakpoint that is set when the file is saved already, as editors do, is one of the new text") {
        LocalMas().use { mas ->
            mas.agent("bob", COUNTING)
            val observed = mas.observed("bob")
            mas.file("bob.asl", COUNTING.replace("@counting", "\n\n@counting"))
            observed.pausing.breakAt("it", "bob.asl", listOf(5, 7)).map { it.line } shouldBe listOf(5, null)
            val outcome = CompletableFuture<Outcome>()
            observed.reload { outcome.complete(it) }
            outcome.get(LIMIT.inWholeSeconds, TimeUnit.SECONDS).refusal shouldBe null
            eventually(LIMIT) { observed.pausing.breakpoints("it").map { it.line } shouldBe listOf(5, 7) }
        }
    }

    test("a board that has no such command, and an agent without the option, are told") {
        board().use { board ->
            board.whenAsked("halt").refuse() // the agent may pause before it knows the board's actions
            LocalMas().use { mas ->
                mas.agent("bob", WATCHING, mapOf("argo_safe" to "halt"))
                mas.agent("alice", "!start.")
                eventually(LIMIT) { seen(board).size shouldBeGreaterThan 2 }
                mas.observed("bob").pausing.standing { pause() }.boards.single() shouldContainText
                    "the board on \"sim:robot\" has not got halt: "
                mas.observed("alice").pausing.standing { pause() }.boards shouldBe
                    listOf("its boards go on with what they do, since it has no option argo_safe")
            }
        }
    }

    test("an agent of three threads cannot be paused, which is told") {
        val ts = TransitionSystem(Agent(), null, Settings(), LocalAgArchAsynchronous())
        val refusal = refusalToPause(architectures(ts))
        refusal.orEmpty() shouldContainText "the agent has a thread each for sensing, deliberating and acting"
        val world = PauseWorld({ 0 }, { null }, { }, { }, isStandingStill = false)
        AgentPausing(refusal, ts, world, Logger.getLogger("argo.test")) { it() }.run {
            pause()
            cycleStarting() // returns, so the agent is not paused
            state.phase shouldBe PausePhase.RUNNING
            breakAt(this, "bob.asl", listOf(1)).single().refusal shouldBe refusal
        }
    }

    test("an agent that is killed while it is paused leaves nothing, and one with a wrong safe command is told so") {
        board().use { board ->
            LocalMas().use { mas ->
                mas.agent("bob", WATCHING, mapOf("argo_safe" to "stop("))
                eventually(LIMIT) { seen(board).size shouldBeGreaterThan 2 }
                mas.log shouldContainText "SEVERE argo.Arch.bob: argo_safe=stop(: 'stop('"
                mas.observed("bob").pausing.standing { pause() }
                mas.kill("bob")
                eventually(LIMIT) { (agentThreads() + threads().filter { it == "bob" }).shouldBeEmpty() }
            }
        }
    }
})

private const val WATCHING = """!start.
+!start <- argo.port("sim:robot"); argo.limit(10); argo.percepts(open).
+dist(f,X)
   // the command
   <- argo.act(seen(X)).
+!look <- .relevant_plans({+!start}, Plans); .print(Plans).
"""

private const val COUNTING = """!next(0).
@counting
+!next(N)
   <- -+at(N);
      !next(N+1).
"""
