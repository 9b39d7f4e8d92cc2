package javino.sim

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.ints.shouldBeLessThan
import io.kotest.matchers.shouldBe
import javino.PerceptTerm
import javino.sim.BoardProgram.Outcome
import javino.wire.BoardRule
import javino.wire.CommandItem
import javino.wire.FrameKind
import javino.wire.WireFrame

/** A board whose program takes every command. Commands that begin with `later` finish later. */
private class Bench(capacity: BoardSession.Capacity = BoardSession.Capacity.FULL.withRules(2)) : BoardProgram {
    val carried = mutableListOf<String>()
    val sent = mutableListOf<WireFrame>()
    var percepts: String? = ""
    val session = BoardSession(this, capacity) { frame, _ -> sent += frame }

    override fun carryOut(command: String): Outcome {
        carried += command
        return if (command.startsWith("later")) Outcome.LATER else Outcome.DONE
    }

    override fun percepts(request: String): String? = percepts

    fun hello(nonce: Int = 7) = session.receive(WireFrame.of(FrameKind.HELLO, nonce, ""))

    fun command(number: Int, text: String) = command(number, CommandItem.Text(text))

    fun command(number: Int, item: CommandItem) = session.receive(WireFrame.of(FrameKind.COMMANDS, number, item.payload()))

    fun ask(known: Int = 0) = session.receive(WireFrame.of(FrameKind.ASK, 1, "" + known.toChar()))
}

class BoardSessionSpec : FunSpec({
    test("an outcome of an earlier session is not that of an action of this one") {
        val bench = Bench().apply { hello() }
        bench.command(0, "later(1)")
        val first = bench.session.openAction()
        bench.hello(8)
        bench.command(0, "later(2)")
        bench.sent.clear()
        bench.session.report(first, true)
        bench.sent shouldBe emptyList()
        bench.session.report(bench.session.openAction(), true)
        bench.sent shouldContainExactly listOf(WireFrame.of(FrameKind.ACK, 1, ""))
    }

    test("a program that has no answer lets the board be silent") {
        val bench = Bench().apply { hello(); percepts = null; sent.clear() }
        bench.ask()
        bench.sent shouldBe emptyList()
    }

    test("a request without its first byte is read as if that were 0") {
        val bench = Bench().apply { hello(); sent.clear() }
        for (kind in listOf(FrameKind.ASK, FrameKind.DESCRIBE)) for (payload in listOf("", "\u0000")) {
            bench.session.receive(WireFrame.of(kind, 1, payload))
        }
        bench.sent.map { it.payload() } shouldContainExactly List(2) { "\u0001" } + List(2) { "\u0001\u0000\u0000" }
    }

    test("a board that holds no rules refuses to remove some, too") {
        val bench = Bench(BoardSession.Capacity.FULL).apply { hello(); sent.clear() }
        bench.command(0, BoardRule.removal(0))
        bench.sent shouldContainExactly listOf(WireFrame(FrameKind.ACK, true, false, 1, ""))
    }

    test("a percept of more than 253 bytes meets no rule") {
        fun percept(size: Int) = "say(\"" + "x".repeat(size - 8) + "\");"
        for (size in listOf(253, 254)) {
            val bench = Bench().apply { hello(); command(0, BoardRule("say", listOf(), "stop").setting(1)); sent.clear() }
            bench.session.look(percept(size))
            bench.carried shouldBe if (size == 253) listOf("stop") else emptyList()
            bench.sent.map { it.payload() } shouldBe if (size == 253) listOf("\u0001\u0001" + percept(size)) else emptyList()
        }
    }

    test("with rules, an answer that would have too many parts has longer ones") {
        val bench = Bench().apply { hello(); command(0, BoardRule("a", listOf(), null).setting(1)) }
        for (length in listOf(12 * 255, 12 * 255 + 1, 20_000)) {
            bench.sent.clear()
            bench.percepts = "x".repeat(length)
            bench.ask()
            bench.sent.size shouldBeLessThan 256
        }
        bench.percepts = "x".repeat(253 * 255)
        shouldThrow<IllegalArgumentException> { bench.ask() }
    }

    test("an answer is split behind percepts, not within quotes or brackets") {
        PerceptTerm.split("""a;b("x;y");c([1;2]);'d;e';(((;rest""") shouldBe
            listOf("a;", """b("x;y");""", "c([1;2]);", "'d;e';", "(((;rest")
        PerceptTerm.split(");a;") shouldBe listOf(");", "a;")
    }

    test("a literal has as many arguments as a board counts, and is closed if its brackets and quotes are") {
        val counts = mapOf(
            "f" to 0, "f()" to 0, "f( )" to 0, "f(1)" to 1, "f(,)" to 2, "f(g(1,2),'a,b',[3,4])" to 3,
            "f[a(1),b]" to 0, "f(1)[a,b]" to 1,
        )
        counts.keys.associateWith { PerceptTerm.of(it).arguments().size } shouldBe counts
        counts.keys.forEach { PerceptTerm.isClosed(it) shouldBe true }
        listOf("f(1", "f(\"1)", "f(')", "f(1))", "f]", ")(", """f("\")""").forEach { PerceptTerm.isClosed(it) shouldBe false }
    }
})
