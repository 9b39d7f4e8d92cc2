package javino.sim

import io.kotest.assertions.nondeterministic.eventually
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import javino.LineSettings
import javino.Transports
import javino.wire.BoardAction
import javino.wire.BoardRule
import javino.wire.CommandItem
import javino.wire.CriticalReport
import javino.wire.FrameKind
import javino.wire.ReflexOutcome
import javino.wire.VocabularyPage
import javino.wire.Welcome
import javino.wire.WireFrame
import java.util.concurrent.atomic.AtomicInteger
import kotlin.time.Duration.Companion.seconds

private val names = AtomicInteger()
private val FAST = LineSettings(1_000_000)

private suspend fun withBoard(prepare: FakeBoard.() -> Unit = {}, work: suspend (FakeBoard, ComputerEnd) -> Unit) {
    FakeBoard.plugIn("two${names.incrementAndGet()}").version2().apply(prepare).use { board ->
        Transports.open(board.port(), FAST).use { line -> work(board, ComputerEnd(line)) }
    }
}

private fun near(reflex: String?) = BoardRule("dist", listOf(BoardRule.Condition(1, BoardRule.Operator.LESS, "40")), reflex).setting(3)

class FakeBoardVersion2Spec : FunSpec({
    test("percepts are asked for and answered as text, at any length") {
        val long = (1..200).joinToString("") { "sensor$it($it);" }
        withBoard({ whenAsked("getPercepts").answer("dist(10);", "dist(20);", long) }) { board, computer ->
            computer.hello()
            List(4) { computer.ask() } shouldContainExactly listOf("dist(10);", "dist(20);", long, long)
            board.received() shouldContainExactly List(4) { "getPercepts" }
        }
    }

    test("a request for some functors is the text that it was") {
        withBoard({ whenAsked("getPercepts(dist,light)").answer("dist(1);") }) { board, computer ->
            computer.hello().ask("(dist,light)") shouldBe "dist(1);"
            board.received() shouldContainExactly listOf("getPercepts(dist,light)")
        }
    }

    test("commands are carried out once and acknowledged, refused ones refused, and all are received as text") {
        withBoard({ whenAsked("fly").refuse(); expect("ledOn").expect("stop") }) { board, computer ->
            computer.hello().command("ledOn") shouldBe WireFrame.of(FrameKind.ACK, 1, "")
            computer.exchange(FrameKind.COMMANDS, 0, CommandItem.Text("ledOn").payload()) shouldBe WireFrame.of(FrameKind.ACK, 1, "")
            computer.command("fly") shouldBe WireFrame(FrameKind.ACK, true, false, 2, "")
            computer.command("stop") shouldBe WireFrame.of(FrameKind.ACK, 3, "")
            board.received() shouldContainExactly listOf("ledOn", "fly", "stop")
        }
    }

    test("an outcome may be reported later, and requests are answered meanwhile") {
        withBoard({ whenAsked("grip").outcomeAfter(30); whenAsked("lift").outcomeAfter(1).refuse() }) { board, computer ->
            computer.hello().command("grip") shouldBe WireFrame(FrameKind.ACK, false, true, 0, "")
            computer.ask() shouldBe ""
            computer.next() shouldBe WireFrame.of(FrameKind.ACK, 1, "")
            computer.command("lift") shouldBe WireFrame(FrameKind.ACK, false, true, 1, "")
            computer.next() shouldBe WireFrame(FrameKind.ACK, true, false, 2, "")
            board.received() shouldContainExactly listOf("grip", "getPercepts", "lift")
        }
    }

    test("a row of commands is verified as one by one, also those behind one that takes its time") {
        shouldThrow<AssertionError> {
            withBoard({ whenAsked("a").after(20) }) { _, computer ->
                computer.hello()
                val row = listOf("a", "b").joinToString("") { CommandItem.Text(it).payload() }
                computer.write(FrameKind.COMMANDS, 0, row)
            }
        }.message shouldContain "nobody expected: \"b\""
    }

    test("it knows no actions unless told") {
        withBoard { _, computer ->
            VocabularyPage.read(computer.hello().exchange(FrameKind.DESCRIBE, 1, "\u0000").payload()).total() shouldBe 0
        }
    }

    test("actions that it knows are told, and may be called by number") {
        withBoard({ knows("ledOn", "speed/1", "say/*").expect("ledOn").expect("say") }) { board, computer ->
            val page = computer.hello().exchange(FrameKind.DESCRIBE, 1, "\u0000").payload()
            VocabularyPage.read(page).actions() shouldBe
                listOf(BoardAction("ledOn", 0), BoardAction("speed", 1), BoardAction("say", BoardAction.ANY))
            val row = listOf(0, 2, 1).joinToString("") { CommandItem.Action(it).payload() }
            computer.exchange(FrameKind.COMMANDS, 0, row) shouldBe WireFrame(FrameKind.ACK, true, false, 3, "")
            board.received() shouldContainExactly listOf("ledOn", "say")
        }
        shouldThrow<IllegalArgumentException> { FakeBoard.plugIn("bad").use { it.knows("speed/x") } }.message shouldContain "NAME/ARGUMENTS"
    }

    test("a message that nobody asked for goes in the session, and so does the answer to a command") {
        withBoard({ whenAsked("getLight").answer("light(3);") }) { board, computer ->
            computer.hello()
            board.send("bump;")
            computer.percepts() shouldBe "bump;"
            computer.write(FrameKind.COMMANDS, 0, CommandItem.Text("getLight").payload())
            computer.percepts() shouldBe "light(3);"
            computer.next() shouldBe WireFrame.of(FrameKind.ACK, 1, "")
        }
    }

    test("a text that does not fit into bytes is refused") {
        withBoard { board, computer ->
            computer.hello()
            shouldThrow<IllegalArgumentException> { board.send("say(€);") }.message shouldContain "U+20AC"
        }
    }

    test("who leaves a pause and speaks version 1 ends the session") {
        withBoard({ whenAsked("getPercepts").answer("dist(9);") }) { _, computer ->
            computer.hello().askInVersion1() shouldBe "dist(9);"
            computer.command("late") shouldBe WireFrame.of(FrameKind.WELCOME, 0, Welcome(0, 255, 255, 0).payload())
            computer.hello().ask() shouldBe "dist(9);"
        }
    }

    test("it refuses rules unless it holds some") {
        withBoard { _, computer ->
            Welcome.read(computer.exchange(FrameKind.HELLO, 7, "").payload()).rules() shouldBe 0
            computer.command(near("stop")) shouldBe WireFrame(FrameKind.ACK, true, false, 1, "")
        }
    }

    test("a rule is compared with what it would answer, and its reflex is received as a command, once for each time it is met") {
        val distance = AtomicInteger(90)
        val looks = AtomicInteger()
        withBoard({ holdsRules(2).whenAsked("getPercepts").answer({ "dist(${distance.get()});" }) {
            "dist(${distance.get()});".also { looks.incrementAndGet() }
        } }) { board, computer ->
            board.whenAsked("stop")
            Welcome.read(computer.exchange(FrameKind.HELLO, 7, "").payload()).rules() shouldBe 2
            computer.command(near("stop")) shouldBe WireFrame.of(FrameKind.ACK, 1, "")
            for (met in listOf(39, 12)) {
                distance.set(met)
                CriticalReport.read(computer.next().payload()) shouldBe CriticalReport(3, ReflexOutcome.CARRIED_OUT, "dist($met);")
                distance.set(40)
                val looked = looks.get()
                eventually(20.seconds) { looks.get() shouldBeGreaterThan looked + 1 }
            }
            computer.ask() shouldBe "dist(40);"
            board.received() shouldContainExactly listOf("stop", "stop", "getPercepts")
        }
    }

    test("looking at the sensors for a rule takes none of the answers that come in turn") {
        withBoard({ holdsRules(1).whenAsked("getPercepts").answer("dist(50);", "dist(30);") }) { _, computer ->
            computer.hello().command(near(null))
            computer.ask() shouldBe "dist(50);"
            CriticalReport.read(computer.next().payload()) shouldBe CriticalReport(3, ReflexOutcome.NONE, "dist(30);")
        }
    }
})
