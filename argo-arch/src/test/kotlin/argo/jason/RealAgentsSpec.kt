package argo.jason

import io.kotest.assertions.nondeterministic.eventually
import io.kotest.core.NamedTag
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainAll
import io.kotest.matchers.ints.shouldBeLessThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import jason.architecture.AgArch
import javino.link.Link
import javino.sim.FakeBoard
import java.util.concurrent.CopyOnWriteArrayList
import java.util.concurrent.locks.LockSupport

/** Behaviour that only Jason's own infrastructure and real threads show. argo-testkit specifies all other behaviour in virtual time. */
class RealAgentsSpec : FunSpec({
    test("200 agents started and killed in one system leave no thread and no open port").config(tags = thorough) {
        val boards = (1..200).map { FakeBoard.plugIn("robot$it").lenient() }
        try {
            boards.forEach { board ->
                var n = 0
                board.whenAsked("getPercepts").answer { "dist(f,${++n});" }
            }
            LocalMas().use { mas ->
                (1..200).forEach { i ->
                    mas.agent("bob$i", """
                        !start.
                        +!start <- argo.port("sim:robot$i", [baud(1000000)]); argo.limit(50); argo.percepts(open).
                        +dist(f,X) <- argo.act(seen(X)).
                    """)
                }
                fun unseen() = boards.filter { board -> board.received().none { it.startsWith("seen") } }.map { it.port() }
                awaitGrowth(boards.size, { "not acted on: ${unseen()}" }) { boards.size - unseen().size }
                (1..200).forEach { mas.kill("bob$it") }
                eventually(LIMIT) { argoThreads().shouldBeEmpty() }
                boards.mapNotNull { Link.ownerOf(it.port()).orElse(null) }.shouldBeEmpty()
            }
        } finally {
            boards.forEach { it.close() }
        }
    }

    test("a port belongs to one agent, and a second one is told whose it is") {
        FakeBoard.plugIn("robot").lenient().use { board ->
            LocalMas().use { mas ->
                mas.agent("alice", "!start.\n+!start <- argo.port(\"sim:robot\", [boot(0)]); argo.act(mine).")
                eventually(LIMIT) { board.received() shouldContain "mine" }
                mas.agent("bob", "!start.\n+!start <- argo.port(\"sim:robot\").\n-!start[error(E),error_msg(M)] <- .print(E, \" \", M).")
                eventually(LIMIT) { mas.log.lines().filter { "port_busy" in it && "alice" in it }.size shouldBe 1 }
                mas.kill("alice")
                mas.agent("carol", """
                    !start.
                    +!start <- argo.port("sim:robot", [boot(0)]); argo.act(now_mine).
                    -!start <- .wait(10); !start.
                """)
                eventually(LIMIT) { board.received() shouldContain "now_mine" }
            }
        }
    }

    test("a port that the machine does not have fails the plan") {
        LocalMas().use { mas ->
            mas.agent("bob", """
                !open("sim:nobody"). !open(no_such_device_here). !open("COM77").
                +!open(P) <- argo.port(P); +opened(P).
                -!open(P)[error(E)] <- +failed(P,E).
            """)
            listOf("\"sim:nobody\"", "no_such_device_here", "\"COM77\"").forEach { mas.awaitBelief("bob", "failed($it,no_such_port)") }
        }
    }

    test("commands of a port that is closed and opened again all the while go out or fail for that reason, and no intention is lost") {
        FakeBoard.plugIn("robot").lenient().use { board ->
            LocalMas().use { mas ->
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
                eventually(LIMIT) { board.received().filter { it != "front" } shouldContainAll (1..10).map { "alive($it)" } }
                mas.log.lines().filter { "ODD" in it || "SEVERE" in it }.shouldBeEmpty()
            }
        }
    }

    test("the world does not stand still for an agent that keeps the events no plan applies to, and so never sleeps") {
        FakeBoard.plugIn("robot").lenient().use { board ->
            var n = 80
            board.whenAsked("getPercepts").answer { "dist(f,${n--});light(f,$n);" }
            LocalMas().use { mas ->
                mas.agent("bob", """
                    !start.
                    +!start <- argo.port("sim:robot", [baud(115200)]); argo.limit(5); argo.percepts(open); .wait(dist(f,_)); !drive.
                    +!drive : dist(f,X) & X > 40 <- argo.act(front); !drive.
                    +!drive <- argo.act(stop).
                    +light(f,X) : X > 1000 <- argo.act(bright).
                """, options = mapOf("events" to "requeue"))
                eventually(LIMIT) { board.received() shouldContain "stop" }
            }
        }
    }

    test("an agent that is slower than its board does not pile up the intentions that percepts begin") {
        val sensors = 40
        FakeBoard.plugIn("robot").lenient().use { board ->
            var n = 0
            board.version2()
            board.whenAsked("getPercepts").answer { n++.let { (1..sensors).joinToString("") { i -> "light($i,$n);" } } }
            LocalMas().use { mas ->
                mas.agent("bob", """
                    !start.
                    +!start <- argo.port("sim:robot", [baud(1000000)]); argo.limit(0); argo.percepts(open).
                    +light(I,N) <- .abolish(none); .abolish(none); .abolish(none); .abolish(none).
                """, behind = SlowCycles::class.java.name)
                eventually(LIMIT) { (n > 30) shouldBe true }
            }
        }
        SlowCycles.most shouldBeLessThan 2 * sensors
    }

    test("an architecture behind argo.Arch is stopped once, by the Local infrastructure, which stops each") {
        CountedStops.all.clear()
        LocalMas().use { it.agent("bob", "", behind = CountedStops::class.java.name) }
        CountedStops.all.map { it.stops } shouldBe listOf(1)
    }
})

/** An architecture that counts its stops, since some, such as CArtAgO's, fail at a second stop. Jason makes it, so all objects are kept. */
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

/** Lengthens each reasoning cycle by half a millisecond, and records the largest number of intentions. Jason makes it. */
class SlowCycles : AgArch() {
    override fun reasoningCycleFinished() {
        super.reasoningCycleFinished()
        most = maxOf(most, ts.c.runningIntentions.size)
        LockSupport.parkNanos(CYCLE_NANOS)
    }

    companion object {
        private const val CYCLE_NANOS = 500_000L

        @Volatile
        var most = 0
    }
}

internal fun threads(): List<String> = Thread.getAllStackTraces().keys.map { it.name }

internal fun agentThreads(): List<String> = threads().filter { it.startsWith("argo-") || it.startsWith("write ") }

private fun argoThreads(): List<String> = agentThreads() + threads().filter { it.startsWith("board sim:") }

private val thorough = setOf(NamedTag("Thorough"))
