package argo.recording

import argo.observing.Order
import argo.observing.PausePhase
import argo.observing.StopAt
import argo.recording.replay.Recording
import argo.recording.replay.RecordingException
import argo.recording.replay.Replay
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.ints.shouldBeLessThan
import io.kotest.matchers.shouldBe
import jason.asSemantics.Unifier
import jason.asSyntax.ASSyntax
import javino.sim.SimulatedBoards
import javino.sim.Sketch
import kotlinx.coroutines.delay
import kotlinx.coroutines.runBlocking
import java.nio.file.Path
import java.util.concurrent.atomic.AtomicInteger
import kotlin.io.path.readText
import kotlin.random.Random

/** Agents on Jason's Local infrastructure in real time are replayed exactly. */
class RealTimeReplaySpec : FunSpec({
    /** Drives at a wall. Each request shows it 5 cm nearer, until the robot stops. */
    class Robot : Sketch {
        private val front = AtomicInteger(200)

        @Volatile
        private var isDriving = false

        override fun percepts() = listOf("dist(front,${if (isDriving) front.addAndGet(-5) else front.get()})", "light(back,140)")

        override fun act(command: String): Boolean {
            isDriving = command == "forward"
            return true
        }
    }

    fun withRobot(name: String, drive: (port: String) -> Unit) {
        SimulatedBoards.plugIn(name, Robot())
        try {
            drive("sim:$name")
        } finally {
            SimulatedBoards.unplug(name)
        }
    }

    fun driver(port: String) =
        """
        !start. !miss.
        +!miss <- ?missing(_).
        -!miss[error(E)] <- .print("failed: ", E).
        +!start <- argo.port("$port"); argo.limit(2); argo.percepts(open); argo.act(forward); !watch(0).
        +!watch(N) : not stopped & N < 100 <- .random(R); .wait(10 + R * 5); +watched(N); !watch(N + 1).
        +!watch(N).
        +dist(front,Cm) : Cm < 40 & not stopped <- +stopped; argo.act(stop); .print("stopped at ", Cm); +standing.
        """.trimIndent()

    test("an agent that drives a board") {
        val file = recordingFile()
        withRobot("live-robot") { port ->
            LiveMas(file).use { mas ->
                mas.agent("driver", driver(port))
                runBlocking { mas.awaitBelief("driver", "standing") } // the last belief, so the command is already on the line
            }
        }
        Recording(file).use { it.cycles("driver").toList() }.flatMap { it.input.calls }.flatMap { it.commands }.map { it.text }
            .distinct() shouldContain "stop"
        shouldReplay(file)
    }

    test("goals that are given up when their time is over, while the agent rests") {
        val file = recordingFile()
        LiveMas(file).use { mas ->
            mas.agent(
                "runner",
                """
                !start.
                +!start <- !!lap(30)[hard_deadline(200)]; !lap(20)[hard_deadline(100)]; !lap(2)[hard_deadline(500)]; !lap(3); +home.
                +!lap(N) <- .wait(N * 20); .print(N).
                -!lap(N)[error(E)] <- .print(N, E); +late(N).
                """.trimIndent(),
            )
            runBlocking {
                mas.awaitBelief("runner", "home")
                mas.awaitBelief("runner", "late(30)")
            }
        }
        shouldReplay(file)
    }

    test("a message to an agent that does not exist, whose failure has the annotations of Jason's own") {
        val file = recordingFile()
        LiveMas(file).use { mas ->
            mas.agent(
                "caller",
                """
                !start.
                +!start <- .send(nobody, tell, hello).
                -!start[error(receiver_not_found),agent_not_found(A)] <- .print(A); +missed(A).
                """.trimIndent(),
            )
            runBlocking { mas.awaitBelief("caller", "missed(nobody)") }
        }
        shouldReplay(file)
    }

    test("what shows where the program lies: errors, labels of plans, and plans that are told") {
        val file = recordingFile()
        LiveMas(file).use { mas ->
            val teacher =
                """
                !start.
                @show +!show(X,_) <- .random(R); .print(X, R).
                +!start <- .plan_label(P, show); .print(P); !fail.
                -!fail[error_msg(M),code_src(S)]
                   <- .print(M, S); .send(pupil, askHow, {+!learn(_)}, Plans); .print(Plans); .add_plan(Plans);
                   !learn(1); .send(pupil, tellHow, Plans); .send(pupil, tellHow, "@told +!sing(X) <- .random(R); .print(X, R)."); +taught.
                +!fail <- .fail.
                """.trimIndent()
            val pupil = "+!learn(X) <- .random(R); .print(X, R); Y = math.random(10); +learnt(Y). +!hum <- !sing(low); +hummed."
            mas.agent("pupil", pupil) { "file:$it" }
            mas.agent("teacher", teacher) { "file:$it" }
            runBlocking {
                mas.awaitBelief("teacher", "taught")
                mas.agent("boss", "!start. +!start <- .send(pupil, achieve, hum).")
                mas.awaitBelief("pupil", "hummed")
            }
        }
        shouldReplay(file)
    }

    test("an agent that gets many messages at once, without plans for them, from agents that reason at the same time") {
        val file = recordingFile()
        LiveMas(file).use { mas ->
            mas.agent(
                "buyer",
                """
                enough :- .count(bid(_,_), N) & N >= 40.
                !start.
                +!start <- .wait(enough); .findall(P, bid(_,P), Ps); .min(Ps, Best); .print(Ps, Best); +bought(Best).
                """.trimIndent(),
            )
            for (seller in 1..4) {
                mas.agent(
                    "seller$seller",
                    "!start. +!start <- for (.range(I,1,10)) { !bid(I) }.\n" +
                        "+!bid(I) <- .send(buyer, tell, bid($seller, I * 7 - 30)); .wait(1).",
                )
            }
            runBlocking { mas.awaitBelief("buyer", "bought(-23)") }
        }
        shouldReplay(file)
    }

    test("an agent that is paused at breakpoints, is asked and given orders there, and goes on") {
        val file = recordingFile()
        LiveMas(file).use { mas ->
            mas.agent(
                "walker",
                """
                near(X) :- at(Y) & X = Y + 1.
                !walk(0).
                +!walk(N) : N < 30
                   <- -+at(N);
                      .random(R); .wait(R * 3);
                      !walk(N + 1).
                +!walk(_) <- +home.
                +told(N) <- .random(R); .print(N, R).
                """.trimIndent(),
            )
            val walker = mas.observed("walker")
            val (pausing, reasoning) = walker.pausing to walker.reasoning
            val asked = AtomicInteger()
            pausing.follow {
                if (it.phase == PausePhase.PAUSED) {
                    val question = ASSyntax.parseFormula("near(_) & .random(_)")
                    pausing.look { if (reasoning.ag.believes(question, Unifier())) asked.incrementAndGet() }
                    walker.order(Order.Believe("told(${asked.get()})")) { }
                    walker.perceiveThrough(null) { }
                    when (asked.get() % 3) {
                        0 -> pausing.goOnUntil(StopAt.NextCycle)
                        1 -> pausing.goOnUntil(StopAt.Belief("at(_)"))
                        else -> pausing.goOn()
                    }
                }
            }.use {
                pausing.breakAt(this, "walker.asl", listOf(3, 5))
                runBlocking { mas.awaitBelief("walker", "home") }
            }
            asked.get() shouldBeGreaterThan 10
        }
        Recording(file).use { recording -> recording.cycles("walker").count { it.input.isHeld } } shouldBeGreaterThan 10
        Recording(file).use { recording -> recording.cycles("walker").count { it.isEnding } } shouldBeLessThan 2
        shouldReplay(file)
        val lines = ArrayList<Int?>()
        Recording(file).use { recording ->
            Replay(recording).use { replay ->
                val pausing = replay.pausing("walker")
                pausing.breakAt(this, "walker.asl", listOf(4, 6))
                pausing.follow {
                    if (it.phase == PausePhase.PAUSED) pausing.goOn().also { _ -> lines += it.place?.line }
                }
                replay.run().differences.shouldBeEmpty()
            }
        }
        lines.filter { it == 4 }.size shouldBe 30
        lines.filter { it == 6 }.size shouldBe 30
    }

    test("an agent that is stopped in the middle of a cycle") {
        val file = recordingFile()
        LiveMas(file).use { mas ->
            mas.agent("robot", "!start. +!start <- +begun; !go. +!go : argo.recording.stopping <- .print(never).")
            runBlocking { mas.awaitDeath("robot") }
        }
        val last = Recording(file).use { it.cycles("robot").last() }
        last.isEnding shouldBe true
        last.course.run { event to step } shouldBe ("+!go[source(self)]" to null)
        shouldReplay(file)
    }

    test("an agent whose thread an error ends in the middle of a cycle: the recording has what entered that cycle, and the log tells") {
        val file = recordingFile()
        val mas = LiveMas(file) // removes the handlers of all loggers
        val log = logged {
            mas.use {
                mas.agent("robot", "loop :- loop. !start. +!start <- +begun; !go. +!go : loop <- .print(never).")
                runBlocking { mas.awaitDeath("robot") }
            }
        }.second
        val last = Recording(file).use { it.cycles("robot").last() }
        last.isEnding shouldBe true
        log.single { "an error ended cycle" in it } shouldBe
            "argo_record: an error ended cycle ${last.number} of agent robot; its recording ends there"
        shouldThrow<RecordingException> { replayOf(file) }.message shouldBe
            "a term or a rule is nested too deeply in cycle ${last.number} of agent robot"
    }

    test("an agent that prints on while Java ends, which takes the handlers of its logger away") {
        val file = recordingFile()
        LiveMas(file).use { mas ->
            mas.agent(
                "robot",
                "!count(0). +!count(N) : N < 50 <- .print(N); if (N == 5) { +five }; .wait(2); !count(N + 1). +!count(N) <- +done.",
            )
            runBlocking {
                mas.awaitBelief("robot", "five")
                mas.loseHandlers("robot")
                mas.awaitBelief("robot", "done")
            }
        }
        shouldReplay(file)
    }

    /** A robot with random percepts and delays. The robot's cable is unplugged at random times. */
    class FaultyRobot(seed: Long) : Sketch {
        private val chance = Random(seed)

        override fun percepts(): List<String> {
            if (chance.nextInt(20) == 0) Thread.sleep(chance.nextLong(150)) // the board is busy
            return listOf("dist(f,${chance.nextInt(5, 200)})", "light(f,${chance.nextInt(80, 120)})", "temp(f,${chance.nextInt(20, 30)})")
        }

        override fun act(command: String) = chance.nextInt(10) != 0
    }

    suspend fun drive(seed: Long): Path {
        val file = recordingFile()
        val chance = Random(seed)
        SimulatedBoards.plugIn("live-robot", FaultyRobot(seed))
        try {
            LiveMas(file).use { mas ->
                val beliefs = "board(\"sim:live-robot\", [timeout(100)]). value(20). interval(20). view(none)."
                mas.agent("robot", "$beliefs\n${Path.of("../samples/collision/robot.asl").readText()}")
                repeat(3) {
                    delay(chance.nextLong(100, 400))
                    SimulatedBoards.unplug("live-robot")
                    delay(chance.nextLong(20, 200))
                    SimulatedBoards.plugIn("live-robot", FaultyRobot(seed + it))
                }
                delay(300)
            }
        } finally {
            SimulatedBoards.unplug("live-robot")
        }
        return file
    }

    test("drives of the sample collision with faults; the property argo.live.drives has how many") {
        for (seed in 0L until Integer.getInteger("argo.live.drives", 1)) withClue("seed $seed") { shouldReplay(drive(seed)) }
    }

    test("two agents that talk, each on a thread of its own") {
        val file = recordingFile()
        withRobot("live-robot") { port ->
            LiveMas(file).use { mas ->
                mas.agent(
                    "boss",
                    """
                    +far(Cm)[source(S)] : Cm < 100 & not warned
                       <- +warned; .send(S, achieve, slow); .send(S, askOne, stopped, A, 500); +answer(A).
                    +done[source(S)] <- .send(S, tell, thanks).
                    """.trimIndent(),
                )
                mas.agent(
                    "driver",
                    driver(port) + """

                    +dist(front,Cm) : Cm mod 25 == 0 <- .send(boss, tell, far(Cm)).
                    +!slow <- .print("slowly now").
                    +stopped <- .send(boss, tell, done).
                    """.trimIndent(),
                )
                runBlocking { mas.awaitBelief("driver", "thanks") }
            }
        }
        Recording(file).use { it.agents.keys } shouldBe setOf("boss", "driver")
        shouldReplay(file)
    }
})
