package argo.jason

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldNotContain
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import javino.sim.FakeBoard

private const val LIMIT_MS = 20_000

class CriticalSpec : FunSpec({
    /** A board whose front distance a test sets. */
    class Robot(version2: Boolean = false) : AutoCloseable {
        val board: FakeBoard = FakeBoard.plugIn("robot").lenient()

        @Volatile
        var cm = 90
        private var n = 0

        init {
            if (version2) board.version2()
            board.whenAsked("getPercepts").answer { "dist(f,$cm);light(${n++});" }
            board.whenAsked("getPercepts(light,dist)").answer { "dist(f,$cm);light(${n++});" }
        }

        fun stops() = board.received().count { it == "stop" }

        /** Returns when the agent has seen at least three more messages. */
        fun awaitMessages() {
            val before = board.received().count { it.startsWith("getPercepts") }
            eventually({ board.received().takeLast(5) }) { board.received().count { it.startsWith("getPercepts") } > before + 3 }
        }

        override fun close() = board.close()
    }

    fun TestMas.filter(rules: String, root: String = "") = file("filters/careful.xml", "<PerceptionFilter $root>$rules</PerceptionFilter>")
    val near = """<critical reflex="stop"><predicate>dist</predicate><parameter id="1" operator="LT">15</parameter></critical>"""
    val start = "+!start <- argo.port(\"sim:robot\", [baud(115200)]); argo.limit(10); argo.change_filter(careful); argo.percepts(open)."

    test("its plan runs before the hundreds of events that wait") {
        Robot().use { robot ->
            TestMas().use { mas ->
                mas.filter("""<critical><predicate>dist</predicate><parameter id="1" operator="LT">15</parameter></critical><filter><predicate>light</predicate></filter>""")
                val busy = hold.next()
                mas.agent("bob", """
                    !start.
                    $start
                    +dist(f,X) : X < 15 <- .count(handled(_), N); argo.act(stop_after(N)).
                    +dist(f,X) <- +sees.
                    +room(I) : not held <- argo.jason.hold; +held; +handled(I).
                    +room(I) <- +handled(I).
                """)
                eventually({ mas.beliefs("bob") }) { "sees" in mas.beliefs("bob") }
                mas.perceive(*Array(500) { "room(${it + 1})" })
                busy.awaitBegin()
                robot.cm = 9
                robot.awaitMessages()
                mas.beliefs("bob").count { it.startsWith("handled") } shouldBe 0 // all the events wait
                busy.over.countDown()
                eventually({ robot.board.received().takeLast(5) }) { robot.board.received().any { it.startsWith("stop_after") } }
                val handled = Regex("\\d+").find(robot.board.received().first { it.startsWith("stop_after") })!!.value.toInt()
                check(handled <= 20) { "$handled of 500 events were handled first" }
                eventually({ mas.beliefs("bob").size }) { mas.beliefs("bob").count { it.startsWith("handled") } == 500 }
            }
        }
    }

    test("a reflex goes out while the agent is busy, once while its rule stays met, and again when it begins anew") {
        Robot().use { robot ->
            TestMas().use { mas ->
                mas.filter(near + "<filter><predicate>dist</predicate></filter>")
                val busy = hold.next()
                mas.agent("bob", """
                    !start.
                    $start
                    +light(_) : not held <- +held; argo.jason.hold.
                    +dist(f,9) <- +saw_it.
                """)
                busy.awaitBegin()
                robot.awaitMessages()
                robot.stops() shouldBe 0
                robot.cm = 9
                robot.board.awaitMessage("stop", LIMIT_MS)
                robot.awaitMessages()
                robot.stops() shouldBe 1
                robot.cm = 80
                robot.awaitMessages()
                robot.cm = 8
                eventually({ robot.board.received().takeLast(9) }) { robot.stops() == 2 }
                mas.beliefs("bob") shouldNotContain "dist(f,9)"
                robot.cm = 9
                busy.over.countDown()
                eventually({ mas.beliefs("bob") }) { "saw_it" in mas.beliefs("bob") } // though the filter drops every dist
                robot.stops() shouldBe 2
            }
        }
    }

    test("a reflex goes before commands that wait") {
        Robot().use { robot ->
            TestMas().use { mas ->
                mas.filter(near)
                mas.agent("bob", """
                    !start.
                    $start
                    +light(_) : not sent & dist(f,90) <- +sent; for (.range(I,1,300)) { !!walk(I) }; +walking.
                    +!walk(I) <- argo.act(walk(I)).
                """)
                eventually({ mas.beliefs("bob") }) { "walking" in mas.beliefs("bob") }
                robot.cm = 9
                robot.board.awaitMessage("stop", LIMIT_MS)
                check("walk(300)" !in robot.board.received()) { "it came last" }
                robot.board.awaitMessage("walk(300)", LIMIT_MS)
            }
        }
    }

    test("a reflex that a board refuses is told once, and sensing goes on") {
        Robot(version2 = true).use { robot ->
            robot.board.whenAsked("stop").refuse()
            TestMas().use { mas ->
                mas.filter(near)
                mas.agent("bob", """
                    !start.
                    +!start <- argo.port("sim:robot", [baud(115200), protocol(2)]); argo.limit(10); argo.change_filter(careful); argo.percepts(open).
                    +dist(f,X) : X < 15 <- argo.act(saw(X)).
                """)
                for (cm in listOf(9, 90, 8, 90, 7)) {
                    robot.cm = cm
                    if (cm < 15) robot.board.awaitMessage("saw($cm)", LIMIT_MS) else robot.awaitMessages()
                }
                eventually({ robot.board.received().takeLast(9) }) { robot.stops() >= 3 }
                Regex("the reflex stop of the critical rule").findAll(mas.log).count() shouldBe 1
                mas.log shouldContain "refuses \"stop\""
                mas.beliefs("bob") shouldContain "port(\"sim:robot\",on)"
            }
        }
    }

    test("a filter that keeps other functors has a board of version 2 asked for critical ones too") {
        Robot(version2 = true).use { robot ->
            TestMas().use { mas ->
                mas.filter(near + "<filter><predicate>light</predicate></filter>", "keep=\"true\"")
                mas.agent("bob", """
                    !start.
                    +!start <- argo.port("sim:robot", [baud(115200), protocol(2)]); argo.limit(10); argo.change_filter(careful); argo.percepts(open).
                    +dist(f,X) <- argo.act(saw(X)).
                """)
                eventually({ robot.board.received().takeLast(5) }) { "getPercepts(light,dist)" in robot.board.received() }
                robot.awaitMessages()
                robot.cm = 9
                robot.board.awaitMessage("saw(9)", LIMIT_MS)
                robot.board.received() shouldNotContain "saw(90)"
                robot.board.received() shouldContain "stop"
            }
        }
    }

    test("without its filter, or while perceiving is blocked, no reflex is sent") {
        Robot().use { robot ->
            TestMas().use { mas ->
                mas.filter(near)
                mas.agent("bob", """
                    !start.
                    $start
                    +!off <- argo.change_filter(none); +off.
                    +!blocked <- argo.percepts(block); argo.change_filter(careful); +blocked.
                    +!open <- argo.percepts(open).
                """)
                robot.awaitMessages()
                mas.achieve("bob", "off")
                eventually({ mas.beliefs("bob") }) { "off" in mas.beliefs("bob") }
                robot.cm = 9
                eventually({ mas.beliefs("bob") }) { "dist(f,9)" in mas.beliefs("bob") }
                robot.awaitMessages()
                mas.achieve("bob", "blocked")
                eventually({ mas.beliefs("bob") }) { "blocked" in mas.beliefs("bob") }
                robot.stops() shouldBe 0
                mas.achieve("bob", "open")
                robot.board.awaitMessage("stop", LIMIT_MS)
            }
        }
    }

    test("under in_cycle its reflex is sent too") {
        Robot().use { robot ->
            TestMas().use { mas ->
                mas.filter(near)
                mas.agent("bob", "!start.\n$start", options = mapOf("argo_sensing" to "in_cycle"))
                robot.awaitMessages()
                robot.cm = 9
                robot.board.awaitMessage("stop", LIMIT_MS)
                robot.awaitMessages()
                robot.stops() shouldBe 1
            }
        }
    }
})
