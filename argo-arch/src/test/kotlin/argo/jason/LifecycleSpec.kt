package argo.jason

import argo.Arch
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import jason.architecture.AgArch
import javino.Link
import javino.sim.FakeBoard
import java.util.concurrent.CopyOnWriteArrayList

private const val LIMIT_MS = 20_000

class LifecycleSpec : FunSpec({
    test("200 agents started and killed in one system leave no thread and no open port") {
        val boards = (1..200).map { FakeBoard.plugIn("robot$it").lenient() }
        try {
            boards.forEach { board -> var n = 0; board.whenAsked("getPercepts").answer { "dist(f,${++n});" } }
            TestMas().use { mas ->
                (1..200).forEach { i ->
                    mas.agent("bob$i", """
                        !start.
                        +!start <- argo.port("sim:robot$i", [baud(1000000)]); argo.limit(50); argo.percepts(open).
                        +dist(f,X) <- argo.act(seen(X)).
                    """)
                }
                boards.forEach { board -> eventually({ "${board.port()}: ${board.received()}" }) { board.received().any { it.startsWith("seen") } } }
                (1..200).forEach { mas.kill("bob$it") }
                eventually(::argoThreads) { argoThreads().isEmpty() }
                boards.mapNotNull { Link.ownerOf(it.port()).orElse(null) }.shouldBeEmpty()
            }
        } finally {
            boards.forEach { it.close() }
        }
    }

    test("an agent that is killed while a command waits and a port is being opened leaves nothing") {
        FakeBoard.plugIn("robot").use { board ->
            board.lenient().stall()
            TestMas().use { mas ->
                mas.agent("bob", "!start.\n+!start <- argo.port(\"sim:robot\"); argo.percepts(open); argo.act(front).")
                board.awaitOpen(LIMIT_MS)
                mas.kill("bob")
                eventually(::agentThreads) { agentThreads().isEmpty() } // the board itself is still stalled
                Link.ownerOf("sim:robot").isPresent shouldBe false
            }
        }
    }

    test("argo.port(none) gives all ports back and nothing is believed of them") {
        FakeBoard.plugIn("left").use { left ->
            FakeBoard.plugIn("right").use { right ->
                TestMas().use { mas ->
                    mas.agent("bob", """
                        !start.
                        +!start <- argo.port("sim:left", [boot(0)]); argo.act(hello); argo.port("sim:right", [boot(0)]); argo.act(hello); .wait(50); argo.port(none); +closed.
                        +port(P,off) <- .print("off: ", P).
                    """)
                    left.awaitMessage("hello", LIMIT_MS)
                    right.awaitMessage("hello", LIMIT_MS)
                    eventually({ mas.beliefs("bob") }) { "closed" in mas.beliefs("bob") && mas.beliefs("bob").none { it.startsWith("port(") } }
                    Link.ownerOf("sim:left").isPresent shouldBe false
                    mas.log.lines().filter { "off: " in it }.shouldBeEmpty()
                }
            }
        }
    }

    test("every snapshot reaches an agent whose sensing policy is every") {
        FakeBoard.plugIn("robot").use { board ->
            var n = 0
            board.whenAsked("getPercepts").answer { "count(${++n});" }
            TestMas().use { mas ->
                mas.agent("bob", """
                    seen(0).
                    !start.
                    +!start <- argo.port("sim:robot", [baud(1000000)]); argo.limit(0); argo.percepts(open).
                    @c[atomic] +count(N) : seen(M) & N > 1 & N \== M+1 & M > 0 <- .print("missed from ", M, " to ", N); -+seen(N).
                    @d[atomic] +count(N) : N < 200 <- -+seen(N).
                    +count(200) <- argo.percepts(block); argo.act(done).
                """, options = mapOf("argo_sensing" to "every"))
                board.awaitMessage("done", LIMIT_MS)
                mas.log.lines().filter { "missed" in it }.shouldBeEmpty()
            }
        }
    }

    test("in_cycle asks inside the reasoning cycle, says so, and no other thread senses or acts") {
        FakeBoard.plugIn("robot").use { board ->
            var n = 0
            board.whenAsked("getPercepts").answer { "count(${++n});" }
            TestMas().use { mas ->
                mas.agent("bob", """
                    !start.
                    +!start <- argo.port("sim:robot"); argo.limit(5); argo.percepts(open).
                    +count(5) <- argo.act(done).
                """, options = mapOf("argo_sensing" to "in_cycle"))
                board.awaitMessage("done", LIMIT_MS)
                argoThreads().filter { "sensing" in it || "acting" in it }.shouldBeEmpty()
                mas.log shouldContain "for comparison only"
            }
        }
    }

    test("a policy that does not exist, or an option that does not, is reported and the agent works with the default") {
        FakeBoard.plugIn("robot").use { board ->
            TestMas().use { mas ->
                mas.agent("bob", "!start.\n+!start <- argo.port(\"sim:robot\", [boot(0)]); argo.act(ok).", options = mapOf("argo_sensing" to "freshest", "argo_speed" to "9"))
                board.awaitMessage("ok", LIMIT_MS)
                mas.log shouldContain "argo_sensing=freshest: a policy is one of fresh, every, in_cycle; fresh is used"
                mas.log shouldContain "argo_speed is not an option of argo.Arch"
            }
        }
    }

    test("an architecture behind it is stopped once, by the Local infrastructure, which stops each") {
        CountedStops.all.clear()
        TestMas().use { it.agent("bob", "", behind = CountedStops::class.java.name) }
        CountedStops.all.map { it.stops } shouldBe listOf(1)
    }

    test("an architecture behind it is stopped once where the first one alone is told, as on JADE") {
        val behind = CountedStops()
        behind.insertAgArch(Arch())
        behind.firstAgArch.stop()
        behind.stops shouldBe 1
    }
})

/** An architecture, such as CArtAgO's, for which it matters how often it is stopped. Jason makes it, so all of them are kept. */
class CountedStops : AgArch() {
    var stops = 0
        private set

    init {
        all += this
    }

    override fun stop() {
        stops++
        super.stop()
    }

    companion object {
        val all = CopyOnWriteArrayList<CountedStops>()
    }
}

private fun threads(): List<String> = Thread.getAllStackTraces().keys.map { it.name }

private fun agentThreads(): List<String> = threads().filter { it.startsWith("argo-") || it.startsWith("write ") }

private fun argoThreads(): List<String> = agentThreads() + threads().filter { it.startsWith("board sim:") }
