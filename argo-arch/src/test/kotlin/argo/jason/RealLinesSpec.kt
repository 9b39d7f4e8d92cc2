package argo.jason

import argo.connecting.PluggedIn
import io.kotest.assertions.nondeterministic.eventually
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainExactlyInAnyOrder
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.ints.shouldBeLessThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import javino.sim.FakeBoard
import javino.sim.PseudoTerminals
import javino.sim.SimulatedBoard
import javino.sim.SimulatedBoards
import java.nio.file.Files
import java.nio.file.Path
import kotlin.random.Random

private val COUNT = Regex("""count\((\d+)\)""")
private val withSignals: Enabled =
    if (System.getProperty("os.name").startsWith("Windows")) Enabled.disabled("needs the signals of a POSIX system") else withTerminals

class RealLinesSpec : FunSpec({
    /** Returns an agent that sends its last percept back to its board, so that the test can see what the agent perceives. */
    fun follower(port: String) = """
        !start.
        +!start <- argo.port("$port", [baud(115200)]); argo.limit(5); argo.percepts(open).
        +seen(X) <- argo.act(saw(X)).
    """

    fun onTerminals(name: String, body: suspend (FakeBoard, Path) -> Unit) =
        test(name).config(enabledOrReasonIf = { withTerminals }, blockingTest = true) {
            val directory = Files.createTempDirectory("argo-returning")
            try {
                FakeBoard.plugIn("far").use { body(it.lenient(), directory.resolve("board")) }
            } finally {
                directory.toFile().deleteRecursively()
            }
        }

    /** Returns when the agent has perceived the board's new percept and acted on it. */
    suspend fun FakeBoard.shows(what: String) {
        whenAsked("getPercepts").answer("seen($what);")
        eventually(LIMIT) { received() shouldContain "saw($what)" }
    }

    onTerminals("a terminal whose far end is closed and opened again under its old name is used again by itself") { board, name ->
        LocalMas().use { mas ->
            TerminalBoard(board).use { terminal ->
                name.pointTo(terminal.device)
                mas.agent("bob", follower("$name"))
                board.shows("first")
            }
            mas.awaitBelief("bob", "port(\"$name\",off)")
            mas.beliefs("bob") shouldContain "seen(first)"
            name.pointTo(null)
            TerminalBoard(board).use { terminal ->
                name.pointTo(terminal.device)
                board.shows("second")
                mas.awaitBelief("bob", "port(\"$name\",on)")
            }
        }
    }

    onTerminals("a name that leads to another device when the first has gone is followed") { board, name ->
        LocalMas().use { mas ->
            TerminalBoard(board).use { first ->
                name.pointTo(first.device)
                mas.agent("bob", follower("$name"))
                board.shows("first")
                TerminalBoard(board).use { second ->
                    check(first.device != second.device)
                    name.pointTo(second.device)
                    board.shows("still_first")
                    first.close()
                    eventually(LIMIT) { mas.log shouldContain "port \"$name\" is off" } // the belief may be too short to be seen
                    mas.awaitBelief("bob", "port(\"$name\",on)")
                    board.shows("second")
                }
            }
        }
    }

    onTerminals("a board that is known by its USB identity is found under another name") { board, _ ->
        LocalMas().use { mas ->
            val port = "plugged:fff1:0002:A1"
            try {
                TerminalBoard(board).use { terminal ->
                    PluggedIn.devices += PluggedIn.device("${terminal.device}")
                    mas.agent("bob", follower(port))
                    board.shows("first")
                    PluggedIn.devices.clear()
                }
                mas.awaitBelief("bob", "port(\"$port\",off)")
                TerminalBoard(board).use { terminal ->
                    PluggedIn.devices += PluggedIn.device("${terminal.device}")
                    mas.awaitBelief("bob", "port(\"$port\",on)")
                    board.shows("second")
                }
            } finally {
                PluggedIn.devices.clear()
            }
        }
    }

    test("a board whose process is stopped is in timeout meanwhile, and nothing that was believed is lost")
        .config(enabledOrReasonIf = { withSignals }, blockingTest = true) {
            PseudoTerminals.open().use { terminals ->
                BoardProcess(terminals.board().path).use { board ->
                    LocalMas().use { mas ->
                        val port = terminals.computer().path
                        mas.agent("bob", """
                            !start.
                            +!start <- argo.port("$port", [baud(115200), stale(2000)]); argo.limit(10); argo.percepts(open).
                            +!reach(G) <- +reached(G).
                            -count(_) : not count(_) <- +lost.
                            +port(P,off) <- +lost.
                        """)

                        fun count() = mas.beliefs("bob").firstNotNullOfOrNull { COUNT.matchEntire(it) }?.groupValues?.get(1)?.toInt() ?: 0
                        eventually(LIMIT) { count() shouldBeGreaterThan 10 }
                        board.stop()
                        mas.awaitBelief("bob", "port(\"$port\",timeout)")
                        val before = count()
                        mas.achieve("bob", "reach(while_stopped)")
                        mas.awaitBelief("bob", "reached(while_stopped)")
                        mas.awaitBelief("bob", "stale(\"$port\")")
                        count() shouldBe before
                        board.goOn()
                        mas.awaitBelief("bob", "port(\"$port\",on)")
                        eventually(LIMIT) { count() shouldBeGreaterThan before + 10 }
                        mas.beliefs("bob").contains("lost") shouldBe false
                    }
                }
            }
        }

    test("a board that sends garbage at full rate is in timeout, fills neither log nor beliefs, and does not hold its agent up") {
        val random = Random(4711)
        SimulatedBoards.plugIn("garbage", SimulatedBoard { line ->
            while (true) line.write(random.nextBytes(256), 0, 256, 1000)
        })
        try {
            LocalMas().use { mas ->
                mas.agent("bob", """
                    !start.
                    +!start <- argo.port("sim:garbage", [baud(1000000), boot(100), timeout(50)]); argo.limit(0); argo.percepts(open).
                    +!reach(G) <- +reached(G).
                """)
                mas.awaitBelief("bob", "port(\"sim:garbage\",timeout)")
                val before = mas.beliefs("bob")
                repeat(20) {
                    mas.achieve("bob", "reach(g$it)")
                    mas.awaitBelief("bob", "reached(g$it)")
                }
                mas.beliefs("bob").filterNot { it.startsWith("reached(") || it.startsWith("stale(") } shouldContainExactlyInAnyOrder
                    before.filterNot { it.startsWith("stale(") }
                mas.log.lines().size shouldBeLessThan 20
            }
        } finally {
            SimulatedBoards.unplug("garbage")
        }
    }

    test("a connection that is cut is made again, and a board that was off is waited for with one line of log for each change") {
        LocalMas().use { mas ->
            val number = NetworkBoard().use { board ->
                mas.agent("bob", """
                    !start.
                    +!start <- argo.port("${board.port}"); argo.limit(5); argo.percepts(open).
                    +count(N) <- argo.act(saw(N)).
                """)
                eventually(LIMIT) { board.received.size shouldBeGreaterThan 0 }
                board.cut()
                eventually(LIMIT) { mas.log shouldContain "port \"${board.port}\" is off" } // the belief may be too short to be seen
                val before = board.received.size
                mas.awaitBelief("bob", "port(\"${board.port}\",on)")
                eventually(LIMIT) { board.received.size shouldBeGreaterThan before + 5 }
                board.number
            }
            val port = "tcp://127.0.0.1:$number"
            mas.awaitBelief("bob", "port(\"$port\",off)")
            eventually(LIMIT) { mas.log shouldContain "still off" }
            NetworkBoard(number).use { board ->
                mas.awaitBelief("bob", "port(\"$port\",on)")
                eventually(LIMIT) { board.received.size shouldBeGreaterThan 5 }
                mas.log.lines().count { "port \"$port\" is " in it } shouldBe 6
            }
        }
    }
})
