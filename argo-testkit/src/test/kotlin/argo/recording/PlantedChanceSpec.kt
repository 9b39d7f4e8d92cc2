package argo.recording

import argo.testkit.AgentSetUp
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import kotlin.time.Duration.Companion.milliseconds

/** A replay finds and names program parts with random results. */
class PlantedChanceSpec : FunSpec({
    fun differences(program: String, setUp: AgentSetUp.() -> Unit = {}) =
        replayOf(recorded(program, setUp) { after(300.milliseconds) }, isChecking = true).differences

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
            replayOf(file, isChecking = true).differences.map { it.what } shouldBe listOf("result of planted.setting")
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

    test("without --check an internal action is not carried out again, and gives what was recorded") {
        val file = recorded("!start. +!start <- planted.calls(X); .print(X).") { after(300.milliseconds) }
        val before = planted.calls.CALLS.get()
        replayOf(file).differences.shouldBeEmpty()
        planted.calls.CALLS.get() shouldBe before
    }

    test("lines that an internal action prints are not missed without --check, and compared with it; those of plans always are") {
        val file = recorded("!start. +!start : planted.prints & .print(a) <- .print(done).") { after(300.milliseconds) }
        replayOf(file).differences.shouldBeEmpty()
        replayOf(file, isChecking = true).differences.first().what shouldBe "printed lines"
    }

    test("but nothing in a program without chance") {
        differences("!start. +!start <- .wait(20); +a; .random(X); .print(X).").shouldBeEmpty()
    }
})
