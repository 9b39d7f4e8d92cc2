package argo.testkit

import argo.filters.FilterProvider
import argo.filters.PerceptionFilter
import argo.filters.Rule
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.comparables.shouldBeGreaterThan
import io.kotest.matchers.comparables.shouldBeLessThanOrEqualTo
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldEndWith
import io.kotest.matchers.string.shouldNotContain
import javino.sim.LineRecording
import javino.sim.MemoryLine
import java.util.concurrent.CompletableFuture
import java.util.concurrent.TimeUnit
import kotlin.time.Duration
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.minutes
import kotlin.time.Duration.Companion.nanoseconds
import kotlin.time.Duration.Companion.seconds

class DayFilters : FilterProvider {
    override val filters = listOf(PerceptionFilter("noLight", Rule("light")))
}

class AgentSpec : FunSpec({
    test("an agent in a file, with what it includes, acts on what its board's sensors show") {
        agent("robot.asl").use { robot ->
            robot.perceives("dist(front,90)")
            robot.shouldSend("front").shouldBelieve("driving & dist(front,X) & X > 40")
            robot.perceives("dist(front,30)")
            robot.shouldSend("stop").shouldNotBelieve("driving")
            robot.shouldSendNothingElse()
            robot.sent shouldBe listOf("front", "stop")
            robot.beliefs shouldBe listOf("dist(front,30)", "port(ttyACM0,on)")
            robot.shouldPrint("port ttyACM0 is on")
        }
    }

    test("ten minutes of .wait take no time, and time goes on as far as the test lets it") {
        agentOf("!start.\n+!start <- argo.port(ttyACM0); .wait(600000); argo.act(over).").use { robot ->
            robot.after(10.minutes - 1.seconds).sent.shouldBeEmpty()
            robot.shouldIntend("start").shouldNotIntend("rest")
            robot.shouldSend("over", within = 2.seconds)
            check(robot.now in 10.minutes..(10.minutes + 1.seconds + 100.milliseconds)) { "${robot.now}" }
        }
    }

    test("requests come at the interval that the agent sets, however long the test takes") {
        agentOf("!start.\n+!start <- argo.port(ttyACM0, [baud(115200)]); argo.limit(100); argo.percepts(open).").use { robot ->
            robot.perceives("dist(f,1)")
            val before = robot.board.requests.size
            robot.after(10.seconds)
            (robot.board.requests.size - before) shouldBe 100
        }
    }

    test("a line has the time that its rate gives it") {
        agentOf("!start.\n+!start <- argo.port(ttyACM0, [baud(300), boot(0), protocol(1)]); argo.act(ledOn).").use { robot ->
            robot.after(300.milliseconds).sent.shouldBeEmpty() // 11 bytes of 10 bits at 300 baud take 367 ms
            robot.after(100.milliseconds).sent shouldBe listOf("ledOn")
        }
    }

    test("each command has the time at which it arrived, in the order of these times over all boards") {
        val program = """
            !start.
            +!start <- argo.ports([port(ttyACM0,[protocol(1),as(slow),baud(300)]), port(ttyACM1,[protocol(1),as(quick)])]); !act.
            +!act <- .wait(5000); argo.act(slow::first); .wait(1000); argo.act(quick::second); .wait(1000); argo.act(slow::third).
        """
        agentOf(program).use { robot ->
            robot.shouldSend("third", within = 20.seconds).sent shouldBe listOf("first", "third", "second")
            robot.arrivals.map { it.command } shouldBe listOf("first", "second", "third")
            val (first, second, third) = robot.arrivals.map { it.at }
            (second - first) shouldBeGreaterThan 1.seconds
            third shouldBeLessThanOrEqualTo robot.now
            robot.board("ttyACM1").arrivals shouldBe listOf(Arrival("second", second))
        }
    }

    test("a command is expected within a time of what the test did, though it has arrived since") {
        agent("robot.asl").use { robot ->
            robot.perceives("dist(front,90)").after(2.seconds)
            val before = robot.now
            robot.perceives("dist(front,30)").after(2.seconds)
            val took = robot.arrivals.last().at - before
            took shouldBeGreaterThan Duration.ZERO
            val late = shouldThrow<AssertionError> { robot.shouldSend("stop", within = took - 1.nanoseconds, since = before) }
            late.message shouldContain "expected that agent robot sends stop from $before until ${before + took - 1.nanoseconds}\nafter"
            shouldThrow<AssertionError> { robot.shouldSend("front", within = took, since = before) }
            robot.shouldSend("stop", within = took, since = before)
            shouldThrow<AssertionError> { robot.shouldSend("stop", within = took, since = before) }
            shouldThrow<IllegalArgumentException> { robot.shouldSend("stop", within = took, since = robot.now + 1.seconds) }
                .message shouldContain "since is a past time"
        }
    }

    test("a command is awaited until its time since what the test did is over") {
        agentOf("!start.\n+!start <- argo.port(ttyACM0, [protocol(1)]); .wait(3000); argo.act(late).").use { robot ->
            val before = robot.after(2.seconds).now
            shouldThrow<AssertionError> { robot.shouldSend("late", within = 1.seconds, since = before) }
            robot.now shouldBe before + 1.seconds
            robot.shouldSend("late", within = 3.seconds, since = before)
            robot.now shouldBe robot.arrivals.single().at
        }
    }

    test("commands that leave for a played recording have their times") {
        val drive = LineRecording(listOf(LineRecording.Entry(0, LineRecording.Direction.IN, "dist(f,1);")))
        agentOf("!start.\n+!start <- argo.port(ttyACM0); .wait(2000); argo.act(go).") { board.replays(drive) }.use { robot ->
            robot.shouldSend("go", within = 5.seconds)
            robot.arrivals.single().at shouldBeGreaterThan 2.seconds
        }
    }

    test("a port leads to a line of the test's own, which goes by the test's time") {
        var line: MemoryLine? = null
        agentOf("!start.\n+!start <- argo.port(ttyACM0, [boot(0), protocol(1)]); argo.act(ledOn).") {
            board.leadsTo { port, settings, clock -> MemoryLine.paced(port, settings, clock).also { line = it }.computer() }
        }.use { robot ->
            robot.after(1.seconds)
            val arrived = ByteArray(MemoryLine.CAPACITY)
            val count = checkNotNull(line).board().read(arrived, 0, arrived.size, 0)
            String(arrived, 0, count, Charsets.ISO_8859_1) shouldEndWith "fffe05ledOn"
        }
    }

    test("a reasoning cycle takes the time that it is given") {
        agentOf("!start.\n+!start <- +a; +b; +c; .print(done).") { cycleTime = 100.milliseconds }.use { robot ->
            robot.after(250.milliseconds).printed.shouldBeEmpty()
            robot.after(100.milliseconds).shouldPrint("done", within = Duration.ZERO)
        }
    }

    test("every sensing policy works, also the one that waits within the reasoning cycle") {
        for (policy in listOf("fresh", "every", "in_cycle")) {
            agentOf("""
                !start.
                +!start <- argo.port(ttyACM0); argo.limit(20); argo.percepts(open).
                +dist(f,X) : X < 40 <- argo.act(stop).
            """) { options("argo_sensing" to policy) }.use { robot ->
                robot.perceives("dist(f,90)").shouldBelieve("dist(f,90)")
                robot.perceives("dist(f,30)").shouldSend("stop").shouldSendNothingElse()
            }
        }
    }

    test("filters of the project are used: in XML, in JSON, in Kotlin, and their rates go by the test's time") {
        agent("robot.asl").use { robot ->
            robot.hears("boss", "tellHow", "\"+!use(F) <- argo.change_filter(F).\"")
            robot.hears("boss", "achieve", "use(front)")
            robot.perceives("temp(20)", "light(3)").shouldBelieve("light(3)").shouldNotBelieve("temp(_)")
            robot.hears("boss", "achieve", "use(noLight)")
            robot.perceives("temp(21)", "light(4)").shouldBelieve("temp(21)").shouldNotBelieve("light(4)")
            robot.hears("boss", "achieve", "use(slow)")
            robot.perceives("dist(back,1)").shouldBelieve("dist(back,1)")
            robot.perceives("dist(back,2)").after(1.seconds).shouldBelieve("dist(back,2)")
        }
    }

    test("a port that is missing, held by another or forbidden fails the plan, and opens when that is over") {
        val program = """
            !start.
            +!start <- argo.port(ttyUSB0); argo.act(hello).
            -!start[error(E)] <- .print("no port: ", E); .wait(100); !start.
        """
        val troubles = mapOf<String, Board.() -> Unit>(
            "no_such_port" to { disconnects() },
            "port_busy" to { belongsTo("another program") },
            "port_permission" to { deniesAccess() },
        )
        for ((error, trouble) in troubles) agentOf(program) { board("ttyUSB0").trouble() }.use { robot ->
            robot.shouldPrint("no port: $error")
            robot.board.reconnects().admits()
            robot.shouldSend("hello")
        }
    }

    test("a board of version 2 refuses what it is not told to accept, and one that hangs leaves an action unconfirmed") {
        agentOf("""
            +!try(W) <- argo.port(ttyACM0, [protocol(2)]); argo.act(W); .print(done(W)).
            -!try(W)[error(E)] <- .print(E, " ", W).
        """) { board.version2().refuses("fly").refuses { it.startsWith("swim") } }.use { robot ->
            robot.hears("test", "achieve", "try(drive)").shouldPrint("done(drive)", within = 10.seconds)
            robot.hears("test", "achieve", "try(fly)").shouldPrint("act_refused fly", within = 10.seconds)
            robot.hears("test", "achieve", "try(swim(3))").shouldPrint("act_refused swim(3)", within = 10.seconds)
            robot.board.accepts("fly").accepts("swim(3)")
            robot.hears("test", "achieve", "try(fly)").shouldPrint("done(fly)")
            robot.hears("test", "achieve", "try(swim(3))").shouldPrint("done(swim(3))")
            robot.hears("test", "achieve", "try(swim(4))").shouldPrint("act_refused swim(4)")
            robot.board.hangs()
            robot.hears("test", "achieve", "try(drive)").shouldPrint("act_unconfirmed drive", within = 20.seconds)
        }
    }

    test("a board that speaks unasked is listened to, and one that is slow is waited for") {
        agentOf("""
            !start.
            +!start <- argo.port(ttyACM0, [mode(listen)]); argo.percepts(open).
            +bump(S) <- argo.act(back); argo.act(turned).
        """) { board.takes(3.seconds, "back") }.use { robot ->
            robot.after(1.seconds).board.says("bump(left)")
            robot.shouldBelieve("bump(left)").shouldSend("back").shouldNotSend("turned").shouldSend("turned", within = 5.seconds)
        }
    }

    test("what a board said once is said again, at its times") {
        val recording = LineRecording.read(
            """
            javino-recording 1
            0	out	getPercepts
            10	in	dist(front,90);
            5000	out	getPercepts
            5010	in	dist(front,30);
            """.trimIndent().reader(), "wall.rec",
        )
        agent("robot.asl") { board.replays(recording) }.use { robot ->
            robot.shouldSend("front").shouldNotSend("stop", during = 4.seconds)
            robot.shouldSend("stop", within = 2.seconds).shouldSendNothingElse(during = 10.seconds)
        }
        shouldThrow<IllegalArgumentException> { agent("robot.asl") { board.replays(LineRecording(emptyList())) } }.message shouldContain
            "nothing"
    }

    test("what others say is heard, and what the agent says is kept; messages to agents outside of the test are told") {
        agentOf("+!greet(A)[source(S)] <- .send(A, tell, hello(1, x)); .broadcast(untell, alone).").use { robot ->
            robot.hears("boss", "achieve", "greet(bob)")
            robot.shouldSay("tell(bob, hello(1,x))").shouldSay("untell(everybody,alone)")
            robot.hears("boss", "tell", "home(3)").shouldBelieve("home(3)[source(boss)]")
            robot.said shouldBe listOf("tell(bob,hello(1,x))", "untell(everybody,alone)")
            robot.hears("boss", "achieve", "greet(bob)").after(1.seconds)
            robot.log.single { "WARNING" in it } shouldContain "no agent bob runs in this test, so messages to it are only kept in said, " +
                "as this one: tell(bob,hello(1,x))"
            shouldThrow<IllegalArgumentException> { robot.hears("boss", "shout", "x") }.message shouldContain "achieve"
        }
    }

    test("what fails tells of how many lines of the log it has the newest, and that it describes few percepts of many") {
        agentOf("!start.\n+!start <- argo.port(ttyACM0); argo.percepts(open); for (.range(I,1,30)) { .print(line(I)) }.").use { robot ->
            robot.perceivesRaw((1..30).joinToString("") { "p$it(X);" })
            val message = shouldThrow<AssertionError> { robot.shouldSend("stop") }.message.orEmpty()
            message shouldContain Regex("log, the newest 20 lines and the errors of \\d+: ")
            message shouldContain "      p24(X) is left out"
            message shouldNotContain "      p25(X) is left out"
            message shouldContain "what becomes of the others is not described"
        }
    }

    test("what fails tells what was sent, believed, intended and logged") {
        agent("robot.asl").use { robot ->
            robot.perceives("dist(front,90)")
            val unmet = listOf<() -> Unit>(
                { robot.shouldSend("stop") },
                { robot.shouldNotSend("front") },
                { robot.shouldSendNothingElse() },
                { robot.shouldBelieve("dist(front,30)") },
                { robot.shouldNotBelieve("driving") },
                { robot.shouldIntend("dance") },
                { robot.shouldPrint("stopped") },
                { robot.shouldSay("tell(bob,x)") },
            )
            for (expectation in unmet) {
                val message = shouldThrow<AssertionError> { expectation() }.message.orEmpty()
                listOf("expected that agent robot", "sent: \n    at ", " ms: front", "dist(front,90)", "port ttyACM0 is on")
                    .forEach { message shouldContain it }
            }
        }
        agentOf("!start.\n+!start <- .wait(5000); !!never.").use { agent ->
            shouldThrow<AssertionError> { agent.shouldNotIntend("start") }.message shouldContain "!start at .wait(5000)"
            agent.intentions shouldBe listOf("!start at .wait(5000)")
        }
    }

    test("an agent that never sleeps is told from one that waits, and which intention it is") {
        shouldThrow<AssertionError> { agentOf("!think(0).\n+!think(N) <- !think(N+1).") }.message.orEmpty().let {
            it shouldContain "still busy after 10000 cycles"
            it shouldContain "!think("
        }
    }

    test("the same test gives the same result each time, to the nanosecond") {
        fun run() = agentOf("""
            !start. !blink(0). !drive.
            +!start <- argo.port(ttyACM0); argo.limit(0); argo.percepts(open).
            +!blink(N) <- argo.act(led(N)); .wait(7); !blink(N+1).
            -!blink(N) <- .wait(3); !blink(N).
            +!drive <- argo.act(front); !drive.
            -!drive <- .wait(1); !drive.
            +dist(f,X) <- argo.act(seen(X)).
        """).use { robot ->
            (1..20).forEach { robot.perceives("dist(f,$it)", "light(${it * 7 % 5})") }
            listOf(robot.now, robot.sent, robot.beliefs, robot.intentions, robot.log)
        }
        val first = run()
        check((first[1] as List<*>).size > 100) { "$first" }
        repeat(3) { run() shouldBe first }
    }

    test("what cannot be read is refused with the reason") {
        shouldThrow<IllegalArgumentException> { agent("nobody.asl") }.message shouldContain "nobody.asl"
        shouldThrow<IllegalArgumentException> { agentOf("+!start <- ") }.message shouldContain "agent.asl"
        agentOf("!start.").use { robot ->
            shouldThrow<IllegalArgumentException> { robot.shouldBelieve("dist(front") }.message shouldContain "dist(front,X)"
            shouldThrow<IllegalArgumentException> { robot.shouldIntend("3 4") }.message shouldContain "not a goal"
            shouldThrow<IllegalArgumentException> { robot.after((-1).seconds) }.message shouldContain "back"
            shouldThrow<IllegalArgumentException> { robot.board.shows("x(${"1".repeat(300)})") }.message shouldContain "version2()"
            shouldThrow<IllegalArgumentException> { robot.perceives("name(\"\u2603\")") }.message shouldContain "one byte"
        }
    }

    test("tests that run at the same time do not see each other") {
        val results = List(4) { n ->
            CompletableFuture.supplyAsync {
                agentOf(
                    "!start.\n+!start <- argo.port(ttyACM0); .print(own($n)); for (.range(I,1,50)) { argo.act(a($n,I)); .wait(100) }.",
                ).use { robot ->
                    robot.after(20.seconds)
                    robot.printed to robot.sent
                }
            }
        }.map { it.get(60, TimeUnit.SECONDS) }
        results.forEachIndexed { n, (printed, sent) ->
            printed shouldBe listOf("own($n)")
            sent shouldBe (1..50).map { "a($n,$it)" }
        }
    }

    test("after the end of a test nothing of it is left") {
        val before = Thread.getAllStackTraces().keys
        agent("robot.asl").use { it.perceives("dist(front,90)") }
        val left = (Thread.getAllStackTraces().keys - before).filter { it.name.startsWith("argo-") || it.name.startsWith("board") }
        left.forEach { it.join(60_000) }
        left.filter { it.isAlive }.shouldBeEmpty()
        agent("robot.asl").use { it.shouldBelieve("port(ttyACM0,on)") } // the port is free
    }
})
