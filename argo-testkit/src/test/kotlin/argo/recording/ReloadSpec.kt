package argo.recording

import argo.observing.Outcome
import argo.recording.replay.Recording
import argo.testkit.AgentSetUp
import argo.testkit.TestAgent
import argo.testkit.agent
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.nulls.shouldBeNull
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.types.shouldBeSameInstanceAs
import jason.mas2j.ClassParameters
import java.nio.file.Path
import java.time.Duration
import kotlin.io.path.deleteIfExists
import kotlin.io.path.writeText
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds

class ReloadSpec : FunSpec({
    val folder = tempdir().toPath()
    var files = 0

    fun driven(program: String, setUp: AgentSetUp.() -> Unit = {}, drive: TestAgent.(file: Path) -> Unit): Path {
        val file = folder.resolve("agent${++files}.asl").apply { writeText(program) }
        val recording = recordingFile()
        agent(file) {
            setUp()
            options("argo_record" to "$recording")
        }.use { it.drive(file) }
        return recording
    }

    fun TestAgent.reloaded(file: Path, program: String): Outcome {
        file.writeText(program)
        var outcome: Outcome? = null
        mas.open {
            observed.reload { outcome = it }
            mas.time.settle()
        }
        after(20.milliseconds)
        return outcome.shouldNotBeNull()
    }

    test("changed plans are exchanged in their order, and the others stay the same objects with the lines of the new text") {
        val recording = driven("+!a <- .print(a).\n@b +!b(X) : X > _ <- .print(b).\n+!c : p(_,_) <- .print(c).\n+!d.\n") { file ->
            val before = Programs.plansOf(this)
            reloaded(file, "// new\n+!a <- .print(aa).\n\n@b +!b(X) : X > _\n  <- .print(b).\n+!e.\n+!c : p(_,_) <- .print(c).\n").told
                .shouldContainExactly("2 plans changed; 2 are as before")
            val now = Programs.plansOf(this)
            now.map { "${it.trigger}" } shouldContainExactly listOf("+!a", "+!b(X)", "+!e", "+!c")
            now[1] shouldBeSameInstanceAs before[1]
            now[3] shouldBeSameInstanceAs before[2]
            now.map { it.trigger.literal.srcInfo.srcLine } shouldContainExactly listOf(2, 4, 6, 7)
            now[1].body.srcInfo.srcLine shouldBe 5
            hears("boss", "achieve", "a").after(50.milliseconds).printed shouldContainExactly listOf("aa")
        }
        shouldReplay(recording)
    }

    test("the belief base of an agent in a database is not asked for all beliefs") {
        val file = folder.resolve("database.asl").apply { writeText("far(3).\nis(X) :- X = a.\n+!a : is(X) <- .print(X).\n") }
        agent(file) { beliefBase = ClassParameters(planted.Unreachable::class.java.name) }.use { bob ->
            bob.reloaded(file, "far(3).\nnear(4).\nis(X) :- X = b.\n+!a : is(X) <- .print(X).\n").told shouldContainExactly listOf(
                "none of the 1 plans has changed", "rules exchanged: is/1",
                "new initial beliefs, not believed: near(4) (argo.reload([beliefs]) takes them)",
            )
            bob.hears("boss", "achieve", "a").after(50.milliseconds).printed shouldContainExactly listOf("b")
        }
    }

    test("an intention finishes the plan that it has begun, and its next goal has the new one") {
        val recording = driven("!go.\n+!go <- .wait(100); .print(old); !go.\n") { file ->
            reloaded(file, "!go.\n+!go <- .wait(100); .print(new); !go.\n").refusal.shouldBeNull()
            after(250.milliseconds).printed shouldContainExactly listOf("old", "new")
        }
        shouldReplay(recording)
    }

    test("what cannot be read changes nothing, and shows the parser's error at its line") {
        val recording = driven("+!a <- .print(a).\n") { file ->
            val before = Programs.plansOf(this)
            reloaded(file, "+!a <- .print(b).\n+!b <- .print(.\n").refusal.orEmpty() shouldContain
                "${file.fileName}: \".\" does not belong in line 2"
            reloaded(file, "@x +!a.\n@x +!b.\n").refusal.orEmpty() shouldContain "label x"
            reloaded(file, "{ include(\"none.asl\") }\n+!a.\n").refusal.orEmpty() shouldContain "the included file none.asl is not found"
            reloaded(file, "{ begin namespace(n, local) }\n+!a.\n{ end }\n").refusal.orEmpty() shouldContain "is a local namespace"
            Programs.plansOf(this) shouldContainExactly before
            beliefs.shouldBeEmpty()
        }
        shouldReplay(recording)
    }

    test("plans got at run time stay, and one of them with a label of the new program refuses it") {
        val old = "!go.\n+!go <- .add_plan(\"@late +!late <- .print(late).\"); .add_plan(\"+!first.\", self, begin).\n"
        val recording = driven(old) { file ->
            after(100.milliseconds)
            reloaded(file, "+!gone.\n").told shouldContainExactly listOf("1 plan changed; 0 are as before")
            Programs.plansOf(this).map { "${it.trigger}" } shouldContainExactly listOf("+!first", "+!gone", "+!late")
            reloaded(file, "@late +!other.\n").refusal.orEmpty() shouldContain "late"
            Programs.plansOf(this).map { "${it.trigger}" } shouldContainExactly listOf("+!first", "+!gone", "+!late")
        }
        shouldReplay(recording)
    }

    test("rules are exchanged; new beliefs and goals are offered, or taken by argo.reload") {
        val old = "limit(40). near :- dist(_, Cm) & Cm < 40. far :- not near.\n+!start <- argo.reload([beliefs, goals]).\n"
        val new = "limit(20). limit(40). colour(red). !begin.\nnear :- dist(_, Cm) & limit(L) & Cm < L. far :- not near.\n" +
            "+!begin <- .print(begun).\n" +
            "+!start <- argo.reload([beliefs, goals]).\n+dist(_, _) : near <- .print(near).\n"
        val recording = driven(old) { file ->
            reloaded(file, new).told shouldContainExactly listOf(
                "2 plans added; 1 are as before", "rules exchanged: near/0",
                "new initial beliefs, not believed: limit(20), colour(red) (argo.reload([beliefs]) takes them)",
                "new initial goals, not begun: begin (argo.reload([goals]) takes them)",
            )
            hears("boss", "tell", "dist(front, 30)").after(50.milliseconds).printed shouldContainExactly listOf("near")
            reloaded(file, new).told shouldContainExactly listOf(
                "none of the 3 plans has changed",
                "new initial beliefs, not believed: limit(20), colour(red) (argo.reload([beliefs]) takes them)",
                "new initial goals, not begun: begin (argo.reload([goals]) takes them)",
            )
            file.writeText("$new\ncolour(blue). !again. +!again <- .print(again).")
            hears("boss", "achieve", "start").after(100.milliseconds)
            shouldBelieve("colour(blue)").shouldBelieve("limit(20)").printed shouldContainExactly listOf("near", "begun", "again")
            reloaded(file, "$new\ncolour(blue). !again. +!again <- .print(again).").told shouldContainExactly
                listOf("none of the 4 plans has changed")
        }
        shouldReplay(recording)
    }

    test("a belief is taken with its annotations; a goal that the agent refuses is told, and offered again") {
        val plan = "+!start <- argo.reload([beliefs, goals]).\n"
        val new = "speed(3)[unit(cm)]. !patrol.\n$plan"
        val recording = driven("speed(3).\n$plan") { file ->
            file.writeText(new)
            hears("boss", "achieve", "start").after(100.milliseconds).shouldBelieve("speed(3)[unit(cm)]")
            log shouldContain "WARNING of the new initial goals, patrol is not begun: the agent has no plan for +!patrol/0"
            reloaded(file, new).told shouldContainExactly listOf(
                "none of the 1 plans has changed", "new initial goals, not begun: patrol (argo.reload([goals]) takes them)",
            )
        }
        shouldReplay(recording)
    }

    test("a recording that has lost its beginning, and the reload, is replayed from a key frame") {
        val plans = "!start.\n+!start <- argo.port(ttyACM0); argo.percepts(open); !tick(0).\n+!tick(N) <- .wait(200); !tick(N + 1).\n"
        val old = "${plans}near :- dist(front, Cm) & Cm < 40.\n+dist(front, Cm) : near <- argo.act(stop).\n" +
            "+dist(front, Cm) <- .print(Cm).\n"
        val new = "// new\n\n${plans}near :- dist(front, Cm) & Cm < 60.\n+dist(front, Cm) : near <- .print(near); argo.act(halt).\n" +
            "+dist(front, Cm) <- .print(Cm).\n"
        val recording = driven(old) { file ->
            repeat(24) {
                if (it == 4) reloaded(file, new).refusal.shouldBeNull()
                perceives("dist(front,${30 + it * 7 % 50})").after(500.milliseconds)
            }
        }
        val ring = ringOf(recording, Duration.ofSeconds(6))
        Recording(ring).use { it.start(it.agents.keys.single()).shouldNotBeNull() }
        replayOf(ring).differences.shouldBeEmpty()
    }

    test("included files are read anew; plans of one that is not included any more are removed") {
        folder.resolve("part.asl").writeText("+!p <- .print(p).\nq(X) :- r(X).\n")
        val recording = driven("{ include(\"part.asl\") }\n{ include(\"part.asl\", other) }\n+!a.\n", { sourcePath("$folder") }) { file ->
            folder.resolve("part.asl").writeText("\n+!p <- .print(pp).\nq(X) :- r(X) & s.\n")
            reloaded(file, "{ include(\"part.asl\") }\n{ include(\"part.asl\", other) }\n+!a.\n").told shouldContainExactly
                listOf("2 plans changed; 1 are as before", "rules exchanged: q/1, other::q/1")
            hears("boss", "achieve", "p").after(50.milliseconds).printed shouldContainExactly listOf("pp")
            observed.sources().map { "${it.fileName}" } shouldContainExactly listOf("${file.fileName}", "part.asl", "part.asl").distinct()
            reloaded(file, "+!a.\n").told shouldContain "2 plans removed; 1 are as before"
            Programs.plansOf(this).map { "${it.trigger}" } shouldContainExactly listOf("+!a")
        }
        shouldReplay(recording)
    }

    test("a file that is included anew, but is missing or has a mistake, is one of the agent's files, and so are those before") {
        folder.resolve("wrong.asl").writeText("+!b <- .print(.\n")
        driven("+!a.\n", { sourcePath("$folder") }) { file ->
            reloaded(file, "{ include(\"wrong.asl\") }\n+!a.\n").refusal.orEmpty() shouldContain "wrong.asl"
            observed.sources() shouldContainExactly listOf(file, folder.resolve("wrong.asl"))
            reloaded(file, "{ include(\"none.asl\") }\n+!a.\n").refusal.orEmpty() shouldContain "none.asl"
            observed.sources() shouldContain folder.resolve("none.asl")
            folder.resolve("none.asl").writeText("+!b.\n")
            reloaded(file, "{ include(\"none.asl\") }\n+!a.\n").told shouldContainExactly listOf("1 plan added; 1 are as before")
            observed.sources() shouldContainExactly listOf(file, folder.resolve("none.asl"))
        }
    }

    test("rules of a file that has only rules are removed when it is not included any more") {
        folder.resolve("rules.asl").writeText("near :- dist(_, Cm) & Cm < 40.\n")
        val recording = driven("{ include(\"rules.asl\") }\n+!a.\n", { sourcePath("$folder") }) { file ->
            reloaded(file, "+!a.\n").told shouldContainExactly listOf("none of the 1 plans has changed", "rules exchanged: near/0")
            beliefs.shouldBeEmpty()
        }
        shouldReplay(recording)
    }

    test("a board that perceives everything still does when the agent's filter is read anew") {
        val program = "!go.\n+!go <- argo.ports([ttyACM0, ttyACM1]); argo.change_filter(agents); " +
            "argo.change_filter(none, [port(ttyACM1)]); argo.percepts(open).\n"
        fun filter(at: String) = "<PerceptionFilter><filter><predicate>dist</predicate>" +
            "<parameter operator=\"NE\" id=\"0\">$at</parameter></filter></PerceptionFilter>"
        folder.resolve("agents.xml").writeText(filter("front"))
        val boards: AgentSetUp.() -> Unit = {
            board("ttyACM0").shows("dist(front,1)", "dist(back,2)")
            board("ttyACM1").shows("dist(side,3)")
        }
        driven(program, boards) { file ->
            shouldBelieve("dist(front,1)").shouldBelieve("dist(side,3)")
            folder.resolve("agents.xml").writeText(filter("back"))
            reloaded(file, program).told shouldContain "filters read anew: agents"
            shouldBelieve("dist(back,2)").shouldNotBelieve("dist(front,1)", 100.milliseconds).shouldBelieve("dist(side,3)", 0.seconds)
        }
    }

    test("an active filter is read anew, and a broken one refuses the program too") {
        val program = "!go.\n+!go <- argo.port(ttyACM0); argo.change_filter(narrow); argo.percepts(open).\n"
        fun filter(at: String) = "<PerceptionFilter><filter><predicate>dist</predicate>" +
            "<parameter operator=\"NE\" id=\"0\">$at</parameter></filter></PerceptionFilter>"
        folder.resolve("narrow.xml").writeText(filter("front"))
        val recording = driven(program, { board("ttyACM0").shows("dist(front,1)", "dist(back,2)") }) { file ->
            shouldBelieve("dist(front,1)").shouldNotBelieve("dist(back,2)", 100.milliseconds)
            folder.resolve("narrow.xml").writeText(filter("back"))
            reloaded(file, program).told shouldContainExactly listOf("none of the 1 plans has changed", "filters read anew: narrow")
            shouldBelieve("dist(back,2)").shouldNotBelieve("dist(front,1)", 100.milliseconds)
            folder.resolve("narrow.xml").writeText("<PerceptionFilter><wrong/></PerceptionFilter>")
            reloaded(file, "+!other.\n").refusal.orEmpty() shouldContain "narrow.xml"
            Programs.plansOf(this).size shouldBe 1
            folder.resolve("narrow.xml").deleteIfExists()
            reloaded(file, program).told shouldContain "the filter narrow is not found any more; the agent keeps it as it was"
            after(1.seconds)
        }
        shouldReplay(recording)
    }
})
