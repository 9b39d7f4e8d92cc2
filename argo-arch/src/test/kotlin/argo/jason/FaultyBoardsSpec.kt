package argo.jason

import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainExactlyInAnyOrder
import io.kotest.matchers.ints.shouldBeLessThan
import io.kotest.matchers.shouldBe
import javino.Link
import javino.sim.FakeBoard
import javino.sim.PseudoTerminals
import javino.sim.SimulatedBoard
import javino.sim.SimulatedBoards
import java.io.DataInputStream
import java.util.concurrent.TimeUnit
import kotlin.random.Random
import kotlin.time.Duration.Companion.seconds

private const val LIMIT_MS = 20_000
private const val STOPPED_SECONDS = 5L

private val withSignals: Enabled =
    if (System.getProperty("os.name").startsWith("Windows")) Enabled.disabled("needs the signals of a POSIX system") else withTerminals

/** Boards that do what no board should, and what the agent makes of it. */
class FaultyBoardsSpec : FunSpec({
    fun TestMas.awaitBelief(belief: String) = eventually({ beliefs("bob") }) { belief in beliefs("bob") }

    /** The agent reasons still: it reaches a goal that needs no board. */
    fun TestMas.awaitCycles(goal: String) {
        achieve("bob", "reach($goal)")
        awaitBelief("reached($goal)")
    }

    /** The last count that the agent knows; 0 where it is just being replaced by the next. */
    fun TestMas.count(): Int = beliefs("bob").singleOrNull { it.startsWith("count(") }?.removeSurrounding("count(", ")")?.toInt() ?: 0

    test("a board whose process is stopped for five seconds is in timeout meanwhile, and nothing that was believed is lost").config(enabledOrReasonIf = { withSignals }, timeout = 120.seconds, blockingTest = true) {
        PseudoTerminals.open().use { terminals ->
            BoardProcess(terminals.board().path).use { board ->
                TestMas().use { mas ->
                    val port = terminals.computer().path
                    mas.agent("bob", """
                        !start.
                        +!start <- argo.port("$port", [baud(115200)]); argo.limit(10); argo.percepts(open).
                        +!reach(G) <- +reached(G).
                        -count(_) : not count(_) <- +lost.
                        +port(P,off) <- +lost.
                    """)
                    eventually({ mas.beliefs("bob") }) { mas.count() > 10 }
                    board.stop()
                    val stopped = System.nanoTime()
                    mas.awaitBelief("port(\"$port\",timeout)")
                    mas.awaitCycles("while_stopped")
                    val before = mas.count()
                    TimeUnit.NANOSECONDS.sleep(TimeUnit.SECONDS.toNanos(STOPPED_SECONDS) - (System.nanoTime() - stopped)) // what is tried is a real process that is stopped for real
                    mas.count() shouldBe before
                    board.goOn()
                    mas.awaitBelief("port(\"$port\",on)")
                    eventually({ mas.beliefs("bob") }) { mas.count() > before + 10 }
                    mas.beliefs("bob").contains("lost") shouldBe false
                }
            }
        }
    }

    test("a board that never answers is in timeout, gets its commands all the same, and does not hold its agent up") {
        FakeBoard.plugIn("mute").use { board ->
            board.lenient().whenAsked("getPercepts").staySilent()
            TestMas().use { mas ->
                mas.agent("bob", """
                    !start.
                    +!start <- argo.port("sim:mute", [boot(500), timeout(50)]); argo.limit(5); argo.percepts(open); argo.act(hello).
                    +!reach(G) <- +reached(G).
                """)
                mas.awaitCycles("at_once")
                board.awaitMessage("hello", LIMIT_MS)
                mas.awaitBelief("port(\"sim:mute\",timeout)")
                mas.awaitCycles("in_timeout")
                mas.log.lines().count { "port \"sim:mute\" is " in it } shouldBe 2
            }
        }
    }

    test("a board that says garbage at full rate is in timeout, fills neither log nor beliefs, and does not hold its agent up") {
        val random = Random(4711)
        SimulatedBoards.plugIn("garbage", SimulatedBoard { line ->
            while (true) line.write(random.nextBytes(256), 0, 256, 1000)
        })
        try {
            TestMas().use { mas ->
                mas.agent("bob", """
                    !start.
                    +!start <- argo.port("sim:garbage", [baud(1000000), boot(100), timeout(50)]); argo.limit(0); argo.percepts(open).
                    +!reach(G) <- +reached(G).
                """)
                mas.awaitBelief("port(\"sim:garbage\",timeout)")
                val before = mas.beliefs("bob")
                repeat(20) { mas.awaitCycles("g$it") }
                mas.beliefs("bob").filterNot { it.startsWith("reached(") } shouldContainExactlyInAnyOrder before
                mas.log.lines().size shouldBeLessThan 20
            }
        } finally {
            SimulatedBoards.unplug("garbage")
        }
    }

    test("an agent uses 127 boards in turn, each holding its port open, and a 128th is refused").config(enabledOrReasonIf = { withTerminals }, timeout = 120.seconds, blockingTest = true) {
        val terminals = (1..128).map { PseudoTerminals.open() }
        try {
            TestMas().use { mas ->
                mas.agent("bob", """
                    +!greet(I,P) <- argo.port(P, [boot(0), baud(115200), protocol(1)]); argo.act(hello(I)); +greeted(I).
                    -!greet(I,P)[error(E)] <- +refused(I,E).
                """)
                terminals.take(127).forEachIndexed { i, pair ->
                    mas.achieve("bob", "greet($i,\"${pair.computer().path}\")")
                    mas.awaitBelief("greeted($i)")
                    val frame = "hello($i)".let { "fffe%02X$it".format(it.length) }
                    pair.received(frame.length) shouldBe frame
                }
                mas.achieve("bob", "greet(127,\"${terminals.last().computer().path}\")")
                mas.awaitBelief("refused(127,too_many_ports)")
                terminals.take(127).all { Link.ownerOf(it.computer().path).orElse(null) == "bob" } shouldBe true
                mas.achieve("bob", "greet(0,\"${terminals.first().computer().path}\")") // and it goes back to the first
                terminals.first().received(14) shouldBe "fffe08hello(0)"
                mas.beliefs("bob") shouldContain "greeted(126)"
            }
        } finally {
            terminals.forEach(PseudoTerminals::close)
        }
    }
})

/** The next [count] bytes that the board at the far end gets. */
private fun PseudoTerminals.received(count: Int): String =
    DataInputStream(board().inputStream()).use { board -> String(ByteArray(count).also(board::readFully)) }
