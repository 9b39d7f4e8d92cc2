package argo.exploring

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.nulls.shouldBeNull
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import kotlin.time.Duration
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds

class RulesSpec : FunSpec({
    var number = 0L
    fun sends(at: Int, command: String) = Issued(at.milliseconds, "robot", ++number, "ttyACM0", command, "+!go, line 3")
    fun fails(sent: Issued, at: Int, error: String?) = Ended(at.milliseconds, "robot", sent.number, sent.command, error)
    fun perceives(at: Int, vararg percepts: String) =
        at.milliseconds.let { time ->
            listOf(Received(time, "robot", "ttyACM0"), Perceived(time, "robot", "ttyACM0", percepts.toList(), time))
        }
    fun run(trace: List<TraceEntry>, events: List<WorldEvent> = emptyList(), ended: Duration = 20.seconds) =
        Run(events, trace.sortedBy { it.at }, ended, listOf("robot"), emptyMap(), emptySet())
    fun steady(until: Int, vararg percepts: String) = (0..until step 100).flatMap { perceives(it, *percepts) }

    class Case(val rule: Rule, val kept: Run, val broken: Run, val at: Int)

    val lost = sends(1000, "lamp")
    val halt = sends(1000, "stop")
    val near = "dist(front,10)"
    listOf(
        Case(
            neverFloods(2), run(listOf(0, 500, 1000).map { sends(it, "a") }), run(listOf(0, 500, 999).map { sends(it, "a") }), 999,
        ),
        Case(
            neverOscillates(1),
            run(listOf(sends(0, "a"), sends(100, "b"), sends(200, "a"), sends(300, "c"))),
            run(listOf(sends(0, "a"), sends(100, "b"), sends(200, "a"), sends(300, "b"))),
            300,
        ),
        Case(
            sendsOnly(listOf("on", "speed/1", "say/*")),
            run(listOf(sends(0, "on"), sends(1, "speed(3)"), sends(2, "say(a,b)"))), run(listOf(sends(0, "on"), sends(7, "speed"))), 7,
        ),
        Case(
            losesNoCommand(2.seconds),
            run(listOf(lost, fails(lost, 1200, "port_gone"), Printed(1300.milliseconds, "robot", "no lamp"))),
            run(listOf(lost, fails(lost, 1200, "port_gone"))), 3200,
        ),
        Case(losesNoCommand(2.seconds), run(listOf(lost, fails(lost, 2900, null))), run(listOf(lost)), 3000),
        Case(
            sendsAgain(listOf("stop"), 2.seconds),
            run(steady(9000, near) + halt + fails(halt, 1200, "port_gone") + sends(3100, "stop")),
            run(steady(9000, near) + halt + fails(halt, 1200, "port_gone") + sends(3400, "stop")), 3300,
        ),
        Case(
            sendsAgain(listOf("stop"), 2.seconds),
            run(steady(2000, near) + halt + fails(halt, 1200, "port_gone") + perceives(2100, "dist(front,90)")),
            run(steady(1100, near) + halt + fails(halt, 1200, "port_gone") + perceives(5000, near) + perceives(6000, near)), 7000,
        ),
        Case(
            neverActsOnStalePercepts(1.seconds, listOf("stop")),
            run(perceives(0, near) + sends(1000, "go") + sends(5000, "stop")), run(perceives(0, near) + sends(1001, "go")), 1001,
        ),
        Case(
            stopsWhenBlind("stop", listOf("go")),
            run(steady(2000) + sends(1000, "go") + sends(3900, "stop")), run(steady(2000) + sends(1000, "go") + sends(4100, "stop")), 4000,
        ),
        Case(
            stopsWhenBlind("stop", listOf("go")),
            run(steady(2000) + sends(1000, "stop") + sends(2900, "go") + sends(3100, "stop")),
            run(steady(2000) + sends(1000, "stop") + sends(3200, "go")), 3200,
        ),
        Case(
            stopsWhenBlind("stop", listOf("go")),
            run(steady(2000) + sends(1000, "go") + perceives(4000) + sends(4100, "stop")),
            run(steady(2000) + sends(1000, "go") + perceives(4001) + sends(4100, "stop")), 4000,
        ),
        Case(
            reactsTo("dist(front,D) & D < 20", listOf("stop")),
            run(perceives(0, near) + perceives(900, "dist(front,90)")), run(perceives(0, near) + sends(1100, "stop")), 1000,
        ),
        Case(
            neverSends(listOf("go"), "dist(front,D) & D < 20"),
            run(perceives(0, near) + sends(900, "go") + perceives(1500, "dist(front,90)") + sends(1600, "go")),
            run(perceives(0, near) + sends(1100, "go")), 1100,
        ),
        Case(
            perceivesAgain(3.seconds),
            run(perceives(0) + perceives(5500), listOf(Hangs(4.seconds, "ttyACM0", 1.seconds))),
            run(perceives(0), listOf(Hangs(4.seconds, "ttyACM0", 1.seconds))), 8000,
        ),
        Case(
            actsAgain(3.seconds),
            run(listOf(sends(0, "go"), sends(5500, "go")), listOf(Hangs(4.seconds, "ttyACM0", 1.seconds))),
            run(listOf(sends(0, "go")), listOf(Hangs(4.seconds, "ttyACM0", 1.seconds))), 8000,
        ),
        Case(
            neverWaitsForever(6.seconds, listOf("home")),
            run(listOf(Waits(20.seconds, "robot", "home at .wait", 1.seconds))),
            run(listOf(Waits(20.seconds, "robot", "go at .wait", 1.seconds))), 7000,
        ),
        Case(
            staysSmall(5, 50, 5), run(listOf(MindSize(0.seconds, "robot", 50, 5, 5))),
            run(listOf(MindSize(3.seconds, "robot", 51, 1, 1))), 3000,
        ),
        Case(handlesFailures(), run(emptyList()), run(listOf(FailedUnhandled(2.seconds, "robot", "No failure event"))), 2000),
        Case(staysAlive(), run(emptyList()), run(listOf(Stopped(2.seconds, "robot"))), 2000),
    ).forEachIndexed { index, case ->
        test("${index + 1}: a run that ${case.rule.name} keeps the rule, and one that does not breaks it") {
            case.rule.breachIn(case.kept).shouldBeNull()
            case.rule.breachIn(case.broken).shouldNotBeNull().at shouldBe case.at.milliseconds
        }
    }

    test("a rule is printed as the call that makes it") {
        "${stopsWhenBlind("stop", listOf("go"))}" shouldBe "stopsWhenBlind(\"stop\", listOf(\"go\"), 1000.milliseconds, 1000.milliseconds)"
        usualRules().joinToString() shouldContain "staysAlive(), handlesFailures(), losesNoCommand(5000.milliseconds)"
    }
})
