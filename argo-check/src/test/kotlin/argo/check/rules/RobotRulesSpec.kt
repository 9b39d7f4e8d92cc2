package argo.check.rules

import argo.check.findings.Level
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.string.shouldContain

class RobotRulesSpec : FunSpec({
    val root = tempdir().toPath()
    val mas = "robot.mas2j" to "MAS robot { agents: robot agentArchClass argo.Arch; }"
    val percepts = "percepts" to "# a robot\ndist(front|back, cm 0..400)\nlight(f|b, % 0..100)\ntemp(-40..125)\nready\n"
    val sketch = "robot.ino" to
        "javino.act[\"front\"] = front;\njavino.act[\"stop\"] = stop;\n" +
        "javino.onAction(\"speed\", speed, 1);\njavino.onAction(\"say\", say);"
    fun found(agent: String, vararg others: Pair<String, String>) =
        findingsIn(root, mas, percepts, sketch, "robot.asl" to agent, *others).filter { it.level != Level.HINT }.map { it.inShort }

    test("the old fault of the robot with four wheels: its light is in percent, and its agent's lamp goes on above 100") {
        val agent = "+light(f,Level) : Level > 100 <- argo.act(speed(Level))."
        found(agent) shouldContainExactly listOf(
            "1:19 percept-range: Level is % 0..100$NEVER",
        )
        found(agent.replace("> 100", "> 90")).shouldBeEmpty()
    }

    context("what the board does not have is found") {
        listOf(
            "+dits(front,D) <- .print(D)." to "1:2 belief-unknown: dits/2 is awaited and never believed; did you mean dist?",
            "+dist(D) <- .print(D)." to
                "1:2 percept-arity: the board has dist(front|back, cm 0..400), and here dist has 1 arguments; correct the arguments",
            "+dist(fornt,D) <- .print(D)." to
                "1:7 percept-value: argument 1 of dist is fornt, none of front, back: the board has $DIST; correct it",
            "+dist(front,500) <- .print(x)." to
                "1:13 percept-value: argument 2 of dist is 500, more than 400: the board has $DIST; correct it",
            "+temp(T) <- if (200 < T) { .print(T) }." to
                "1:17 percept-range: T is -40..125$NEVER",
            "+humidity(H) <- .print(H)." to
                "1:2 percept-unknown: no board of the project has the percept humidity/1, and no agent believes or sends it; " +
                "the boards have dist, light, temp, ready",
            "+ready <- argo.act(sotp)." to "1:20 action-unregistered: no board of the project has the action sotp/0; did you mean stop?",
            "+ready <- argo.act(speed)." to "1:20 action-unregistered: no board of the project has the action speed/0; there is speed/1",
        ).forEach { (agent, finding) -> test(agent) { withClue(found(agent)) { found(agent) shouldContainExactly listOf(finding) } } }
    }

    context("what the board has is not told of") {
        listOf(
            "+dist(front,D) : D < 40 <- argo.act(stop).",
            "+temp(T) : T > 30 & ready <- argo.act(speed(T)); argo.act(say(a,b)).",
            "+ready : temp(T) & (T < -3 | T > 100) <- argo.act(\"speed(3)\").",
            "+ready <- argo.act(\"speed(\\\"a,b\\\")\").",
            "+left::dist(front,D) : D < 40 <- .print(D).",
            "+ready : argo.can(wave(_)) <- argo.act(wave(3)).",
            "+ready <- if (argo.can(A)) { argo.act(wave(3)); .print(A) }.",
            "+port(P,S) <- .print(P,S). +stale(P) <- .print(P). +reflex(stop,done) <- .print(x).",
        ).forEach { agent -> test(agent) { found(agent).shouldBeEmpty() } }
    }

    test("what was observed for a while counts less than what is described") {
        fun levels(percepts: String) = findingsIn(
            root, mas, "percepts" to percepts,
            "robot.asl" to "+dist(left,D) : D > 400 <- .print(D). +dist(D) <- .print(D). +temp(T) <- .print(T).",
        ).map { "${it.level} ${it.rule}" }
        val rules = listOf("percept-value", "percept-range", "percept-arity", "percept-unknown")
        levels("dist(front, 3..90)") shouldContainExactly rules.map { "WARNING $it" }
        levels("dist(front, 3..90) # observed") shouldContainExactly rules.map { "HINT $it" }
    }

    test("a command that no line of a board carries is found, unless the robot speaks ROS") {
        val long = "say(\"" + "x".repeat(300) + "\")"
        fun of(command: String, port: String = "ttyACM0") =
            findingsIn(root, mas, "robot.asl" to "+ready <- argo.port($port); argo.act($command).").filter { it.rule == "act" }
                .map { it.what }
        of("getPercepts").single() shouldContain "request for percepts"
        of("say(\"fffe05hello\")").single() shouldContain "fffe05"
        of(long).single() shouldContain "255"
        of("say(\"fffe\")").shouldBeEmpty()
        of(long, "\"ros://robot:9090\"").shouldBeEmpty()
    }

    test("beliefs and goals of the project file are known") {
        val initial = "robot.mas2j" to
            "MAS robot { agents: robot [beliefs=\"limit(2), says(\\\"a,b\\\")\", goals=\"go\"] agentArchClass argo.Arch; }"
        val agent = "robot.asl" to "+!go : limit(L) & says(T) <- .print(L,T)."
        findingsIn(root, initial, percepts, sketch, agent).shouldBeEmpty()
        findingsIn(root, mas, percepts, sketch, agent).map { it.rule } shouldContain "percept-unknown"
    }

    test("a reflex that no board knows is found, in the line of the filter") {
        val filter = "<PerceptionFilter>\n<critical reflex=\"sotp\">\n<predicate>dist</predicate></critical></PerceptionFilter>"
        found("+ready <- argo.change_filter(near).", "filters/near.xml" to filter) shouldContainExactly
            listOf("2:1 reflex: no board of the project has the action sotp; did you mean stop?")
    }

    test("a filter that drops what a plan waits for is found, if no other of the agent's filters lets it through") {
        val front = "filters/front.xml" to
            "<PerceptionFilter><filter><predicate>temp</predicate></filter><filter><predicate>dist</predicate>" +
            "<parameter operator=\"NE\" id=\"0\">front</parameter></filter></PerceptionFilter>"
        val agent = "+ready <- argo.change_filter(front).\n+dist(back,D) <- .print(D).\n+dist(S,D) <- .print(S,D).\n+temp(T) <- .print(T)."
        found(agent, front) shouldContainExactly listOf(
            "2:2 filter-drops: filter front drops dist/2, which this plan waits for; change the filter, or remove the plan",
            "4:2 filter-drops: filter front drops temp/1, which this plan waits for; change the filter, or remove the plan",
        )
        found("$agent\n-ready <- argo.change_filter(none).", front).shouldBeEmpty()
    }

    test("a filter may let a percept through that is behind its first limit and not at the second one") {
        fun filter(until: String) = "filters/near.xml" to "<PerceptionFilter keep='true'><filter><predicate>dist</predicate>" +
            "<parameter id='1' operator='LT' $until>40</parameter></filter><filter><predicate>ready</predicate></filter></PerceptionFilter>"
        val agent = "+ready <- argo.change_filter(near).\n+dist(front,43) <- .print(a)."
        found(agent, filter("")).single() shouldContain "filter-drops"
        found(agent, filter("until='45'")).shouldBeEmpty()
    }

    test("a line of a file of percepts that cannot be read is told of") {
        findingsIn(root, mas, "robot.asl" to "",
            "percepts" to "# a comment\ndist(cm 0..400)\nlight[1]\n").map { "${it.place.begin} ${it.rule}" } shouldContainExactly
            listOf("3:1 percepts-file")
    }

    test("an option of the architecture without the architecture is found") {
        findingsIn(root, "a.mas2j" to "MAS a { agents: a [argo_view=8080]; }", "a.asl" to "").map { it.inShort } shouldContainExactly
            listOf("1:20 no-architecture: argo_view has no effect; a … agentArchClass argo.Arch;")
    }
})

private const val DIST = "dist(front|back, cm 0..400)"
private const val NEVER = " as the board describes it, so that this is never true; compare with a number in the range"
