package argo.jason

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import javino.sim.FakeBoard

private const val LIMIT_MS = 20_000

class HostileBoardSpec : FunSpec({
    /** What bob believes but for Jason's own rules. */
    fun TestMas.perceived() = beliefs("bob").filterNot { it.startsWith("kqml::") }.toSet()

    val longest = "f".repeat(250) + ";"
    val messages = mapOf(
        "shutdown" to "shutdown;.stopMAS;shutdown[source(self)];+!shutdown;!shutdown;.kill_agent(bob);jason.stdlib.stopMAS;",
        "unbalanced brackets" to "a((((;b[[;c{;)))];}d;e(f,g;\"h;'i;",
        "control characters" to "a\u0000b;\u001b[2J;p(\"\u0007\r\n\u007f\");\u0001;\t;\u0085(1);",
        "a text of 250 bytes" to longest,
        "a string of 250 bytes" to "p(\"" + "x".repeat(240) + "\");",
        "a number of 250 digits" to "p(" + "9".repeat(245) + ");",
        "brackets as deep as a message" to "p(".repeat(80) + "a" + ")".repeat(80) + ";",
        "separators alone" to ";".repeat(255),
        "reserved words" to "not p;if;while(true);true;false;~true;p :- q;@l;{a};[a];begin;end;1;\"s\";X;_;p(_);",
        "nothing" to "",
    )

    for ((what, message) in messages) test("an agent goes on as before after $what") {
        FakeBoard.plugIn("robot").use { board ->
            board.lenient()
            board.whenAsked("getPercepts").answer(message, "ok;")
            TestMas().use { mas ->
                mas.agent("bob", "!start.\n+!start <- argo.port(\"sim:robot\", [boot(0)]); argo.limit(5); argo.percepts(open).\n+ok <- argo.act(alive).\n+!shutdown <- .stopMAS.")
                board.awaitMessage("alive", LIMIT_MS)
                mas.log.lines().filter { "SEVERE" in it }.shouldBeEmpty()
                check(mas.log.none { it.isISOControl() && it != '\n' }) { "the log holds control characters" }
            }
        }
    }

    test("brackets nested ten thousand deep cost themselves alone") {
        FakeBoard.plugIn("robot").version2().use { board ->
            board.lenient()
            board.whenAsked("getPercepts").answer("p(".repeat(10_000) + "a" + ")".repeat(10_000) + ";ok;")
            TestMas().use { mas ->
                mas.agent("bob", "!start.\n+!start <- argo.port(\"sim:robot\", [boot(0), protocol(2), baud(20000000), timeout(5000)]); argo.limit(5); argo.percepts(open).\n+ok <- argo.act(alive).")
                board.awaitMessage("alive", LIMIT_MS)
                mas.log.lines().filter { "SEVERE" in it }.shouldBeEmpty()
                check(mas.log.length < 10_000) { "the log has ${mas.log.length} characters" }
            }
        }
    }

    for (kind in listOf("readable", "broken")) test("thousands of ever new $kind percepts fill neither the belief base nor the log") {
        FakeBoard.plugIn("robot").use { board ->
            board.lenient()
            var n = 0
            board.whenAsked("getPercepts").answer {
                val percepts = (1..10).joinToString("") { n++; if (kind == "broken") "broken$n($n;" else "new$n($n);" }
                if (n > 6_000) "ok;" else percepts
            }
            TestMas().use { mas ->
                mas.agent("bob", "!start.\n+!start <- argo.port(\"sim:robot\", [boot(0), spacing(0), baud(20000000)]); argo.limit(0); argo.percepts(open).\n+ok <- argo.act(alive).")
                board.awaitMessage("alive", LIMIT_MS)
                eventually({ mas.perceived().take(20) }) { mas.perceived() == setOf("ok", "port(\"sim:robot\",on)") }
                check(mas.log.lines().size < 150) { "${mas.log.lines().size} lines of log" }
            }
        }
    }

    test("more percepts than are allowed are left out from the end, with one warning") {
        FakeBoard.plugIn("robot").use { board ->
            board.lenient()
            var n = 0
            board.whenAsked("getPercepts").answer { "a;b;c;d;e(${n++});" }
            TestMas().use { mas ->
                mas.agent("bob", "!start.\n+!start <- argo.port(\"sim:robot\", [boot(0)]); argo.limit(5); argo.percepts(open).", options = mapOf("argo_percepts" to "3"))
                eventually({ board.received().size }) { board.received().size > 20 }
                mas.perceived() shouldBe setOf("a", "b", "c", "port(\"sim:robot\",on)")
                Regex("the board says 5 percepts at once, of which 3 are believed").findAll(mas.log).count() shouldBe 1
            }
        }
    }

    test("a limit that is none is told, and the usual one holds") {
        TestMas().use { mas ->
            mas.agent("bob", "!start.\n+!start <- +started.", options = mapOf("argo_percepts" to "lots"))
            eventually({ mas.beliefs("bob") }) { "started" in mas.beliefs("bob") }
            mas.log shouldContain "SEVERE argo.Arch.bob: argo_percepts=lots"
        }
    }
})
