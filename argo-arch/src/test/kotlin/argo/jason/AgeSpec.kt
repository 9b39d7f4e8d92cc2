package argo.jason

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain

private const val LIMIT_MS = 20_000

class AgeSpec : FunSpec({
    test("a percept that the board repeats stays young, though it causes no event") {
        onRobot("dist(f,38);light(b,140);") { board, mas ->
            mas.agent("bob", """
                !start.
                +!start <- argo.port("sim:robot", [boot(0)]); argo.limit(5); argo.percepts(open).
                +dist(f,38) <- .wait(1500); ?again(30); argo.act(young).
                +?again(0) <- .fail.
                +?again(N) : argo.age(dist(f,38), Ms) & Ms < 1000.
                +?again(N) <- .wait(10); ?again(N-1).
            """)
            board.awaitMessage("young", LIMIT_MS)
        }
    }

    test("a percept that is not repeated grows old, also while it is frozen, and the youngest match is bound") {
        onRobot("dist(f,38);light(b,140);light(f,7);") { board, mas ->
            mas.file("filters/dark.xml", """<PerceptionFilter onSwitch="freeze"><filter><predicate>light</predicate><parameter id="0">b</parameter></filter></PerceptionFilter>""")
            mas.agent("bob", """
                !start.
                +!start <- argo.port("sim:robot", [boot(0)]); argo.limit(5); argo.percepts(open).
                +dist(f,38) <- argo.change_filter(dark); .wait(400); ?light(b,140);
                               argo.age(light(b,X), Old); argo.age(light(S,Y), Young); argo.act(ages(X,S,Y)); +old(Old); +young(Young); argo.act(done).
            """)
            board.awaitMessage("done", LIMIT_MS)
            board.received() shouldContain "ages(140,f,7)"
            val beliefs = mas.beliefs("bob").joinToString("\n")
            fun age(name: String) = Regex("""(?m)^$name\(([0-9.]+)\)$""").find(beliefs)!!.groupValues[1].toDouble()
            check(age("old") >= 350) { beliefs }
            check(age("young") < age("old")) { beliefs }
        }
    }

    test("what is no percept of a board is no context's, and fails a plan's step with the reason") {
        onRobot("dist(f,38);") { board, mas ->
            mas.agent("bob", """
                own(1).
                dist(b,7).
                !start.
                +!start <- argo.port("sim:robot", [boot(0)]); argo.limit(5); argo.percepts(open).
                +dist(f,38) <- !context(own(1)); !context(dist(b,_)); !context(nowhere(X)); !context(dist(f,39));
                               !step(own(_)); !step(weather(rain)); !step(Unbound); !step(5); !step([a]);
                               argo.age(dist(_,X), Ms); .print("youngest ", X);
                               if (argo.age(own(_),_)) { .print("ODD") }; .print(finished).
                +!context(P) : argo.age(P, Ms) <- .print("ODD ", P, Ms).
                +!context(P) : not argo.age(P, _) <- .print("no context ", P).
                +!step(P) <- argo.age(P, Ms); .print("ODD ", P, Ms).
                -!step(P)[error(E),error_msg(M)] <- .print("<", E, " ", M, ">").
            """)
            mas.perceive("weather(rain)")
            eventually({ mas.log }) { "finished" in mas.log }
            mas.log.lines().filter { "ODD" in it || "SEVERE" in it } shouldBe emptyList()
            Regex("no context").findAll(mas.log).count() shouldBe 4
            mas.log shouldContain "<not_perceived argo.age(own("
            mas.log shouldContain "<not_perceived argo.age(weather(rain)"
            Regex("<wrong_arguments argo.age").findAll(mas.log).count() shouldBe 3
            mas.log shouldContain "youngest 38"
        }
    }

    for (form in listOf("argo.", ".", ".argo.")) test("${form}age is the same") {
        onRobot("dist(f,38);~open(door);") { board, mas ->
            mas.agent("bob", """
                !start.
                +!start <- argo.port("sim:robot", [boot(0)]); argo.limit(5); argo.percepts(open).
                +~open(door) : ${form}age(~open(D), Ms) & Ms >= 0 <- argo.act(is_young(D)).
            """)
            board.awaitMessage("is_young(door)", LIMIT_MS)
        }
    }
})
