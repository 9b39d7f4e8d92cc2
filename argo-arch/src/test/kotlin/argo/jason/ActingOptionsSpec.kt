package argo.jason

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldNotContain
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import javino.sim.FakeBoard

private const val LIMIT_MS = 20_000

class ActingOptionsSpec : FunSpec({
    test("urgent commands go before those that wait, in their own order") {
        FakeBoard.plugIn("robot").use { board ->
            board.bootTakes(1_500) // nothing goes out before, so all of them wait
            TestMas().use { mas ->
                mas.agent("bob", """
                    !start.
                    +!start <- argo.port("sim:robot"); for (.range(I,1,5)) { !!do(walk(I),[]) }; .wait(20);
                               for (.range(I,1,3)) { !!do(stop(I),[urgent]) }.
                    +!do(W,Options) <- argo.act(W,Options).
                """)
                board.awaitMessage("walk(5)", LIMIT_MS)
                board.received().filter { it != "getPercepts" } shouldBe listOf("stop(1)", "stop(2)", "stop(3)", "walk(1)", "walk(2)", "walk(3)", "walk(4)", "walk(5)")
                board.lenient()
            }
        }
    }

    test("a command whose time is over before it begins to go out is never sent, and those behind it are") {
        FakeBoard.plugIn("robot").use { board ->
            board.bootTakes(2_000)
            TestMas().use { mas ->
                mas.agent("bob", """
                    !start.
                    +!start <- argo.port("sim:robot"); !!plain; !late.
                    +!plain <- argo.act(first).
                    +!late <- argo.act(walk, [timeout(50)]).
                    -!late[error(E),error_msg(M)] <- .print(E, " ", M); argo.act(after(E)).
                """)
                board.awaitMessage("after(act_timeout)", LIMIT_MS)
                board.received().filter { it != "getPercepts" } shouldBe listOf("first", "after(act_timeout)")
                mas.log shouldContain "act_timeout argo.act(walk,[timeout(50)]): \"walk\" had not begun to go out through port sim:robot"
                board.lenient()
            }
        }
    }

    test("the command that is next on the line is withdrawn too, and an urgent one may be") {
        FakeBoard.plugIn("robot").use { board ->
            board.bootTakes(2_000)
            TestMas().use { mas ->
                mas.agent("bob", """
                    !start.
                    +!start <- argo.port("sim:robot"); !late; argo.act(after).
                    +!late <- argo.act(walk, [timeout(30), urgent]).
                    -!late[error(act_timeout)] <- +withdrawn.
                """)
                eventually({ mas.beliefs("bob") }) { "withdrawn" in mas.beliefs("bob") }
                board.awaitMessage("after", LIMIT_MS)
                board.received() shouldNotContain "walk"
                board.lenient()
            }
        }
    }

    test("a board of version 2 that does not confirm in time leaves the command unconfirmed, and the next one goes out") {
        FakeBoard.plugIn("robot").version2().lenient().use { board ->
            TestMas().use { mas ->
                mas.agent("bob", """
                    !start.
                    +!start <- argo.port("sim:robot", [protocol(auto)]); argo.act(ledOn).
                    +!walk <- argo.act(walk, [timeout(200)]).
                    -!walk[error(E),error_msg(M)] <- .print(M); +said(E); argo.act(next).
                """)
                board.awaitMessage("ledOn", LIMIT_MS)
                board.stall()
                mas.achieve("bob", "walk")
                eventually({ mas.beliefs("bob") }) { "said(act_unconfirmed)" in mas.beliefs("bob") }
                mas.log shouldContain "when its time was over"
                board.resume()
                board.awaitMessage("next", LIMIT_MS)
            }
        }
    }

    test("a command that is still on a line of version 1 when its time is over is unconfirmed") {
        FakeBoard.plugIn("robot").use { board ->
            TestMas().use { mas ->
                mas.agent("bob", """
                    !start.
                    +!start <- argo.port("sim:robot", [baud(300), boot(0)]); !long.
                    +!long <- argo.act(${"x".repeat(120)}, [timeout(300)]).
                    -!long[error(E)] <- +said(E).
                """)
                eventually({ mas.beliefs("bob") }) { "said(act_unconfirmed)" in mas.beliefs("bob") }
                board.lenient()
            }
        }
    }

    test("a command that is carried out in time is not disturbed, however many have a limit") {
        FakeBoard.plugIn("robot").use { board ->
            TestMas().use { mas ->
                mas.agent("bob", """
                    !start.
                    +!start <- argo.port("sim:robot", [boot(0), spacing(0), baud(2000000)]); for (.range(I,1,500)) { argo.act(n(I), [timeout(20000)]) }; argo.act(done).
                """)
                board.awaitMessage("done", LIMIT_MS)
                board.received() shouldBe (1..500).map { "n($it)" } + "done"
                board.lenient()
            }
        }
    }

    test("under in_cycle a command is not sent once its time is over, and the other options change nothing") {
        FakeBoard.plugIn("robot").use { board ->
            board.bootTakes(1_000)
            TestMas().use { mas ->
                mas.agent("bob", """
                    !start.
                    +!start <- argo.port("sim:robot"); !late; argo.act(after, [urgent, timeout(10000)]).
                    +!late <- argo.act(walk, [timeout(50)]).
                    -!late[error(act_timeout)] <- +withdrawn.
                """, options = mapOf("argo_sensing" to "in_cycle"))
                board.awaitMessage("after", LIMIT_MS)
                board.received() shouldNotContain "walk"
                mas.beliefs("bob").contains("withdrawn") shouldBe true
                board.lenient()
            }
        }
    }

    test("options that cannot be used fail the plan and nothing is sent") {
        FakeBoard.plugIn("robot").use { board ->
            TestMas().use { mas ->
                mas.agent("bob", """
                    !start.
                    +!start <- argo.port("sim:robot", [boot(0)]); for (.member(O,[urgent,[timeout],[timeout(0)],[urgently],[timeout(5),fast]])) { !try(O) }; argo.act(ok, []).
                    +!try(O) <- argo.act(bad, O).
                    -!try(O)[error(E),error_msg(M)] <- .print(E, " ", M).
                """)
                board.awaitMessage("ok", LIMIT_MS)
                board.received() shouldBe listOf("ok")
                board.lenient()
                Regex("wrong_arguments argo.act").findAll(mas.log).count() shouldBe 5
            }
        }
    }

    for (options in listOf("[]", "[urgent]")) test("loops of argo.act with $options leave the line to a request at least every second interval") {
        FakeBoard.plugIn("robot").use { board ->
            board.lenient()
            board.whenAsked("getPercepts").answer("dist(f,1);")
            TestMas().use { mas ->
                mas.agent("bob", """
                    !start.
                    +!start <- argo.port("sim:robot", [baud(9600), spacing(0), queue(4)]); argo.limit(100); argo.percepts(open); for (.range(I,1,8)) { !!drive }.
                    +!drive <- argo.act(front,$options); !drive.
                """)
                eventually({ board.received().takeLast(20) }) { board.received().count { it == "front" } > 200 }
                // a command of 11 bytes takes 11.5 ms of the line, so at most 18 of them fit into two intervals; the rest is for a busy machine
                val runs = board.received().dropWhile { it != "front" }.joinToString(" ").split("getPercepts").map { run -> run.split(" ").count { it == "front" } }
                check(runs.dropLast(1).all { it <= 40 }) { "so many commands went out between two requests: $runs" }
                check(runs.size > 5) { "$runs" }
            }
        }
    }
})
