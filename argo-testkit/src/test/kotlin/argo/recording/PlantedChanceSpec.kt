package argo.recording

import argo.testkit.AgentSetUp
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import jason.mas2j.ClassParameters
import kotlin.time.Duration.Companion.milliseconds

/** What in a program gives another result each time is found by its replay, and named. */
class PlantedChanceSpec : FunSpec({
    fun differences(program: String, setUp: AgentSetUp.() -> Unit = {}) =
        replayOf(recorded(program, setUp) { after(300.milliseconds) }).differences

    for (action in listOf("clock", "dice", "name", "order", "counted", "calls", "ways", "file", "scratch", "worker")) {
        test("the internal action planted.$action, and what was recorded of it is used") {
            val found = differences("!start. +!start <- planted.$action(X); +seen(X); .print(X).")
            found.map { it.what }.distinct() shouldBe listOf("result of planted.$action")
            found.first().cause shouldContain "planted.$action"
        }
    }

    test("an internal action that reads a setting of the program, which is another one in the replay") {
        val before = System.setProperty(planted.setting.PROPERTY, "indoors")
        val file = recorded("!start. +!start <- planted.setting(X); .print(X).") { after(300.milliseconds) }
        System.setProperty(planted.setting.PROPERTY, "outdoors")
        try {
            replayOf(file).differences.map { it.what } shouldBe listOf("result of planted.setting")
        } finally {
            if (before == null) System.clearProperty(planted.setting.PROPERTY) else System.setProperty(planted.setting.PROPERTY, before)
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

    test("an agent's class that takes its events in another order") {
        val found = differences("!a. !b. +!a <- .print(a). +!b <- .print(b).") { agentClass = planted.Fickle::class.java }
        found.first().what shouldBe "event"
        found.first().cause shouldContain "planted.Fickle"
    }

    test("an agent's class that takes another of the plans that fit") {
        val found = differences("!a.\n+!a <- .print(first).\n+!a <- .print(second).") { agentClass = planted.Choosy::class.java }
        found.first().what shouldBe "plan"
        found.first().cause shouldContain "planted.Choosy"
    }

    test("a belief base whose order changes") {
        val found = differences("side(left). side(right). !a. +!a : side(S) <- .print(S).") {
            beliefBase = ClassParameters(planted.Shuffled::class.java.name)
        }
        found.first().what shouldBe "printed lines"
        found.first().cause shouldContain "planted.Shuffled"
    }

    test("but nothing in a program without chance") {
        differences("!start. +!start <- .wait(20); +a; .random(X); .print(X).").shouldBeEmpty()
    }
})
