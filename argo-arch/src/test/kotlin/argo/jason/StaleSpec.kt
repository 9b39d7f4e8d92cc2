package argo.jason

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldNotContain
import io.kotest.matchers.string.shouldContain
import javino.sim.FakeBoard

private const val LIMIT_MS = 20_000

class StaleSpec : FunSpec({
    test("silence is believed of the port in use after its time, ends with the next message, and no filter hides it") {
        onRobot("dist(f,3);") { board, mas ->
            mas.file("filters/nothing.json", """{"keep": true, "rules": []}""")
            mas.agent("bob", """
                !start.
                +!start <- argo.port("sim:robot", [timeout(50), boot(0), stale(150)]); argo.limit(5); argo.percepts(open).
                +dist(f,3) <- argo.change_filter(nothing); argo.act(see).
                +stale(P) : port(P,_) <- +was_stale.
                -stale(P) : was_stale <- argo.act(back).
            """)
            board.awaitMessage("see", LIMIT_MS)
            board.stall()
            eventually({ mas.beliefs("bob") }) { "stale(\"sim:robot\")" in mas.beliefs("bob") && "was_stale" in mas.beliefs("bob") }
            board.resume()
            board.awaitMessage("back", LIMIT_MS)
            eventually({ mas.beliefs("bob") }) { "stale(\"sim:robot\")" !in mas.beliefs("bob") }
        }
    }

    test("it wakes an agent that sleeps while its board speaks unasked") {
        FakeBoard.plugIn("talker").use { board ->
            TestMas().use { mas ->
                mas.agent("bob", """
                    !start.
                    +!start <- argo.port("sim:talker", [mode(listen), boot(0), stale(300)]); argo.percepts(open); argo.act(listening).
                    +stale("sim:talker") <- argo.act(silence).
                """)
                board.awaitMessage("listening", LIMIT_MS)
                board.send("button(7);")
                board.awaitMessage("silence", LIMIT_MS)
            }
        }
    }

    test("while perceiving is blocked nothing is stale, and what was is no more") {
        FakeBoard.plugIn("robot").use { board ->
            board.lenient()
            board.whenAsked("getPercepts").staySilent()
            TestMas().use { mas ->
                mas.agent("bob", """
                    !start.
                    +!start <- argo.port("sim:robot", [timeout(50), boot(0), stale(100)]); argo.limit(5); .wait(300); +blocked_so_far; argo.percepts(open).
                    +stale(_) <- argo.percepts(block); +turned_away.
                """)
                eventually({ mas.beliefs("bob") }) { "blocked_so_far" in mas.beliefs("bob") }
                eventually({ mas.beliefs("bob") }) { "turned_away" in mas.beliefs("bob") && "stale(\"sim:robot\")" !in mas.beliefs("bob") }
            }
        }
    }

    test("a pulled cable is stale in its time") {
        onRobot("dist(f,3);") { board, mas ->
            mas.agent("bob", """
                !start.
                +!start <- argo.port("sim:robot", [boot(0), stale(200)]); argo.limit(5); argo.percepts(open).
                +dist(f,3) <- argo.act(see).
            """)
            board.awaitMessage("see", LIMIT_MS)
            board.unplug()
            eventually({ mas.beliefs("bob") }) { "stale(\"sim:robot\")" in mas.beliefs("bob") && "dist(f,3)" in mas.beliefs("bob") }
        }
    }

    test("what was stale when the cable was out stays so until the board has said something") {
        onRobot("dist(f,3);") { board, mas ->
            mas.agent("bob", """
                !start.
                +!start <- argo.port("sim:robot", [protocol(1), timeout(50), boot(0), stale(200)]); argo.limit(5); argo.percepts(open).
                +dist(f,3) <- argo.act(see).
                -stale(_) : was_off <- +fresh_again.
                +port(_,off) <- +was_off.
                +port(_,timeout) : was_off <- +silent_since_it_is_back.
            """)
            board.awaitMessage("see", LIMIT_MS)
            board.unplug()
            eventually({ mas.beliefs("bob") }) { "stale(\"sim:robot\")" in mas.beliefs("bob") }
            board.whenAsked("getPercepts").staySilent()
            board.replug()
            eventually({ mas.beliefs("bob") }) { "silent_since_it_is_back" in mas.beliefs("bob") }
            mas.beliefs("bob") shouldNotContain "fresh_again"
            board.whenAsked("getPercepts").answer("dist(f,4);")
            eventually({ mas.beliefs("bob") }) { "fresh_again" in mas.beliefs("bob") && "dist(f,4)" in mas.beliefs("bob") }
        }
    }

    test("asking for the port again does not put it off") {
        onRobot("dist(f,3);") { board, mas ->
            mas.agent("bob", """
                !start.
                +!start <- argo.port("sim:robot", [protocol(1), timeout(50), boot(0), stale(500)]); argo.limit(5); argo.percepts(open).
                +dist(f,3) <- argo.act(see); !!insist.
                +!insist : not stale(_) <- argo.port("sim:robot"); .wait(20); !!insist.
                +!insist.
            """)
            board.awaitMessage("see", LIMIT_MS)
            board.stall()
            eventually({ mas.beliefs("bob") }) { "stale(\"sim:robot\")" in mas.beliefs("bob") }
            board.resume()
        }
    }

    test("a board cannot claim it") {
        onRobot("stale(\"sim:robot\");dist(f,3);") { board, mas ->
            mas.agent("bob", """
                !start.
                +!start <- argo.port("sim:robot", [boot(0)]); argo.limit(5); argo.percepts(open).
                +dist(f,3) : not stale(_) <- argo.act(ok).
            """)
            board.awaitMessage("ok", LIMIT_MS)
            mas.log shouldContain "stale/1"
        }
    }
})
