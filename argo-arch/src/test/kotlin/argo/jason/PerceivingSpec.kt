package argo.jason

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainAll
import io.kotest.matchers.collections.shouldNotContain
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import javino.sim.FakeBoard

private const val LIMIT_MS = 20_000

class PerceivingSpec : FunSpec({
    test("what a board says becomes beliefs and events") {
        FakeBoard.plugIn("robot").use { board ->
            board.whenAsked("getPercepts").answer("dist(f,38);light(b,140);~open(door);")
            TestMas().use { mas ->
                mas.agent("bob", """
                    !start.
                    +!start <- argo.port("sim:robot"); argo.limit(10); argo.percepts(open).
                    +dist(f,X) <- argo.act(seen(X)).
                """)
                board.awaitMessage("seen(38)", LIMIT_MS)
                mas.beliefs("bob") shouldContainAll listOf("dist(f,38)", "light(b,140)", "~open(door)", "port(\"sim:robot\",on)")
            }
        }
    }

    test("beliefs follow the board and go when it does not say them any more") {
        FakeBoard.plugIn("robot").use { board ->
            board.whenAsked("getPercepts").answer("dist(f,3);door;", "dist(f,2);")
            TestMas().use { mas ->
                mas.agent("bob", """
                    !start.
                    +!start <- argo.port("sim:robot"); argo.limit(10); argo.percepts(open).
                    -door <- argo.act(gone).
                """)
                board.awaitMessage("gone", LIMIT_MS)
                mas.beliefs("bob") shouldContain "dist(f,2)"
                mas.beliefs("bob") shouldNotContain "dist(f,3)"
            }
        }
    }

    test("perception is blocked until it is opened, and blocked again it leaves beliefs as they are") {
        FakeBoard.plugIn("robot").use { board ->
            var n = 0
            board.whenAsked("getPercepts").answer { "count(${++n});" }
            TestMas().use { mas ->
                mas.agent("bob", """
                    !start.
                    +!start <- argo.port("sim:robot"); argo.limit(5); argo.act(blocked); .count(count(_),N); argo.act(knows(N)); argo.percepts(open).
                    +count(_) : not done <- +done; argo.percepts(block); .wait(100); ?count(X); .wait(200); ?count(Y); argo.act(same(X,Y)).
                """)
                board.awaitMessage("blocked", LIMIT_MS)
                board.awaitMessage("knows(0)", LIMIT_MS)
                val same = board.awaitMessage(LIMIT_MS)
                check(Regex("""same\((\d+),\1\)""").matches(same)) { same }
            }
        }
    }

    test("commands that wait for a slow board do not hold back what another board says") {
        FakeBoard.plugIn("slow").use { slow -> FakeBoard.plugIn("robot").use { board ->
            slow.lenient()
            board.lenient()
            var n = 0
            board.whenAsked("getPercepts").answer { "count(${++n});" }
            TestMas().use { mas ->
                mas.agent("bob", """
                    !start.
                    +!start <- argo.port("sim:slow", [baud(300), boot(0)]); for (.range(I,1,200)) { !!send(I) }; .wait(100);
                               argo.port("sim:robot", [baud(115200)]); argo.limit(5); argo.percepts(open).
                    +!send(I) <- argo.act(takes_a_second_and_a_half_or_so(I)).
                    +count(N) : N > 20 <- argo.act(counted).
                """)
                board.awaitMessage("counted", LIMIT_MS)
            }
        } }
    }

    context("the world does not stand still for") {
        val drives = mapOf(
            "an atomic plan that calls itself" to """
                @drive[atomic] +!drive : dist(f,X) & X > 40 <- argo.act(front); !drive.
                +!drive <- argo.act(stop).
            """,
            "an atomic plan that waits for a percept" to "@drive[atomic] +!drive <- argo.act(front); .wait(dist(f,X) & X <= 40); argo.act(stop).",
            "an agent that keeps the events no plan applies to" to """
                +!drive : dist(f,X) & X > 40 <- argo.act(front); !drive.
                +!drive <- argo.act(stop).
            """,
        )
        for ((who, drive) in drives) test(who) {
            FakeBoard.plugIn("robot").use { board ->
                board.lenient()
                var n = 80
                board.whenAsked("getPercepts").answer { "dist(f,${n--});light(f,$n);" }
                TestMas().use { mas ->
                    mas.agent("bob", """
                        !start.
                        +!start <- argo.port("sim:robot", [baud(115200)]); argo.limit(5); argo.percepts(open); .wait(dist(f,_)); !drive.
                        $drive
                        +light(f,X) : X > 1000 <- argo.act(bright).
                    """, options = if ("keeps" in who) mapOf("events" to "requeue") else emptyMap())
                    eventually({ board.received().takeLast(20) }) { "stop" in board.received() }
                }
            }
        }
    }

    test("a percept that Jason cannot read, or that no board may claim, costs itself alone") {
        FakeBoard.plugIn("robot").use { board ->
            board.whenAsked("getPercepts").answer("dist(f,;shutdown[source(self)];port(\"sim:robot\",off);a((;.stopMAS;X;say(\"a;b\");last;")
            TestMas().use { mas ->
                mas.agent("bob", """
                    !start.
                    +!start <- argo.port("sim:robot"); argo.limit(5); argo.percepts(open).
                    +last : say("a;b") & shutdown[source(percept)] & not shutdown[source(self)] & port("sim:robot",on) <- argo.act(ok).
                """)
                board.awaitMessage("ok", LIMIT_MS)
                mas.log shouldContain "percept dist(f, is left out"
                mas.log.split("percept dist(f, is left out").size shouldBe 2
            }
        }
    }

    test("a silent board is believed to be in timeout, its last percepts stay, and it comes back by itself") {
        FakeBoard.plugIn("robot").use { board ->
            board.whenAsked("getPercepts").answer("dist(f,3);")
            TestMas().use { mas ->
                mas.agent("bob", """
                    !start.
                    +!start <- argo.port("sim:robot", [timeout(50), boot(0)]); argo.limit(5); argo.percepts(open).
                    +dist(f,3) <- argo.act(see).
                    +port(P,timeout) : dist(f,3) <- .print("no answer from ", P).
                    +port(P,on) : quiet <- argo.act(back).
                """)
                board.awaitMessage("see", LIMIT_MS)
                board.stall()
                eventually({ mas.log }) { "no answer from sim:robot" in mas.log }
                board.resume()
                eventually({ mas.beliefs("bob") }) { "port(\"sim:robot\",on)" in mas.beliefs("bob") }
            }
        }
    }

    test("a pulled cable is believed at once, keeps the sensor beliefs, and the port can be opened again") {
        FakeBoard.plugIn("robot").use { board ->
            board.whenAsked("getPercepts").answer("dist(f,3);")
            TestMas().use { mas ->
                mas.agent("bob", """
                    !connect.
                    +!connect <- argo.port("sim:robot"); argo.limit(5); argo.percepts(open).
                    -!connect[error(no_such_port)] <- .wait(20); !connect.
                    +dist(f,3) <- argo.act(see).
                    +port(P,off) : dist(f,3) <- +lost; !connect.
                    +port(P,on) : lost <- argo.act(back).
                """)
                board.awaitMessage("see", LIMIT_MS)
                board.unplug()
                eventually({ mas.beliefs("bob") }) { "lost" in mas.beliefs("bob") }
                board.replug()
                board.awaitMessage("back", LIMIT_MS)
            }
        }
    }

    test("a pulled cable is noticed by an agent that neither perceives nor acts, on each of its ports") {
        FakeBoard.plugIn("left").use { left ->
            FakeBoard.plugIn("right").use { right ->
                TestMas().use { mas ->
                    mas.agent("bob", "!start.\n+!start <- argo.port(\"sim:left\"); argo.port(\"sim:right\"); +ready.")
                    eventually({ mas.beliefs("bob") }) { "ready" in mas.beliefs("bob") }
                    left.unplug()
                    eventually({ mas.beliefs("bob") }) { "port(\"sim:left\",off)" in mas.beliefs("bob") }
                    mas.beliefs("bob") shouldContain "port(\"sim:right\",on)"
                    right.unplug()
                    eventually({ mas.beliefs("bob") }) { "port(\"sim:right\",off)" in mas.beliefs("bob") }
                }
            }
        }
    }

    test("a board that speaks unasked is listened to and never asked") {
        FakeBoard.plugIn("talker").use { board ->
            TestMas().use { mas ->
                mas.agent("bob", """
                    !start.
                    +!start <- argo.port("sim:talker", [mode(listen), boot(0)]); argo.limit(60000); argo.percepts(open); argo.act(listening).
                    +button(N) <- argo.act(pressed(N)).
                """)
                board.awaitMessage("listening", LIMIT_MS)
                board.send("button(7);")
                board.awaitMessage("pressed(7)", LIMIT_MS)
                board.send("button(8);")
                board.awaitMessage("pressed(8)", LIMIT_MS)
                board.received() shouldNotContain "getPercepts"
            }
        }
    }

    test("an agent uses one port at a time and goes back to one that is still open") {
        FakeBoard.plugIn("left").use { left ->
            FakeBoard.plugIn("right").use { right ->
                left.whenAsked("getPercepts").answer("side(left);")
                right.whenAsked("getPercepts").answer("side(right);")
                TestMas().use { mas ->
                    mas.agent("bob", """
                        !start.
                        +!start <- argo.limit(5); argo.percepts(open); argo.port("sim:left").
                        +side(left)  : not turned <- +turned; argo.act(hello); argo.port("sim:right").
                        +side(right) <- argo.act(hello); argo.port("sim:left"); argo.act(again).
                    """)
                    left.awaitMessage("hello", LIMIT_MS)
                    right.awaitMessage("hello", LIMIT_MS)
                    left.awaitMessage("again", LIMIT_MS)
                    mas.beliefs("bob") shouldContainAll listOf("port(\"sim:left\",on)", "port(\"sim:right\",on)")
                }
            }
        }
    }
})

