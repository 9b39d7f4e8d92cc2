package argo.jason

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import javino.sim.FakeBoard

private const val LIMIT_MS = 20_000

class Version2Spec : FunSpec({
    fun robot(work: (FakeBoard) -> Unit) = FakeBoard.plugIn("robot").version2().lenient().use(work)

    test("a command that the board refuses fails its plan, one that it carries out does not") {
        robot { board ->
            board.whenAsked("fly").refuse()
            TestMas().use { mas ->
                mas.agent("bob", """
                    !start.
                    +!start <- argo.port("sim:robot"); argo.act(ledOn); argo.act(fly).
                    -!start[error(E)] <- argo.act(said(E)).
                """)
                board.awaitMessage("said(act_refused)", LIMIT_MS)
                board.received().filter { it != "getPercepts" } shouldBe listOf("ledOn", "fly", "said(act_refused)")
            }
        }
    }

    test("a command that the board says nothing of fails its plan") {
        robot { board ->
            TestMas().use { mas ->
                mas.agent("bob", """
                    !start.
                    +!start <- argo.port("sim:robot"); argo.act(ledOn).
                    +!walk <- argo.act(walk).
                    -!walk[error(E)] <- +said(E).
                """)
                board.awaitMessage("ledOn", LIMIT_MS)
                board.stall()
                mas.achieve("bob", "walk")
                eventually({ mas.beliefs("bob") }) { "said(act_unconfirmed)" in mas.beliefs("bob") }
                board.resume()
            }
        }
    }

    test("a filter that keeps percepts by their functor has these alone asked for") {
        robot { board ->
            board.whenAsked { it.startsWith("getPercepts") }.answer { if ("dist" in it) "dist(f,1);" else "dist(f,1);light(f,2);" }
            board.whenAsked("getPercepts").answer("dist(f,1);light(f,2);")
            TestMas().use { mas ->
                mas.file("filters/near.xml", "<?xml version=\"1.0\"?>\n<PerceptionFilter keep=\"true\"><filter><predicate>dist</predicate></filter></PerceptionFilter>\n")
                mas.agent("bob", """
                    !start.
                    +!start <- argo.port("sim:robot"); argo.limit(5); argo.percepts(open).
                    +light(f,_) <- argo.change_filter(near).
                    -light(f,_) : dist(f,1) <- argo.act(ok).
                """)
                board.awaitMessage("ok", LIMIT_MS)
                eventually({ board.received() }) { board.received().takeLast(3).all { it == "getPercepts(dist)" } }
            }
        }
    }
})
