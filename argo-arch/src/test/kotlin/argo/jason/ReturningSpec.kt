package argo.jason

import argo.ports.PluggedIn
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.ints.shouldBeLessThan
import io.kotest.matchers.shouldBe
import javino.sim.FakeBoard
import java.nio.file.Files
import java.nio.file.Path

private const val LIMIT_MS = 20_000

/** Links that come back, seen by an agent. */
class ReturningSpec : FunSpec({
    /** An agent that tells its board what it has seen last, so that the board knows whether it is perceived. */
    fun follower(port: String) = """
        !start.
        +!start <- argo.port("$port", [baud(115200)]); argo.limit(5); argo.percepts(open).
        +seen(X) <- argo.act(saw(X)).
    """

    fun onTerminals(name: String, body: (FakeBoard, Path) -> Unit) = test(name).config(enabledOrReasonIf = { withTerminals }, blockingTest = true) {
        val directory = Files.createTempDirectory("argo-returning")
        try {
            FakeBoard.plugIn("far").use { body(it.lenient(), directory.resolve("board")) }
        } finally {
            directory.toFile().deleteRecursively()
        }
    }

    fun TestMas.awaitBelief(belief: String) = eventually({ beliefs("bob") }) { belief in beliefs("bob") }

    /** The agent perceives what the board says now, and acts on it. */
    fun FakeBoard.isPerceived(what: String) {
        whenAsked("getPercepts").answer("seen($what);")
        awaitMessage("saw($what)", LIMIT_MS)
    }

    onTerminals("a terminal whose far end is closed and opened again under its old name is used again by itself") { board, name ->
        TestMas().use { mas ->
            TerminalBoard(board).use { terminal ->
                name.pointTo(terminal.device)
                mas.agent("bob", follower("$name"))
                board.isPerceived("first")
            }
            mas.awaitBelief("port(\"$name\",off)")
            mas.beliefs("bob") shouldContain "seen(first)"
            name.pointTo(null)
            TerminalBoard(board).use { terminal ->
                name.pointTo(terminal.device)
                board.isPerceived("second")
                mas.awaitBelief("port(\"$name\",on)")
            }
        }
    }

    onTerminals("a name that leads to another device when the first has gone is followed") { board, name ->
        TestMas().use { mas ->
            TerminalBoard(board).use { first ->
                name.pointTo(first.device)
                mas.agent("bob", follower("$name"))
                board.isPerceived("first")
                TerminalBoard(board).use { second ->
                    check(first.device != second.device)
                    name.pointTo(second.device)
                    board.isPerceived("still_first")
                    first.close()
                    mas.awaitBelief("port(\"$name\",off)")
                    mas.awaitBelief("port(\"$name\",on)")
                    board.isPerceived("second")
                }
            }
        }
    }

    onTerminals("a board that is known by its USB identity is found under another name") { board, _ ->
        TestMas().use { mas ->
            val port = "plugged:fff1:0002:A1"
            try {
                TerminalBoard(board).use { terminal ->
                    PluggedIn.devices += PluggedIn.device("${terminal.device}")
                    mas.agent("bob", follower(port))
                    board.isPerceived("first")
                    PluggedIn.devices.clear()
                }
                mas.awaitBelief("port(\"$port\",off)")
                TerminalBoard(board).use { terminal ->
                    PluggedIn.devices += PluggedIn.device("${terminal.device}")
                    mas.awaitBelief("port(\"$port\",on)")
                    board.isPerceived("second")
                }
            } finally {
                PluggedIn.devices.clear()
            }
        }
    }

    test("commands that wait when the cable is pulled fail, and those given while it is out") {
        FakeBoard.plugIn("robot").use { board ->
            board.lenient()
            TestMas().use { mas ->
                mas.agent("bob", """
                    !start.
                    +!start <- argo.port("sim:robot", [baud(300), boot(0)]); for (.range(I,1,20)) { !!send(I) }.
                    +!send(I) <- argo.act(takes_a_second_or_so(I)).
                    -!send(I)[error(E)] <- +failed(I,E).
                    +port(P,off) <- !!send(21).
                    +port(P,on) : failed(20,_) & failed(21,_) <- argo.act(back).
                """)
                board.awaitMessage("takes_a_second_or_so(1)", LIMIT_MS)
                board.unplug()
                for (i in 2..21) mas.awaitBelief(if (i == 2) "failed(3,port_gone)" else "failed($i,port_gone)")
                board.replug()
                board.awaitMessage("back", LIMIT_MS)
            }
        }
    }

    test("the policy in_cycle notices a pulled cable and its return while nothing is asked of the board") {
        FakeBoard.plugIn("robot").use { board ->
            board.lenient()
            TestMas().use { mas ->
                mas.agent("bob", """
                    !start.
                    +!start <- argo.port("sim:robot"); +open.
                    +!greet <- argo.act(hello).
                """, options = mapOf("argo_sensing" to "in_cycle"))
                mas.awaitBelief("open")
                board.unplug()
                mas.awaitBelief("port(\"sim:robot\",off)")
                board.replug()
                mas.awaitBelief("port(\"sim:robot\",on)")
                mas.achieve("bob", "greet")
                board.awaitMessage("hello", LIMIT_MS)
            }
        }
    }

    test("a connection that is cut is made again, and a board that was off is waited for with one line of log for each change") {
        TestMas().use { mas ->
            val number = NetworkBoard().use { board ->
                mas.agent("bob", """
                    !start.
                    +!start <- argo.port("${board.port}"); argo.limit(5); argo.percepts(open).
                    +count(N) <- argo.act(saw(N)).
                """)
                eventually({ mas.beliefs("bob") }) { board.received.isNotEmpty() }
                board.cut()
                mas.awaitBelief("port(\"${board.port}\",off)")
                val before = board.received.size
                mas.awaitBelief("port(\"${board.port}\",on)")
                eventually({ board.received }) { board.received.size > before + 5 }
                board.number
            }
            val port = "tcp://127.0.0.1:$number"
            mas.awaitBelief("port(\"$port\",off)")
            eventually({ mas.log }) { "still off" in mas.log }
            NetworkBoard(number).use { board ->
                mas.awaitBelief("port(\"$port\",on)")
                eventually({ board.received }) { board.received.size > 5 }
                mas.log.lines().count { "port \"$port\" is " in it } shouldBe 6
            }
        }
    }

    test("a pulled cable and its return leave no more lines in the log than changes of state, and no threads") {
        FakeBoard.plugIn("robot").use { board ->
            board.lenient()
            TestMas().use { mas ->
                mas.agent("bob", follower("sim:robot"))
                val noticing = ArrayList<Long>()
                val returning = ArrayList<Long>()
                repeat(20) {
                    board.isPerceived("$it")
                    noticing += millis {
                        board.unplug()
                        mas.awaitBelief("port(\"sim:robot\",off)")
                    }
                    returning += millis {
                        board.replug()
                        mas.awaitBelief("port(\"sim:robot\",on)")
                    }
                }
                println("20 pulled cables: off believed after ${noticing.average().toInt()} ms, at most ${noticing.max()}; on after ${returning.average().toInt()} ms, at most ${returning.max()}")
                board.isPerceived("last")
                mas.log.lines().count { "port \"sim:robot\" is " in it } shouldBe 41
                Thread.getAllStackTraces().keys.count { it.name.startsWith("argo-bob") } shouldBeLessThan 5
            }
        }
    }
})

private fun millis(work: () -> Unit): Long = System.nanoTime().let { start ->
    work()
    (System.nanoTime() - start) / 1_000_000
}
