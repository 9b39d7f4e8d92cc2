package argo.behaviour

import argo.testkit.TestAgent
import argo.testkit.agentOf
import io.kotest.core.NamedTag
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.ints.shouldBeLessThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds

class HostileBoardSpec : FunSpec({
    val start = "!start.\n+!start <- argo.port(ttyACM0, [boot(0)]); argo.limit(5); argo.percepts(open)."

    fun TestAgent.shouldBeUnharmed() {
        log.filter { "SEVERE" in it }.shouldBeEmpty()
        check(log.none { line -> line.any { it.isISOControl() && it != '\n' } }) { "the log holds control characters" }
    }

    val messages = mapOf(
        "shutdown" to "shutdown;.stopMAS;shutdown[source(self)];+!shutdown;!shutdown;.kill_agent(bob);jason.stdlib.stopMAS;",
        "unbalanced brackets" to "a((((;b[[;c{;)))];}d;e(f,g;\"h;'i;",
        "control characters" to "a\u0000b;\u001b[2J;p(\"\u0007\r\n\u007f\");\u0001;\t;\u0085(1);",
        "a text of 250 bytes" to "f".repeat(250) + ";",
        "a string of 250 bytes" to "p(\"" + "x".repeat(240) + "\");",
        "a number of 250 digits" to "p(" + "9".repeat(245) + ");",
        "brackets as deep as a message" to "p(".repeat(80) + "a" + ")".repeat(80) + ";",
        "separators alone" to ";".repeat(255),
        "reserved words" to "not p;if;while(true);true;false;~true;p :- q;@l;{a};[a];begin;end;1;\"s\";X;_;p(_);",
        "nothing" to "",
    )
    for ((what, message) in messages) test("an agent goes on as before after $what") {
        agentOf("$start\n+ok <- argo.act(alive).\n+!shutdown <- .stopMAS.").use { bob ->
            bob.perceivesRaw(message)
            bob.after(500.milliseconds).board.requests.size shouldBeGreaterThan 3
            bob.perceives("ok").shouldSend("alive").shouldSendNothingElse().shouldBeUnharmed()
            bob.isRunning shouldBe true
        }
    }

    test("brackets nested ten thousand deep cost themselves alone") {
        agentOf("""
            !start.
            +!start <- argo.port(ttyACM0, [boot(0), protocol(2), baud(20000000), timeout(5000)]); argo.limit(5); argo.percepts(open).
            +ok <- argo.act(alive).
        """) { board.version2() }.use { bob ->
            bob.perceivesRaw("p(".repeat(10_000) + "a" + ")".repeat(10_000) + ";ok;").shouldSend("alive").shouldBeUnharmed()
            bob.log.sumOf { it.length } shouldBeLessThan 10_000
        }
    }

    for (kind in listOf("readable", "broken")) test("thousands of ever new $kind percepts fill neither the belief base nor the log")
        .config(tags = thorough) {
            agentOf("""
            !start.
            +!start <- argo.port(ttyACM0, [boot(0), spacing(0), baud(20000000)]); argo.limit(0); argo.percepts(open).
            +ok <- argo.act(alive).
        """) {
                var n = 0
                board.showsRaw {
                    val percepts = List(10) { n++; if (kind == "broken") "broken$n($n;" else "new$n($n);" }
                    if (n > 6_000) "ok;" else percepts.joinToString("")
                }
            }.use { bob ->
                bob.shouldSend("alive", within = 20.seconds).beliefs shouldBe listOf("ok", "port(ttyACM0,on)")
                bob.log.size shouldBeLessThan 150
            }
        }

    test("more percepts than are allowed are left out from the end, with one warning") {
        agentOf(start) {
            options("argo_percepts" to "3")
            var n = 0
            board.shows { listOf("a", "b", "c", "d", "e(${n++})") }
        }.use { bob ->
            bob.after(3.seconds).beliefs shouldBe listOf("a", "b", "c", "port(ttyACM0,on)")
            bob.board.requests.size shouldBeGreaterThan 20
            bob.log.count { "the board sends 5 percepts at once, of which 3 are believed" in it } shouldBe 1
        }
    }

    test("a limit that is none is told, and the usual one holds") {
        agentOf(start) { options("argo_percepts" to "lots") }.use { bob ->
            bob.perceives(*Array(60) { "p$it" }).beliefs.size shouldBe 61
            bob.log.joinToString("\n") shouldContain "SEVERE argo_percepts=lots"
        }
    }
})

private val thorough = setOf(NamedTag("Thorough"))
