package javino.link

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.doubles.shouldBeGreaterThan
import io.kotest.matchers.doubles.shouldBeLessThan
import io.kotest.matchers.ints.shouldBeGreaterThanOrEqual
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldEndWith
import javino.ActionRefusedException
import javino.ActionUnconfirmedException
import javino.PerceptKind
import javino.PortTimeoutException
import javino.Protocol
import javino.async
import javino.logged
import javino.sim.VirtualBoard2
import javino.sim.count
import javino.virtual.LineEnd
import javino.wire.BoardAction
import javino.wire.BoardRule
import javino.wire.FrameKind
import javino.wire.ReflexOutcome
import javino.wire.WireFrame
import java.util.concurrent.CompletableFuture
import java.util.concurrent.ExecutionException

private const val REQUEST = "getPercepts"

private fun bench(board: LineEnd) = VirtualBench(LinkSettings.defaults().withBootMillis(0), board, Protocol.V2)

/** WELCOME of a board whose longest payload is [bytes]. */
private fun withLongest(bytes: Int, welcome: WireFrame) =
    WireFrame.of(FrameKind.WELCOME, welcome.number(), welcome.payload().replaceRange(2, 3, "${bytes.toChar()}"))

private class Events : BoardListener {
    val all = mutableListOf<String>()

    override fun critical(rule: Int, outcome: ReflexOutcome, percept: String, receivedNanos: Long) {
        all += "$rule $outcome $percept"
    }

    override fun sessionBegan(rules: Int) {
        all += "began $rules"
    }
}

/** An answer to the request of [answer], with other [items]. */
private fun answering(answer: WireFrame, items: String) = WireFrame.of(answer.kind(), 0, answer.payload().take(1) + items)

