package argo.recording

import argo.recording.replay.Recording
import argo.recording.replay.Replay
import argo.testkit.mas
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import java.nio.file.Path
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds

class ReplaySpec : FunSpec({
    test("percepts, events, commands and timers") {
        val file = recorded(
            """
            !start.
            +!start <- argo.port(ttyACM0); argo.percepts(open); !patrol.
            +!patrol <- argo.act(forward); .wait(300); !patrol.
            +dist(front,Cm) : Cm < 40 <- argo.act(stop); .print("stopped at ", Cm).
            """.trimIndent(),
        ) {
            perceives("dist(front,80)", "light(back,140)")
            after(1.seconds)
            perceives("dist(front,30)", "light(back,140)")
            shouldSend("stop")
        }
        val cycles = Recording(file).use { it.cycles("agent").toList() }
        cycles.flatMap { it.input.calls }.flatMap { it.commands }.map { it.text }.distinct() shouldBe listOf("forward", "stop")
        cycles.flatMap { it.course.printed } shouldBe listOf("stopped at 30")
        shouldReplay(file)
    }

    test("intentions that end in one cycle, and are cleared away one after the other") {
        shouldReplay(
            recorded(
                """
                !start.
                +!start <- argo.ports([ttyACM0, ttyACM1]); .wait(500); !!act(ttyACM0); !!act(ttyACM1); .wait(1000); .print(done).
                +!act(P) <- argo.act(ledOn, [port(P)]).
                """.trimIndent(),
            ) { after(2.seconds) },
        )
    }

    test("agents whose cycles overlapped, so that one counted intentions before the other read the counters of Jason") {
        shouldReplay(Path.of("src/test/resources/recordings/overlapping-cycles.mcap"))
    }

    test("what is believed in a replay is without the beliefs that Jason hides itself") {
        val file = recorded("height(12). tall :- height(M) & M > 10. !start. +!start <- +begun.") { after(1.seconds) }
        val beliefs = Recording(file).use { recording -> Replay(recording).use { it.run().beliefs("agent") } }
        beliefs.filterNot { "port(" in it }.sorted() shouldBe listOf("begun[source(self)]", "height(12)[source(self)]")
    }

    test("a seed of Jason's chance") {
        val file = recorded("!start. +!start <- .set_random_seed(5); .random(X); .print(X); .print(done).") { after(300.milliseconds) }
        Recording(file).use { it.cycles("agent").flatMap { cycle -> cycle.course.printed }.last() } shouldBe "done"
        shouldReplay(file)
    }

    test("a plan that is added and calls an action that there is not") {
        val file = recorded("""!start. +!start <- .add_plan("+!x <- foo.bar(1)."); .wait(20); .print(after).""") { after(300.milliseconds) }
        Recording(file).use { it.cycles("agent").flatMap { cycle -> cycle.course.printed }.toList() } shouldBe listOf("after")
        shouldReplay(file)
    }

    test("loops, whose steps hold a Java object") {
        shouldReplay(
            recorded(
                """
                place(north). place(east).
                !start.
                +!start <- for (place(P)) { !go(P) }; .print(done).
                +!go(P) <- .wait(20); .print(P).
                """.trimIndent(),
            ) { after(1.seconds) },
        )
    }

    test("steps that hold what changes until it is written: forks that are joined, and sets that grow") {
        shouldReplay(
            recorded(
                """
                place(north). place(east). place(south).
                !start. !fill.
                +!start <- !go(1) |&| !go(2) |&| !go(3); !go(4) ||| !go(5); .print(done).
                +!go(N) <- .wait(N * 20); .print(N).
                +!fill <- .set.create(S); for (place(P)) { .wait(30); .set.add(S, P); !show(S) }; .print(S).
                +!show(S) <- .set.add(S, shown); .wait(10).
                """.trimIndent(),
            ) { after(2.seconds) },
        )
    }

    test("clocks and chance of Jason") {
        shouldReplay(
            recorded(
                """
                !start.
                +!start <- .random(R); .nano_time(T); .time(H,M,S); X = math.random(10); Y = system.time; .shuffle([1,2,3,4,5,6],L);
                   .findall(Z, .random(Z,3), Zs); .wait(70); +drew(R,T,H,M,S,X,Y,L,Zs); .print(R,T,X,Y,L,Zs).
                @once +?chance(R) <- .random(R).
                """.trimIndent(),
            ) { after(1.seconds) },
        )
    }

    test("failures of calls, and commands that fail later") {
        shouldReplay(
            recorded(
                """
                !start.
                +!start <- !port; !limit; argo.percepts(open); !act; .wait(200); !again.
                +!port <- argo.port(ttyACM0).
                +!limit <- argo.limit(-1).
                -!limit[error(E)] <- .print(E); argo.limit(20).
                +!act <- argo.act(forward, [timeout(100)]).
                -!act[error(E),error_msg(M)] <- .print(E, M).
                +!again : argo.age(dist(_), Ms) <- .print(Ms).
                -!again[error(E)] <- .print(E).
                """.trimIndent(),
            ) {
                perceives("dist(3)")
                board.disconnects()
                after(1.seconds)
                board.reconnects()
                after(3.seconds)
            },
        )
    }

    test("mistakes in the project's actions, whether they are carried out again or not") {
        val file = recorded(
            """
            !start. !look.
            +!start <- planted.mistaken.
            -!start[error(E),error_msg(M)] <- .print(E, M).
            +!look : planted.mistaken <- .print(yes).
            +!look <- .print(no).
            """.trimIndent(),
        ) { after(300.milliseconds) }
        shouldReplay(file)
        shouldReplay(file, isChecking = true)
    }

    test("messages that wait in the mailbox, of which an agent reads one in a cycle") {
        shouldReplay(
            recorded("!start. +!start <- argo.port(ttyACM0). +go(N) <- .count(told(_), C); .print(N, C).") {
                repeat(8) { hears("boss", "tell", "told($it)") }
                repeat(3) { hears("boss", "tell", "go($it)") }
                after(300.milliseconds)
                hears("boss", "untell", "told(3)")
                hears("boss", "tell", "go(4)")
                after(300.milliseconds)
            },
        )
    }

    test("messages, questions with a time limit, and atomic plans") {
        shouldReplay(
            recorded(
                """
                !start.
                +!start <- .send(nobody, askOne, price(X), A, 300); .print(A); .broadcast(tell, ready).
                @a[atomic] +!go(N)[source(S)] <- .print(S, N); argo.port(ttyACM0); .send(S, tell, gone(N)).
                +jag_sleeping <- .print("nothing to do").
                """.trimIndent(),
            ) {
                hears("boss", "achieve", "go(1)")
                hears("boss", "tell", "note(\"a \\\"word\\\"\", [1,2], f(x))")
                after(500.milliseconds)
                hears("boss", "askOne", "note(_,_,_)")
                after(1.seconds)
            },
        )
    }

    test("a plan that is added as it runs, and calls the project's actions and chance, the recorded results of which are used") {
        val file = recorded(
            "!start. +!start <- .add_plan({ +!x <- planted.calls(X); .random(R); .print(X, R) }); .wait(20); !x.",
        ) { after(300.milliseconds) }
        val before = planted.calls.CALLS.get()
        shouldReplay(file)
        planted.calls.CALLS.get() shouldBe before
        Recording(file).use { it.cycles("agent").flatMap { cycle -> cycle.input.calls }.map { call -> call.name }.toList() } shouldBe
            listOf("planted.calls", ".random")
    }

    fun callsIn(file: Path) = Recording(file).use { recording ->
        recording.agents.keys.flatMap { recording.cycles(it).flatMap { cycle -> cycle.input.calls }.map { call -> call.name } }
    }

    test("the project's actions and chance in terms that the program makes of texts as it runs") {
        val file = recorded(
            """
            !start.
            +!start <- .term2string(A, "planted.calls(X)"); A; .term2string(B, ".random(Y)"); B; .term2string(C, "system.time");
               Z = C + 0; +held(A); ?held(H); H; .print(X, Y, Z).
            """.trimIndent(),
        ) { after(300.milliseconds) }
        callsIn(file).distinct() shouldBe listOf("planted.calls", ".random", "system.time")
        val before = planted.calls.CALLS.get()
        shouldReplay(file)
        planted.calls.CALLS.get() shouldBe before
    }

    test("the project's actions and chance in a message of an agent that is not recorded") {
        val file = recordingFile()
        mas {
            agentOf("speaker", "!start. +!start <- .send(hearer, tell, todo({ planted.calls(X); .random(R); .print(X, R) })).")
            agentOf("hearer", "+todo(Steps) <- Steps; .print(done).") { options("argo_record" to "$file") }
        }.use { it.after(1.seconds) }
        callsIn(file) shouldBe listOf("planted.calls", ".random")
        shouldReplay(file)
    }

    test("an agent that writes its plans and beliefs, as Java does, writes them as without a recording") {
        val file = recorded("!start. +!start <- .random(X); planted.writes(B); .print(B). +!y <- Y = planted.drift; .random(Y).") {
            after(300.milliseconds)
        }
        Recording(file).use { it.cycles("agent").flatMap { cycle -> cycle.course.printed }.toList() } shouldBe listOf("written")
    }
})
