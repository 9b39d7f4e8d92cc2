package argo.behaviour

import argo.testkit.AgentSetUp
import argo.testkit.TestAgent
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainInOrder
import io.kotest.matchers.comparables.shouldBeLessThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import javino.wire.CriticalReport
import javino.wire.FrameKind
import javino.wire.ReflexOutcome
import javino.wire.WireFrame
import kotlin.time.Duration
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds

class BoardRulesSpec : FunSpec({
    val project = Project(tempdir().toPath())
    val near = """<critical reflex="stop"><predicate>dist</predicate><parameter id="1" operator="LT">15</parameter></critical>"""
    val hot = """<critical reflex="fan"><predicate>temp</predicate><parameter id="0" operator="GT">80</parameter></critical>"""
    val odd = """<critical reflex="look"><predicate>seen</predicate><parameter id="0" operator="MATCHES">c.t</parameter></critical>"""
    project.filter("careful", near)
    project.filter("all", near + hot + odd)

    fun TestAgent.isTo(goal: String) = hears("user", "achieve", goal)

    fun bob(filter: String, interval: Int, setUp: AgentSetUp.() -> Unit) = project.agent("""
        !start.
        +!start <- argo.port(ttyACM0, [baud(115200)]); argo.limit($interval); argo.change_filter($filter); argo.percepts(open).
        +!explain(P) <- argo.explain(P, Why); .print(Why).
        +!slow <- argo.limit(600000).
        +dist(f,X) : X < 15 <- argo.act(saw(X)).
        +dist(f,X) <- +saw(X).
        +reflex(C,O) <- .print(C, " ", O).
    """, setUp).apply { shouldBelieve("saw(90)", within = 5.seconds).after(1.seconds) }

    test("the board reacts within a round of its program, and the agent is told at once, however rarely it asks") {
        var nearAt = Duration.INFINITE
        bob("careful", 2000) {
            board.version2().holdsRules(4).shows { at -> listOf(if (at < nearAt) "dist(f,90)" else "dist(f,9)", "light(4)") }
        }.use { bob ->
            nearAt = bob.now + 100.milliseconds
            val asked = bob.after(90.milliseconds).board.requests.size
            bob.after(16.milliseconds).board.commands shouldContain "stop"
            bob.shouldBelieve("dist(f,9) & light(4) & reflex(stop,done)", within = 20.milliseconds)
            bob.shouldSend("saw(9)", within = 20.milliseconds)
            bob.board.requests.size shouldBe asked
        }
    }

    test("a change of the interval takes effect at once while rules are on the board") {
        bob("careful", 1000) { board.version2().holdsRules(4).shows("dist(f,90)") }.use { bob ->
            bob.isTo("slow").after(5.seconds)
            val asked = bob.board.requests.size
            bob.after(20.seconds).board.requests.size shouldBe asked
        }
    }

    test("what does not fit on the board or cannot be watched by it is watched by the computer") {
        bob("all", 20) { board.version2().holdsRules(1).shows("dist(f,90)", "temp(20)", "seen(dog)") }.use { bob ->
            val watchers = mapOf("dist(f,3)" to "the board", "temp(99)" to "the computer", "seen(cat)" to "the computer")
            for ((percept, watcher) in watchers) {
                bob.isTo("explain($percept)").after(50.milliseconds).printed.last() shouldContain "; $watcher watches it"
            }
            bob.board.shows("dist(f,9)", "temp(99)", "seen(cat)")
            bob.shouldBelieve("reflex(stop,done) & reflex(fan,done) & reflex(look,done)", within = 300.milliseconds).after(300.milliseconds)
            bob.board.commands.sorted() shouldBe listOf("fan", "look", "saw(9)", "stop")
        }
    }

    test("observers are told who carried a reflex out") {
        bob("all", 20) {
            options("argo_diary" to "reflexes")
            board.version2().holdsRules(1).shows("dist(f,90)", "temp(20)")
        }.use { bob ->
            bob.board.shows("dist(f,9)", "temp(99)")
            bob.shouldBelieve("reflex(stop,done) & reflex(fan,done)", within = 300.milliseconds)
            val diary = DiaryProvider.opened.getValue("reflexes")
            diary.lines.toList() shouldContain "reflex stop by the board well"
            diary.lines.toList().shouldContainInOrder("issued ${diary.numberOf("fan")} fan on ttyACM0", "reflex fan by the computer well")
            diary.agent.criticalRules().map { it.watcher.word } shouldBe listOf("the board", "the computer", "the computer")
        }
    }

    test("whatever a board claims in a report costs itself alone") {
        bob("careful", 20) { board.version2().holdsRules(4).shows("dist(f,90)") }.use { bob ->
            val claims = listOf("dist(", ";;", "X;", "port(ttyACM0,off);", "reflex(stop,done);", "\u0000\u00FF;", "", "x".repeat(250) + ";")
            for (claim in claims) for (rule in listOf(0, 1, 2, 255)) {
                bob.board.reports(CriticalReport(rule, ReflexOutcome.CARRIED_OUT, claim))
                bob.after(50.milliseconds)
            }
            bob.beliefs shouldContain "dist(f,90)"
            bob.beliefs shouldContain "port(ttyACM0,on)"
            bob.board.shows("dist(f,9)")
            bob.shouldBelieve("reflex(stop,done)", within = 100.milliseconds)
            bob.board.commands.count { it == "stop" } shouldBe 1
        }
    }

    test("a flood of reports neither stops the agent nor fills its beliefs") {
        bob("careful", 20) { board.version2().holdsRules(4).shows("dist(f,90)") }.use { bob ->
            repeat(150) {
                bob.board.reports(CriticalReport(1, ReflexOutcome.NONE, "noise(${"n".repeat(it % 200 + 1)});"))
                bob.after(1.milliseconds)
            }
            bob.after(2.seconds).beliefs.size shouldBeLessThan 100
            bob.beliefs.filter { "noise" in it } shouldBe emptyList()
            bob.board.shows("dist(f,9)")
            bob.shouldBelieve("reflex(stop,done)", within = 200.milliseconds)
        }
    }
})

private fun Diary.numberOf(text: String) = lines.first { it.startsWith("issued") && " $text " in it }.split(" ")[1]

/** Puts [report] on the board's line, as if one of its rules had just been met. */
private fun argo.testkit.Board.reports(report: CriticalReport) = disturbs(WireFrame.of(FrameKind.CRITICAL, 0, report.payload()))
