package argo.jason

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import javino.sim.FakeBoard

private const val LIMIT_MS = 20_000

class ActingSpec : FunSpec({
    test("commands go out in the agent's order, as the agent wrote them") {
        FakeBoard.plugIn("robot").use { board ->
            TestMas().use { mas ->
                mas.agent("bob", """
                    !start.
                    +!start <- argo.port("sim:robot", [boot(0), spacing(0)]); argo.act(ledOn); argo.act(speed(120)); argo.act(say("hi; you"));
                               X = 3; argo.act(turn(left,X*2)); argo.act("raw text"); argo.act(~open(door)); argo.act(done).
                """)
                board.awaitMessage("done", LIMIT_MS)
                board.received() shouldBe listOf("ledOn", "speed(120)", "say(\"hi; you\")", "turn(left,6)", "raw text", "~open(door)", "done")
                board.lenient()
            }
        }
    }

    test("each of the three forms of each action works") {
        for (form in listOf("argo.", ".", ".argo.")) FakeBoard.plugIn("robot").use { board ->
            board.whenAsked("getPercepts").answer("p;")
            TestMas().use { mas ->
                mas.agent("bob", """
                    !start.
                    +!start <- ${form}port("sim:robot"); ${form}limit(5); ${form}change_filter(none); ${if (form == "argo.") "" else "${form}filter(none);"} ${form}percepts(open).
                    +p <- ${form}act(ok).
                """)
                board.awaitMessage("ok", LIMIT_MS)
                mas.log.lines().filter { "WARNING" in it }.shouldBeEmpty()
            }
        }
    }

    test("a loop of argo.act neither starves sensing nor runs ahead of it: the stop is sent right after it is decided") {
        FakeBoard.plugIn("robot").use { board ->
            board.lenient()
            var n = 100
            board.whenAsked("getPercepts").answer { "dist(f,${n--});" }
            TestMas().use { mas ->
                mas.agent("bob", """
                    !start.
                    +!start <- argo.port("sim:robot", [baud(57600)]); argo.limit(0); argo.percepts(open); !moving.
                    +!moving : dist(f,X) & X > 40 <- argo.act(front); !moving.
                    +!moving : dist(f,X) <- argo.act(stop); argo.act(at(X)).
                    -!moving <- .wait(5); !moving.
                """)
                eventually({ board.received() }) { board.received().any { it.startsWith("at(") } }
                val received = board.received()
                val asked = received.takeWhile { it != "stop" }.count { it == "getPercepts" }
                val decidedOn = 101 - received.first { it.startsWith("at(") }.removeSurrounding("at(", ")").toInt() // which answer it was
                // the one on its way when it came and the one held back may follow it
                check(asked - decidedOn in 0..5) { "$asked requests before the stop, which the answer to request $decidedOn caused" }
                check(received.count { it == "front" } >= 20) { "only ${received.count { it == "front" }} commands in $asked requests" }
            }
        }
    }

    test("commands of a port that is closed and opened again all the while go out or fail for that reason, and no intention is lost") {
        FakeBoard.plugIn("robot").use { board ->
            board.lenient()
            TestMas().use { mas ->
                mas.agent("bob", """
                    !start.
                    +!start <- argo.port("sim:robot", [boot(0), spacing(0), baud(2000000)]); for (.range(I,1,10)) { !!act(I) }; !swap(100).
                    +!act(I) : over <- argo.act(alive(I)).
                    +!act(I) <- argo.act(front); !act(I).
                    -!act(I)[error(E)] : E == no_port | E == port_gone <- .wait(1); !act(I).
                    -!act(I)[error(E),error_msg(M)] <- .print("ODD ", E, " ", M); !act(I).
                    +!swap(0) <- +over.
                    +!swap(N) <- argo.port(none); argo.port("sim:robot"); !swap(N-1).
                """)
                eventually({ board.received().takeLast(20) + mas.log }) { (1..10).all { "alive($it)" in board.received() } }
                mas.log.lines().filter { "ODD" in it || "SEVERE" in it }.shouldBeEmpty()
            }
        }
    }

    test("an intention that waits for its command does not stop the agent") {
        FakeBoard.plugIn("robot").use { board ->
            board.bootTakes(1_000)
            TestMas().use { mas ->
                mas.agent("bob", """
                    !start. !think(0).
                    +!start <- argo.port("sim:robot"); argo.act(front); ?thoughts(N); argo.act(thought(N)).
                    +!think(N) <- -+thoughts(N); .wait(1); !think(N+1).
                """)
                board.awaitMessage("front", LIMIT_MS)
                val thought = board.awaitMessage(LIMIT_MS)
                check(Regex("""thought\((\d+)\)""").matchEntire(thought)!!.groupValues[1].toInt() > 20) { thought }
            }
        }
    }

    test("an action that cannot be done fails its plan with a message that names it, its argument and the cause") {
        FakeBoard.plugIn("robot").use { board ->
            TestMas().use { mas ->
                val attempts = mapOf(
                    "argo.act(ledOn)" to "no_port",
                    "argo.act" to "wrong_arguments",
                    "argo.act(5)" to "wrong_arguments",
                    "argo.act([a])" to "wrong_arguments",
                    "argo.act(a & b)" to "wrong_arguments",
                    "argo.act(\"\")" to "wrong_arguments",
                    "argo.act(X)" to "wrong_arguments",
                    "argo.act(speed(X))" to "wrong_arguments",
                    "argo.port(\"sim:nobody\")" to "no_such_port",
                    "argo.port(no_such_device_here)" to "no_such_port",
                    "argo.port(COM77)" to "no_such_port",
                    "argo.port(f(x))" to "wrong_arguments",
                    "argo.port(\"\")" to "wrong_arguments",
                    "argo.port(_)" to "wrong_arguments",
                    "argo.port(\"sim:robot\",baud(1))" to "wrong_arguments",
                    "argo.port(\"sim:robot\",[bauds(1)])" to "wrong_arguments",
                    "argo.limit(-1)" to "wrong_arguments",
                    "argo.limit(1.5)" to "wrong_arguments",
                    "argo.limit(fast)" to "wrong_arguments",
                    "argo.limit(1,2)" to "wrong_arguments",
                    "argo.percepts(maybe)" to "wrong_arguments",
                    "argo.change_filter(nowhere)" to "no_such_filter",
                    "argo.change_filter(\"../secret\")" to "no_such_filter",
                    "argo.change_filter(7)" to "wrong_arguments",
                )
                val plans = attempts.keys.withIndex().joinToString("\n") { (i, call) ->
                    "+!try($i) <- $call; .print(\"$i worked\").\n-!try($i)[error(E),error_msg(M)] <- .print(\"<\",$i,\" \",E,\" \",M,\">\")."
                }
                mas.agent("bob", "!start.\n+!start <- for (.range(I,0,${attempts.size - 1})) { !try(I) }; .print(finished).\n$plans")
                eventually({ mas.log }) { "finished" in mas.log }
                attempts.entries.forEachIndexed { i, (call, error) ->
                    val line = Regex("<$i (.*)>").find(mas.log)?.groupValues?.get(1) ?: error("$call: ${mas.log}")
                    line shouldContain "$error "
                    line shouldContain call.substringBefore('(')
                }
                mas.log shouldContain "argo.act(ledOn): no port is in use; choose one with argo.port first"
                board.received().shouldBeEmpty()
            }
        }
    }

    test("a command too long for a message is refused and nothing is sent") {
        FakeBoard.plugIn("robot").use { board ->
            TestMas().use { mas ->
                mas.agent("bob", """
                    !start.
                    +!start <- argo.port("sim:robot", [boot(0)]); argo.act("${"x".repeat(256)}").
                    -!start[error(E),error_msg(M)] <- .print(E, M); argo.act(ok).
                """)
                board.awaitMessage("ok", LIMIT_MS)
                board.received() shouldBe listOf("ok")
                mas.log shouldContain "255"
            }
        }
    }

    test("a port belongs to one agent, and a second one is told whose it is") {
        FakeBoard.plugIn("robot").use { board ->
            TestMas().use { mas ->
                mas.agent("alice", "!start.\n+!start <- argo.port(\"sim:robot\", [boot(0)]); argo.act(mine).")
                board.awaitMessage("mine", LIMIT_MS)
                mas.agent("bob", "!start.\n+!start <- argo.port(\"sim:robot\").\n-!start[error(E),error_msg(M)] <- .print(E, \" \", M).")
                eventually({ mas.log }) { "port_busy" in mas.log }
                mas.log shouldContain "alice"
                mas.kill("alice")
                mas.agent("carol", "!start.\n+!start <- argo.port(\"sim:robot\", [boot(0)]); argo.act(now_mine).\n-!start <- .wait(10); !start.")
                board.awaitMessage("now_mine", LIMIT_MS)
            }
        }
    }

    test("an agent without argo.Arch is told how to get a board") {
        TestMas().use { mas ->
            mas.agent("bob", "!start.\n+!start <- argo.port(ttyACM0).\n-!start[error(E),error_msg(M)] <- .print(E, \" \", M).", arch = null)
            eventually({ mas.log }) { "not_argo" in mas.log }
            mas.log shouldContain "agentArchClass argo.Arch"
        }
    }

    test("waiting commands fail when the cable is pulled, and the agent goes on") {
        FakeBoard.plugIn("robot").use { board ->
            TestMas().use { mas ->
                mas.agent("bob", """
                    !start.
                    +!start <- argo.port("sim:robot", [baud(300), boot(0)]); argo.act(first); argo.act(second_that_takes_its_time); .print(sent).
                    -!start[error(E)] <- .print("failed with ", E).
                """)
                board.awaitMessage("first", LIMIT_MS)
                board.unplug()
                eventually({ mas.log }) { "failed with port_gone" in mas.log }
                board.lenient()
            }
        }
    }

    test("an atomic plan acts too") {
        FakeBoard.plugIn("robot").use { board ->
            TestMas().use { mas ->
                mas.agent("bob", "!start.\n@a[atomic] +!start <- argo.port(\"sim:robot\", [boot(0)]); argo.act(one); argo.act(two).")
                board.awaitMessage("one", LIMIT_MS)
                board.awaitMessage("two", LIMIT_MS)
            }
        }
    }
})
