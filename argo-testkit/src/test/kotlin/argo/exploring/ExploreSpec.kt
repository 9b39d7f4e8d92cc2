package argo.exploring

import argo.testkit.agentOf
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.assertions.withClue
import io.kotest.core.NamedTag
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.ints.shouldBeLessThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.types.shouldBeInstanceOf
import planted.PLANTED
import kotlin.io.path.writeText
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.minutes
import kotlin.time.Duration.Companion.seconds

class ExploreSpec : FunSpec({
    val folder = tempdir().toPath()
    fun planted(name: String) = PLANTED.single { it.name == name }
    fun program(text: String) = folder.resolve("agent.asl").apply { writeText(text) }.toString()
    val quiet = "!start. +!start <- argo.port(ttyACM0); argo.percepts(open). +port(_,_)."

    test("a fault is found, shrunk, and told in words and as a spec") {
        val ages = planted("ages")
        val file = ages.write(folder, isMended = false)
        val outcome = outcomeOf("$file") {
            ages.describe(this)
            runs = 60
            mostEvents = 3
        }
        val found = outcome.shouldBeInstanceOf<Found>()
        found.rule shouldBe "stops when blind"
        found.events.size shouldBe 1
        reportOf(found) shouldContain "what has to happen for it (seed "
        specOf(found) shouldContain "class AgesStopsWhenBlindSpec : FunSpec({"
        val repeated = shouldThrow<AssertionError> {
            shouldKeepRules("$file", *found.events.toTypedArray()) { ages.describe(this) }
        }
        repeated.message shouldContain found.breach.how
        shouldKeepRules("${ages.write(folder, isMended = true)}", *found.events.toTypedArray()) { ages.describe(this) }
    }

    /** Writes a robot that adds the belief stopped too early. With [isMended], it does not. */
    fun stopping(isMended: Boolean) = program(
        """
        !start.
        +!start <- argo.port(ttyACM0); argo.percepts(open); !go.
        -!start <- .wait(500); !start.
        +!go <- -+moving(yes); argo.act(front).
        -!go <- -+moving(no).
        +dist(front,D) : D < 30 & moving(yes) <- !halt.
        +dist(front,D) : D >= 30 & moving(no) <- !go.
        +!halt <- ${if (isMended) "argo.act(stop); -+moving(no)" else "-+moving(no); argo.act(stop)"}.
        -!halt <- .print("not stopped")${if (isMended) "; .wait(200); !halt" else ""}.
        +port(_,_).
        """.trimIndent(),
    )

    test("a command that is lost on its way, and that the agent believes to have been carried out").config(tags = thorough) {
        val describe: Exploration.() -> Unit = {
            board("ttyACM0") {
                version2()
                sensor("dist(front,%d)", 5..200)
            }
            rules(sendsAgain(listOf("stop")))
            runs = 150
            time = 10.minutes // for a busy machine
        }
        val found = outcomeOf(stopping(isMended = false), describe).shouldBeInstanceOf<Found>()
        found.breach.how shouldContain "stop of agent failed with"
        found.events.size shouldBeLessThan 4
        shouldKeepRules(stopping(isMended = true), *found.events.toTypedArray()) { describe() }
    }

    test("a wait for a time that its step names is none for ever, and one for what need not come is") {
        fun outcome(wait: String) = outcomeOf(program("$quiet !begin. +!begin <- Ms = 9000; !wait(Ms). +!wait(Ms) <- $wait; !wait(Ms).")) {
            board("ttyACM0") { sensor("dist(front,%d)", 5..200) }
            rules(neverWaitsForever())
            runs = 1
        }
        for (wait in listOf(".wait(Ms)", ".wait({+never}, 9000)", ".send(nobody, askOne, price, _, Ms)")) {
            withClue(wait) { outcome(wait).shouldBeInstanceOf<NothingFound>() }
        }
        outcome(".wait({+never})").shouldBeInstanceOf<Found>().breach.how shouldContain "begin at .wait({ +never })"
    }

    test("an agent that keeps the rules passes, and what was played is said") {
        val passed = explore(program(quiet)) {
            board("ttyACM0") { sensor("dist(front,%d)", 5..200) }
            runs = 2
        }
        passed.runs shouldBe 4 // two random runs and two without events
    }

    test("a board whose port no agent opens is refused, since nothing can happen to it") {
        val refused = shouldThrow<IllegalArgumentException> {
            explore(program(quiet)) {
                board("ttyACM1") { sensor("light(%d)", 0..9) }
                runs = 2
            }
        }
        refused.message shouldBe "no agent has opened the port ttyACM1 of a board that is described; opened were: ttyACM0"
    }

    mapOf(
        Hangs(1.seconds, "ttyACM1", 1.seconds) to "is about ttyACM1, and there are only ttyACM0",
        Reads(1.seconds, "ttyACM0", "light", "light(3)") to "is about light, and there are only light(%d)",
        Hears(1.seconds, "robot", "boss", "tell", "go") to "is about robot, and there are only agent",
    ).forEach { (event, why) ->
        test("${event.form.kotlin} is refused, since nothing would happen") {
            shouldThrow<IllegalArgumentException> {
                shouldKeepRules(program(quiet), event) { board("ttyACM0") { sensor("light(%d)", 0..9) } }
            }.message shouldBe "${event.form.kotlin} $why"
        }
    }

    test("the same events give the same run") {
        val events = listOf(
            Unplugged(1.seconds, "ttyACM0", 700.milliseconds),
            Garbles(2.seconds, "ttyACM0", 9, 1.seconds),
            Floods(3.seconds, "ttyACM0", 20),
            Restarts(4.seconds, "ttyACM0", 600.milliseconds),
            Flickers(5.seconds, "ttyACM0", "light(%d)", "light(1)", "light(3)", 60.milliseconds, 1.seconds),
            AnswersLate(6.seconds, "ttyACM0", 300.milliseconds, 1.seconds), Hangs(7.seconds, "ttyACM0", 1.seconds),
        )
        val file = program(quiet + " +light(X) <- argo.act(seen(X)). -light(_). -!start. +!go. ")
        fun run() = runOf(file, events) { board("ttyACM0") { sensor("light(%d)", 0..9) } }
        val first = run()
        first.differenceFrom(run()) shouldBe null
        first.trace.filterIsInstance<Issued>().map { it.command } shouldContain "seen(3)"
        first.trace.filterIsInstance<PortChanged>().map { it.status } shouldContain "off"
        first.trace.filterIsInstance<Happened>().map { it.event } shouldBe events
    }

    test("an agent that draws lots is reported as such, with the first difference") {
        val report = shouldThrow<AssertionError> {
            explore(program("$quiet !draw. +!draw <- .random(X); .print(X).")) { board("ttyACM0") { sensor("light(%d)", 0..9) } }
        }.message
        report shouldContain "the agents are not deterministic"
        report shouldContain "first difference: Printed(at=0s, agent=agent, text=0."
    }

    test("a rule of a project's own is checked as the others are, and its spec calls what describes the boards") {
        val outcome = outcomeOf(program("$quiet +light(X) : X > 5 <- argo.act(bright).")) {
            board("ttyACM0") { sensor("light(%d)", 0..9) }
            rules(
                rule("stays dark") { run ->
                    run.trace.firstOrNull { it is Issued && it.command == "bright" }?.let { Breach(it.at, "it sends bright") }
                },
            )
        }
        val found = outcome.shouldBeInstanceOf<Found>()
        found.events shouldBe emptyList() // the sensor starts with the last value of its range
        specOf(found) shouldContain "boards() // the function that describes"
    }

    test("agents of a system are explored together, and late messages change their order") {
        folder.resolve("fleet.mas2j").writeText("MAS fleet { agents: scout agentArchClass argo.Arch; body agentArchClass argo.Arch; }")
        folder.resolve("scout.asl").writeText(
            "$quiet +light(X) : X < 3 <- .send(body, tell, dark). +light(_) <- .send(body, untell, dark).",
        )
        folder.resolve("body.asl").writeText(
            "!start. +!start <- argo.port(ttyACM1). +port(_,_). +dark <- argo.act(lamp). -dark <- argo.act(off).",
        )
        fun sent(vararg late: WorldEvent) = runOf(
            "${folder.resolve("fleet.mas2j")}",
            late.toList() + Reads(1.seconds, "ttyACM0", "light(%d)", "light(1)") + Reads(2.seconds, "ttyACM0", "light(%d)", "light(9)"),
        ) {
            board("ttyACM0") { sensor("light(%d)", 0..9) }
            board("ttyACM1")
        }.of("body").filterIsInstance<Issued>().map { it.command }
        sent() shouldBe listOf("lamp", "off")
        // the late message hides that it is light
        sent(MessagesLate(500.milliseconds, "body", 3.seconds, 1.seconds)) shouldBe listOf("lamp")
    }

    test("beliefs of a system may hold strings") {
        val system = folder.resolve("quoted.mas2j")
        system.writeText("MAS quoted { agents: robot [beliefs=\"board(\\\"sim:robot\\\")\"] agentArchClass argo.Arch; }")
        folder.resolve("robot.asl").writeText("!start. +!start : board(P) <- argo.port(P); argo.act(go).")
        runOf("$system", emptyList()) { board("sim:robot") }.of("robot").filterIsInstance<Issued>().map { it.command } shouldBe listOf("go")
    }

    mapOf<String, Exploration.() -> Unit>(
        "no board is described" to {},
        "there is no rule to be kept" to {
            board("ttyACM0")
            rules()
        },
        "a sensor of numbers has %d where the number stands" to { board("ttyACM0") { sensor("dist(front)", 1..9) } },
        "a sensor shows one of several percepts" to { board("ttyACM0") { sensor("lamp(on)") } },
        "from 5 to 200 and cannot be 300" to { board("ttyACM0") { sensor("dist(front,%d)", 5..200, first = 300) } },
        "\"dist(\" is not a belief or a formula" to { rules(reactsTo("dist(", listOf("stop"))) },
        "a message is for the agent nobody; there are agent" to {
            board("ttyACM0")
            message("nobody", "boss", "achieve", "go")
        },
    ).forEach { (why, describe) ->
        test("it is refused in words: $why") {
            shouldThrow<IllegalArgumentException> { explore(program(quiet), describe) }.message shouldContain why
        }
    }

    test("a board restarts on its open port, and answers late") {
        agentOf("!start. +!start <- argo.port(ttyACM0); argo.percepts(open). +port(P,S) <- .print(P,S).").use { robot ->
            robot.perceives("light(3)").board.restarts(1.seconds)
            robot.shouldPrint("ttyACM0timeout", within = 2.seconds).shouldBelieve("port(ttyACM0,on)", within = 3.seconds)
            robot.board.answersAfter(900.milliseconds)
            robot.shouldBelieve("port(ttyACM0,timeout)", within = 3.seconds)
            robot.board.answersAfter(0.seconds)
            robot.shouldBelieve("port(ttyACM0,on)", within = 3.seconds)
            robot.board.isOpen shouldBe true
        }
    }
})

private val thorough = setOf(NamedTag("Thorough"))