class LinkDeliverySpec : FunSpec({
    test("an action returns when the board has acted") {
        val board = VirtualBoard2().apply { takes = 30.0 }
        bench(board).use { bench ->
            bench.link.sendAndAwait("ledOn", 500)
            board.handled shouldContainExactly listOf("2:ledOn")
            bench.millis shouldBeGreaterThan 60.0 // WELCOME and acknowledgement
            bench.millis shouldBeLessThan 100.0
        }
    }

    test("commands that wait go out together") {
        val board = VirtualBoard2()
        bench(board).use { bench ->
            val sent = (1..8).map { bench.link.send("lamp($it)", SendOptions.defaults()) }
            bench.link.sendAndAwait("stop", 500)
            sent.all { it.isDone } shouldBe true
            board.handled shouldContainExactly (1..8).map { "2:lamp($it)" } + "2:stop"
            board.count(FrameKind.COMMANDS) shouldBe 3
        }
    }

    test("an action of which frames are lost or doubled is carried out once") {
        for (lost in 0..3) {
            var count = 0
            val board = VirtualBoard2()
            board.posting = { if (it.kind() != FrameKind.WELCOME && count++ < lost) emptyList() else listOf(it, it) }
            bench(board).use { bench ->
                bench.link.sendAndAwait("ledOn", 500)
                bench.link.sendAndAwait("ledOn", 500)
                board.handled shouldContainExactly listOf("2:ledOn", "2:ledOn")
            }
        }
    }

    test("an action that nothing acknowledges is repeated at least four times in two seconds, and then its outcome is not known") {
        val board = VirtualBoard2().apply { posting = { if (it.kind() == FrameKind.WELCOME) listOf(it) else emptyList() } }
        bench(board).use { bench ->
            shouldThrow<ActionUnconfirmedException> { bench.link.sendAndAwait("ledOn", 500) }.message shouldContain "ledOn"
            board.count(FrameKind.COMMANDS) shouldBeGreaterThanOrEqual 5
            bench.millis shouldBeGreaterThan 2_000.0
            bench.millis shouldBeLessThan 2_600.0
            board.handled shouldContainExactly listOf("2:ledOn")
        }
    }

    test("a refusal is told at once, and the next action is not taken for it") {
        val board = VirtualBoard2()
        bench(board).use { bench ->
            shouldThrow<ActionRefusedException> { bench.link.sendAndAwait("bad(1)", 500) }.message shouldContain "bad(1)"
            bench.millis shouldBeLessThan 60.0
            bench.link.sendAndAwait("ledOn", 500)
            board.handled shouldContainExactly listOf("2:ledOn")
        }
    }

    test("the same action can be sent any number of times, with requests in between") {
        val board = VirtualBoard2()
        bench(board).use { bench ->
            repeat(40) { i ->
                bench.link.sendAndAwait("step", 500)
                repeat(i % 18) { bench.link.request(REQUEST, 500).text() }
            }
            board.handled.count { it == "2:step" } shouldBe 40
        }
    }

    test("a board that stays on while its port is opened again does not take the next action for a repetition") {
        val board = VirtualBoard2()
        for (name in listOf("again", "serial:again", "again")) {
            VirtualBench(LinkSettings.defaults().withBootMillis(0), board, Protocol.V2, name).use { it.link.sendAndAwait("ledOn", 500) }
        }
        board.handled shouldContainExactly List(3) { "2:ledOn" }
    }

    test("an action that reports its outcome later is waited for, however long it takes") {
        val board = VirtualBoard2().apply { walkTakes = 20_000.0 }
        bench(board).use { bench ->
            bench.link.sendAndAwait("walk", 500)
            bench.millis shouldBeGreaterThan 20_000.0
            board.handled shouldContainExactly listOf("2:walk")
        }
    }

    test("a board that was restarted has carried out what was on its way or not, and takes the next command") {
        val board = VirtualBoard2()
        bench(board).use { bench ->
            val events = Events()
            bench.link.sendAndAwait("a", 500)
            bench.link.onBoardEvents(events)
            board.restart()
            shouldThrow<ActionUnconfirmedException> { bench.link.sendAndAwait("b", 500) }
            bench.link.sendAndAwait("c", 500)
            board.handled shouldContainExactly listOf("2:a", "2:c")
            events.all shouldContainExactly listOf("began 4", "began 4")
        }
    }

    test("an answer of several frames comes whole") {
        bench(VirtualBoard2().apply { answer = { "x".repeat(it * 200) + ";" } }).use { bench ->
            repeat(4) { bench.link.request(REQUEST, 5_000).text().length shouldBe (it + 1) * 200 + 1 }
        }
    }

    test("a damaged answer is asked for again, within the time") {
        var count = 0
        val board = VirtualBoard2(damage = { bytes ->
            bytes.also { if (it.size > 6 && it[2] == 0x82.toByte() && ++count == 3) it[5] = '?'.code.toByte() }
        })
        bench(board).use { bench ->
            repeat(5) { bench.link.request(REQUEST, 500).text() }
            bench.link.corruptFrames() shouldBe 1
        }
    }

    test("percepts that come unasked are heard, the newest of several") {
        val board = VirtualBoard2()
        bench(board).use { bench ->
            bench.link.request(REQUEST, 500)
            board.say("bump;")
            bench.link.listen(1_000).text() shouldBe "bump;"
            board.say("old;")
            board.say("new;")
            bench.link.watch(100)
            bench.link.listen(1_000).text() shouldBe "new;"
            shouldThrow<PortTimeoutException> { bench.link.listen(100) }
        }
    }

    test("a message other than a request for percepts is a command, and what the board says behind it is the answer") {
        val board = VirtualBoard2()
        board.onHandled = { if (it == "2:getStatus") board.say("status(ok);") }
        bench(board).use { bench ->
            bench.link.request("getStatus", 500).text() shouldBe "status(ok);"
            shouldThrow<ActionRefusedException> { bench.link.request("bad", 500) }
        }
    }

    test("a board that has described itself is sent no action that it does not have, nor one with other arguments") {
        val actions = listOf(BoardAction("on", 0), BoardAction("speed", 1), BoardAction("say", BoardAction.ANY))
        val board = VirtualBoard2(actions = actions)
        bench(board).use { bench ->
            bench.link.vocabulary().isPresent shouldBe false
            repeat(2) { bench.link.request(REQUEST, 500) }
            bench.link.watch(100)
            bench.link.vocabulary().get() shouldContainExactly actions
            board.received.clear()
            for (known in listOf("on", "speed(f(1,2))", "say", "say(1,\"a,b\")")) bench.link.sendAndAwait(known, 500)
            board.handled.filter { REQUEST !in it } shouldContainExactly listOf("2:on", "2:speed(f(1,2))", "2:say", "2:say(1,\"a,b\")")
            listOf("speed('a,b')", "speed({1,2})", "speed(1)[fast,safe]", "on[fast(1,2)]").forEach { bench.link.sendAndAwait(it, 500) }
            val frames = board.received.size
            shouldThrow<ActionRefusedException> { bench.link.sendAndAwait("fly", 500) }.message shouldContain
                "it has no action fly; it has on, speed with 1 argument, say with any number of arguments"
            shouldThrow<ActionRefusedException> { bench.link.sendAndAwait("speed(1,2)", 500) }.message shouldContain
                "speed takes 1 argument, not 2"
            board.received.size shouldBe frames
        }
    }

    test("a board of version 2 describes its percepts when it is asked to, and the next answer holds percepts") {
        val kinds = PerceptKind.parseLines("dist(front|left, cm 0..400)\nready")
        val board = VirtualBoard2(kinds = kinds)
        VirtualBench(LinkSettings.defaults().withBootMillis(0), board, Protocol.AUTO).use { bench ->
            bench.link.perceptDescription(500).kinds().shouldBeEmpty() // the version is not known yet
            board.received.shouldBeEmpty()
            bench.link.request(REQUEST, 500).text() shouldBe "1;"
            bench.link.perceptDescription(500).kinds() shouldContainExactly kinds
            bench.link.request(REQUEST, 500).text() shouldBe "2;"
            board.handled shouldContainExactly listOf("2:$REQUEST", "2:$REQUEST")
        }
    }

    test("a board that describes no percepts, or answers with percepts, stays undescribed, and one that is silent is told from it") {
        val board = VirtualBoard2()
        bench(board).use { bench ->
            bench.link.request(REQUEST, 500)
            bench.link.perceptDescription(500).kinds().shouldBeEmpty()
            board.posting = { listOf(if (it.kind() == FrameKind.PERCEPTS) answering(it, "\u007F\u0003on;") else it) }
            bench.link.perceptDescription(500).kinds().shouldBeEmpty()
            board.silent = true
            shouldThrow<PortTimeoutException> { bench.link.perceptDescription(500) }.message shouldContain
                "did not describe its percepts within 500 ms"
            board.silent = false
            bench.link.request(REQUEST, 500)
        }
    }

    test("kinds of percepts that cannot be read are left out with a line of log, and the others count") {
        val board = VirtualBoard2()
        val items = "\u007F\u0008?dist();\u007F\u0005?a\u001B2;\u007F\u0007?ready;"
        board.posting = { listOf(if (it.kind() == FrameKind.PERCEPTS) answering(it, items) else it) }
        bench(board).use { bench ->
            bench.link.request(REQUEST, 500)
            val warnings = logged("javino.link.Link") {
                val description = bench.link.perceptDescription(500)
                description.kinds().map { "$it" } shouldBe listOf("ready")
                description.problems().size shouldBe 2
            }
            warnings.single() shouldContain "kinds of percepts that the board describes are left out, 2 in all: argument 1 of dist()"
        }
    }

    test("a refusal of a board that has described itself names its actions, the first ten of many") {
        val board = VirtualBoard2(actions = (1..12).map { BoardAction("wave$it", 0) } + BoardAction("bad", 1))
        bench(board).use { bench ->
            shouldThrow<ActionRefusedException> { bench.link.sendAndAwait("bad(1)", 500) }.message shouldContain
                "refuses \"bad(1)\": it does not know the action, or takes other arguments"
            repeat(2) { bench.link.request(REQUEST, 500) }
            bench.link.watch(100)
            shouldThrow<ActionRefusedException> { bench.link.sendAndAwait("bad(1)", 500) }.message shouldEndWith
                "it has the action, but its program refuses it now; it has wave1, wave2, wave3, wave4, wave5, wave6, " +
                "wave7, wave8, wave9, wave10 and 3 more"
            shouldThrow<ActionRefusedException> { bench.link.sendAndAwait("bad(1", 500) }.message shouldEndWith
                "refuses \"bad(1\": a bracket or quote in it is not closed"
            shouldThrow<ActionRefusedException> { bench.link.sendAndAwait("", 500) }.message shouldContain
                "refuses \"\": the command names no action; it has wave1"
            shouldThrow<ActionRefusedException> { bench.link.sendAndAwait("fly", 500) }.message shouldEndWith
                "it has no action fly; it has wave1, wave2, wave3, wave4, wave5, wave6, wave7, wave8, wave9, wave10 and 3 more"
        }
    }

    test("a rule is set by a command, and what it reports is passed on while the line is watched") {
        val board = VirtualBoard2()
        val events = Events()
        val rule = BoardRule("dist", listOf(BoardRule.Condition(2, BoardRule.Operator.LESS, "10")), "stop")
        bench(board).use { bench ->
            bench.link.onBoardEvents(events)
            bench.link.sendRule(rule.setting(3), SendOptions(true, 0))
            bench.link.sendAndAwait("on", 500)
            board.sees("dist(f,11);dist(b,9);")
            bench.link.watch(100)
            events.all shouldContainExactly listOf("began 4", "3 CARRIED_OUT dist(b,9);")
            board.handled shouldContainExactly listOf("2:on", "2:stop")
            shouldThrow<IllegalArgumentException> { bench.link.send("\u0003dist\u0000", SendOptions.defaults()) }
        }
        VirtualBench(LinkSettings.defaults().withBootMillis(0), VirtualBoard(), Protocol.V1).use { bench ->
            val refused = bench.link.sendRule(rule.setting(3), SendOptions.defaults())
            bench.link.sendAndAwait("on", 500)
            shouldThrow<ExecutionException> { refused.get() }.cause!!.message shouldContain "version 1"
        }
    }

    test("what is longer than the board takes is refused, a command or a rule, with its length and the longest") {
        val rule = BoardRule("dist", listOf(BoardRule.Condition(2, BoardRule.Operator.LESS, "10")), "say(" + "x".repeat(30) + ")")
        val board = VirtualBoard2().apply { posting = { listOf(if (it.kind() == FrameKind.WELCOME) withLongest(32, it) else it) } }
        bench(board).use { bench ->
            shouldThrow<ActionRefusedException> { bench.link.sendAndAwait("say(" + "x".repeat(27) + ")", 500) }.message shouldContain
                "takes no command of 32 bytes, 31 at most, as much as its memory holds"
            val refused = bench.link.sendRule(rule.setting(3), SendOptions.defaults())
            bench.link.sendAndAwait("say(" + "x".repeat(26) + ")", 500)
            shouldThrow<ExecutionException> { refused.get() }.cause!!.message shouldContain
                "takes no rule of ${rule.setting(3).text().length} bytes, 30 at most"
        }
        bench(VirtualBoard2()).use { bench ->
            shouldThrow<ActionRefusedException> { bench.link.sendAndAwait("x".repeat(254), 500) }.message shouldContain
                "takes no command of 254 bytes, 253 at most: \"xxx"
        }
    }

    test("no future is completed under a lock") {
        val board = VirtualBoard2()
        bench(board).use { bench ->
            val done = CompletableFuture<Boolean>()
            bench.link.send("a", SendOptions.defaults())
                .thenRun { done.complete(async { bench.link.vocabulary() }.handle { _, _ -> true }.join()) }
            bench.link.sendAndAwait("b", 500)
            done.join() shouldBe true
        }
    }

    test("commands without an end do not keep requests from being answered") {
        val board = VirtualBoard2()
        bench(board).use { bench ->
            repeat(50) {
                (0..9).forEach { n -> bench.link.send("lamp($n)", SendOptions.defaults()) }
                val before = bench.millis
                bench.link.request({ REQUEST }, 500, 50)
                bench.millis - before shouldBeLessThan 300.0
            }
            board.handled.filter { "lamp" in it }.shouldContainExactly(List(50) { (0..9).map { n -> "2:lamp($n)" } }.flatten())
            board.received.filter { it.kind() == FrameKind.HELLO }.drop(1).shouldBeEmpty()
        }
    }
})
