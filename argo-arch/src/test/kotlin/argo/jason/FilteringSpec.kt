package argo.jason

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainAll
import io.kotest.matchers.collections.shouldNotContain
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import javino.sim.FakeBoard
import java.util.logging.Level
import java.util.logging.Logger

private const val LIMIT_MS = 20_000

class FilteringSpec : FunSpec({
    fun TestMas.filter(name: String, rules: String) =
        file("filters/$name.xml", "<?xml version=\"1.0\"?>\n<PerceptionFilter>$rules</PerceptionFilter>\n")

    val onlyFront = "<filter><predicate>light</predicate></filter>" +
        "<filter><predicate>dist</predicate><parameter operator=\"NE\" id=\"0\">f</parameter></filter>"

    test("a filter keeps percepts from the agent from the next perception on, and never the state of the port") {
        FakeBoard.plugIn("robot").use { board ->
            var n = 0
            board.whenAsked("getPercepts").answer { "dist(f,${++n});dist(b,$n);light(f,$n);" }
            TestMas().use { mas ->
                mas.filter("onlyFront", onlyFront + "<filter><predicate>port</predicate></filter>")
                mas.agent("bob", """
                    !start.
                    +!start <- argo.port("sim:robot"); argo.limit(5); argo.percepts(open).
                    +light(f,_) : not filtered <- +filtered; argo.change_filter(onlyFront).
                    +dist(f,X) : filtered & not light(_,_) & not dist(b,_) <- argo.act(ok(X)); argo.percepts(block).
                """)
                check(board.awaitMessage(LIMIT_MS).startsWith("ok("))
                val beliefs = mas.beliefs("bob")
                beliefs shouldContain "port(\"sim:robot\",on)"
                beliefs.filter { it.startsWith("light") || it.startsWith("dist(b") } shouldBe emptyList()
                board.lenient()
            }
        }
    }

    test("a file that is refused leaves the active filter as it was, and the message has every problem") {
        FakeBoard.plugIn("robot").use { board ->
            var n = 0
            board.whenAsked("getPercepts").answer { "dist(f,${++n});light(f,$n);" }
            TestMas().use { mas ->
                mas.filter("onlyFront", onlyFront)
                mas.filter("broken", "\n<filter><predicate>dist</predicate><parameter operator=\"NEQ\" id=\"0\">f</parameter></filter>\n<filter/>")
                mas.agent("bob", """
                    !start.
                    +!start <- argo.port("sim:robot"); argo.limit(5); argo.change_filter("onlyFront.xml"); argo.change_filter(broken).
                    -!start[error(E),error_msg(M)] <- .print(E, " ", M); argo.percepts(open).
                    +dist(f,X) : X > 3 & not light(_,_) <- argo.act(ok); argo.percepts(block).
                """)
                board.awaitMessage("ok", LIMIT_MS)
                mas.log shouldContain "bad_filter argo.change_filter(broken): "
                mas.log shouldContain "NEQ"
                mas.log shouldContain "broken.xml:3:"
                mas.log shouldContain "broken.xml:4:"
                board.lenient()
            }
        }
    }

    for (arch in listOf(null, "argo.Arch")) {
        test("percepts of a Jason environment are filtered for an agent with architecture ${arch ?: "of its own"}") {
            TestMas().use { mas ->
                mas.filter("onlyFront", onlyFront)
                mas.perceive("dist(f,1)", "dist(b,2)", "light(f,3)")
                mas.agent("bob", """
                    +!look(F) <- argo.change_filter(F).
                    +dist(b,2) <- .print(back).
                """, arch)
                eventually({ mas.beliefs("bob") }) { "light(f,3)" in mas.beliefs("bob") }
                mas.achieve("bob", "look(onlyFront)")
                eventually({ mas.beliefs("bob") }) { "light(f,3)" !in mas.beliefs("bob") }
                mas.beliefs("bob") shouldContain "dist(f,1)"
                mas.beliefs("bob") shouldNotContain "dist(b,2)"
                mas.achieve("bob", "look(none)") // the environment has not changed, so it says nothing new
                eventually({ mas.beliefs("bob") }) { "light(f,3)" in mas.beliefs("bob") }
                mas.beliefs("bob") shouldContainAll listOf("dist(f,1)", "dist(b,2)")
                mas.perceive("dist(f,9)")
                eventually({ mas.beliefs("bob") }) { "dist(f,9)" in mas.beliefs("bob") && "dist(f,1)" !in mas.beliefs("bob") }
            }
        }
    }

    test("a value that a rate holds back reaches the agent in the end, though the board says nothing new") {
        FakeBoard.plugIn("robot").use { board ->
            val answers = ArrayDeque(listOf("temp(1);", "temp(2);", "temp(3);"))
            board.whenAsked("getPercepts").answer { if (answers.size > 1) answers.removeFirst() else answers.first() }
            TestMas().use { mas ->
                mas.filter("calm", "<filter everyMs=\"2000\"><predicate>temp</predicate></filter>")
                mas.agent("bob", """
                    !start.
                    +!start <- argo.port("sim:robot"); argo.limit(5); argo.change_filter(calm); argo.percepts(open).
                    +temp(1) <- argo.act(first).
                    +temp(2) <- argo.act(never).
                    +temp(3) <- argo.act(last).
                """)
                board.awaitMessage("first", LIMIT_MS)
                board.awaitMessage("last", LIMIT_MS) // and temp(2) was never let through: the board is strict
            }
        }
    }

    test("an agent can ask why a percept is dropped, and a log level tells it too") {
        FakeBoard.plugIn("robot").use { board ->
            board.whenAsked("getPercepts").answer("dist(f,1);light(f,2);")
            TestMas().use { mas ->
                val logger = Logger.getLogger("argo.Arch.bob").apply { level = Level.FINE }
                mas.filter("onlyFront", onlyFront)
                mas.agent("bob", """
                    !start.
                    +!start <- argo.explain(light(f,2),A); .print("first ", A); argo.change_filter(onlyFront); argo.explain(dist(b,3),B); .print("then ", B);
                               argo.port("sim:robot"); argo.limit(5); argo.percepts(open).
                    +dist(f,1) <- argo.act(ok).
                """)
                board.awaitMessage("ok", LIMIT_MS)
                mas.log shouldContain "first light(f,2) is kept: there is no filter"
                mas.log shouldContain "then dist(b,3) is dropped by filter onlyFront: rule 2 meets it"
                mas.log shouldContain "FINE argo.Arch.bob: light(f,2) is dropped by filter onlyFront: rule 1 meets it"
                logger.level = null
            }
        }
    }

    test("an agent with a board believes its environment's percepts beside the board's") {
        FakeBoard.plugIn("robot").use { board ->
            board.whenAsked("getPercepts").answer("dist(f,3);")
            TestMas().use { mas ->
                mas.perceive("weather(rain)")
                mas.agent("bob", """
                    !start.
                    +!start <- argo.port("sim:robot"); argo.limit(5); argo.percepts(open).
                    +dist(f,3) <- .wait(50); ?weather(W); argo.act(W).
                """)
                board.awaitMessage("rain", LIMIT_MS)
                mas.perceive("weather(sun)")
                eventually({ mas.beliefs("bob") }) { mas.beliefs("bob").containsAll(listOf("weather(sun)", "dist(f,3)")) }
            }
        }
    }
})
