package argo.recording

import argo.testkit.AgentSetUp
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import kotlin.time.Duration.Companion.milliseconds

/** What in a program gives another result each time is found by its replay, and named. */
class PlantedChanceSpec : FunSpec({
    fun differences(program: String, setUp: AgentSetUp.() -> Unit = {}) =
        replayOf(recorded(program, setUp) { after(300.milliseconds) }).differences

    for (action in listOf("clock", "dice", "name", "order", "counted", "calls", "ways")) {
        test("the internal action planted.$action, and what was recorded of it is used") {
            val found = differences("!start. +!start <- planted.$action(X); +seen(X); .print(X).")
            found.map { it.what }.distinct() shouldBe listOf("result of planted.$action")
            found.first().cause shouldContain "planted.$action"
        }
    }

    test("an internal action in a context") {
        differences("!start. +!start : planted.dice(X) & X \\== 0 <- .print(X).").first().what shouldBe "result of planted.dice"
    }

    test("an internal action in a rule") {
        differences("drawn(X) :- planted.clock(X). !start. +!start <- ?drawn(X); .print(X).").first().what shouldBe
            "result of planted.clock"
    }

    test("an internal action that fails in another way each time") {
        differences("!start. +!start <- planted.failing. -!start[error_msg(M)] <- .print(M).").first().what shouldBe
            "result of planted.failing"
    }

    test("a function of the project") {
        differences("{ register_function(\"planted.drift\") } !start. +!start <- X = planted.drift; .print(X).").first().what shouldBe
            "result of planted.drift"
    }

    test("a belief that an internal action adds besides its result") {
        val found = differences("!start. +!start <- planted.believes. +drawn(X) <- .print(X).")
        found.first().what shouldBe "event"
        found.first().cause shouldContain "planted.believes"
    }

    test("an agent's class that chooses differently") {
        val found = differences("!a. !b. +!a <- .print(a1); .print(a2). +!b <- .print(b1); .print(b2).") {
            agentClass = planted.Moody::class.java
        }
        found.first().cause shouldContain "planted.Moody"
    }

    test("but nothing in a program without chance") {
        differences("!start. +!start <- .wait(20); +a; .random(X); .print(X).").shouldBeEmpty()
    }
})
