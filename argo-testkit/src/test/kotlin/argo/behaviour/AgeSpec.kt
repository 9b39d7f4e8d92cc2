package argo.behaviour

import argo.testkit.agentOf
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldStartWith
import jason.asSyntax.ASSyntax
import jason.environment.Environment
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds

class AgeSpec : FunSpec({
    val project = Project(tempdir().toPath())
    val start = "!start.\n+!start <- argo.port(ttyACM0, [boot(0)]); argo.limit(5); argo.percepts(open)."

    test("a percept that the board repeats stays young, though it causes no event") {
        agentOf("$start\n+dist(f,38) <- argo.act(event).").use { bob ->
            bob.perceives("dist(f,38)", "light(b,140)").shouldSend("event").after(5.seconds)
            bob.shouldBelieve("argo.age(dist(f,38), Ms) & Ms < 50", within = 0.seconds).shouldSendNothingElse()
        }
    }

    test("a percept that is not repeated grows old, also while it is frozen, and the youngest match is bound") {
        project.file(
            "filters/dark.xml",
            """
            <PerceptionFilter onSwitch="freeze">
              <filter><predicate>light</predicate><parameter id="0">b</parameter></filter>
            </PerceptionFilter>
            """.trimIndent(),
        )
        project.agent("""
            $start
            +!dark <- argo.change_filter(dark).
            +!ages <- argo.age(light(b,X), Old); argo.age(light(S,Y), Young); .print(ages(X,S,Y)).
        """).use { bob ->
            bob.perceives("dist(f,38)", "light(b,140)", "light(f,7)").hears("user", "achieve", "dark").after(400.milliseconds)
            bob.shouldBelieve("light(b,140)", within = 0.seconds).hears("user", "achieve", "ages").shouldPrint("ages(140,f,7)")
            bob.shouldBelieve("argo.age(light(b,_), Old) & Old >= 400 & Old < 450", within = 0.seconds)
            bob.shouldBelieve("argo.age(light(_,_), Young) & Young < 50", within = 0.seconds)
        }
    }

    test("what is no percept of a board is no context's, and fails a plan's step with the reason") {
        val weather = Environment()
        agentOf("""
            own(1).
            dist(b,7).
            $start
            +dist(f,38) <- !context(own(1)); !context(dist(b,_)); !context(nowhere(X)); !context(dist(f,39));
                           !step(own(_)); !step(weather(rain)); !step(Unbound); !step(5); !step([a]);
                           argo.age(dist(_,X), Ms); .print("youngest ", X);
                           if (argo.age(own(_),_)) { .print("ODD") }; .print(finished).
            +!context(P) : argo.age(P, Ms) <- .print("ODD ", P, Ms).
            +!context(P) : not argo.age(P, _) <- .print("no context ", P).
            +!step(P) <- argo.age(P, Ms); .print("ODD ", P, Ms).
            -!step(P)[error(E),error_msg(M)] <- .print("<", E, " ", M, ">").
        """) { environment = weather }.use { bob ->
            weather.addPercept(ASSyntax.parseLiteral("weather(rain)"))
            bob.perceives("dist(f,38)").shouldPrint("finished").shouldBelieve("weather(rain)")
            bob.log.filter { "ODD" in it || "SEVERE" in it }.shouldBeEmpty()
            val printed = bob.printed.joinToString("\n")
            Regex("no context").findAll(printed).count() shouldBe 4
            printed shouldContain "<not_perceived argo.age(own("
            printed shouldContain "<not_perceived argo.age(weather(rain)"
            Regex("<wrong_arguments argo.age").findAll(printed).count() shouldBe 3
            printed shouldContain "youngest 38"
        }
    }

    test("called through a variable it fails a step with the reason too") {
        agentOf("""
            $start
            +dist(f,38) <- !step(argo.age(nope(_), A)); !test(argo.age(nope(_), B)); G = argo.age(dist(_,X), Ms); G; .print("found ", X).
            +!step(G) <- G; .print("ODD").
            -!step(_)[error(E),error_msg(M)] <- .print("<", E, " ", M, ">").
            +!test(G) <- ?G; .print("ODD").
            -!test(_)[error(E)] <- .print("test ", E).
        """).use { bob ->
            bob.perceives("dist(f,38)").shouldPrint("found 38")
            bob.printed[0] shouldContain "<not_perceived argo.age(nope(_"
            bob.printed[0] shouldContain "no percept of a board that is believed now unifies with nope(_"
            bob.printed[1] shouldStartWith "test "
            bob.log.filter { "ODD" in it || "SEVERE" in it }.shouldBeEmpty()
        }
    }

    for (form in listOf("argo.", ".", ".argo.")) test("${form}age is the same") {
        agentOf("$start\n+~open(door) : ${form}age(~open(D), Ms) & Ms >= 0 <- argo.act(is_young(D)).").use { bob ->
            bob.perceives("dist(f,38)", "~open(door)").shouldSend("is_young(door)")
        }
    }
})
