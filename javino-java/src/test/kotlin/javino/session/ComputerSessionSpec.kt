package javino.session

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.ints.shouldBeLessThanOrEqual
import io.kotest.matchers.nulls.shouldBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.shouldNotBe
import javino.wire.BoardAction
import javino.wire.CommandItem
import javino.wire.CriticalReport
import javino.wire.FrameKind
import javino.wire.ReflexOutcome
import javino.wire.WireFrame

private fun texts(frame: WireFrame?): List<String> = CommandItem.read(checkNotNull(frame).payload()).map {
    when (it) {
        is CommandItem.Text -> it.text()
        is CommandItem.Action -> "#${it.number()}"
        is CommandItem.Nothing -> "-"
        is CommandItem.Rule -> "rule"
    }
}

private fun board(vararg actions: BoardAction, percepts: (String) -> String = { "" }) =
    BoardModel(actions.toList(), percepts = percepts) { if (it == "walk") null else !it.startsWith("bad") }

private fun opened(board: BoardModel) = SessionProbe().apply {
    session.open(now)
    exchangeWith(board)
}

class ComputerSessionSpec : FunSpec({
    test("HELLO is said again after 60 ms and then every 250 ms, without the letter f and without escapes, until WELCOME comes") {
        val probe = SessionProbe()
        probe.next().shouldBeNull()
        probe.session.open(0)
        val hello = checkNotNull(probe.next())
        hello.kind() shouldBe FrameKind.HELLO
        hello.toBytes(0).size shouldBe 6
        hello.toBytes(0).none { it == 'f'.code.toByte() } shouldBe true
        probe.after(59).next().shouldBeNull()
        probe.after(1).next() shouldBe hello
        probe.after(249).next().shouldBeNull()
        probe.after(1).next() shouldBe hello
        probe.receive(board().received(hello))
        probe.session.isOpen shouldBe true
        probe.sessions shouldBe 1
        probe.after(1_000).next().shouldBeNull()
    }

    test("a WELCOME behind a frame of version 1, which ends the session, shows the version alone, and HELLO follows with another nonce") {
        val probe = SessionProbe()
        val board = board()
        val welcome = board.received(probe.session.hello())
        probe.session.sendsVersion1(0)
        probe.receive(welcome)
        probe.boards shouldBe 1
        probe.session.isOpen shouldBe false
        val hello = checkNotNull(probe.next())
        hello.kind() shouldBe FrameKind.HELLO
        probe.receive(welcome)
        probe.session.isOpen shouldBe false
        probe.receive(board.received(hello))
        probe.session.isOpen shouldBe true
        probe.sessions shouldBe 1
    }

    test("HELLO behind a frame of version 1 has another nonce, so that its WELCOME is no earlier one") {
        val probe = SessionProbe()
        val first = probe.session.hello()
        probe.session.hello() shouldBe first
        probe.session.sendsVersion1(0)
        val second = probe.session.hello()
        second shouldNotBe first
        probe.session.hello() shouldBe second
        probe.receive(board().received(second))
        probe.session.isOpen shouldBe true
        probe.boards shouldBe 0
    }

    test("waiting commands go out together, as many as 32 bytes and the window hold, and are done when they are acknowledged") {
        val board = board()
        val probe = opened(board)
        val orders = probe.offer(*Array(20) { "c$it" })
        val first = checkNotNull(probe.next())
        first.number() shouldBe 0
        first.payload().length shouldBeLessThanOrEqual 32
        texts(first) shouldContainExactly (0..9).map { "c$it" }
        texts(probe.next()) shouldContainExactly listOf("c10", "c11", "c12", "c13") // limited by the board's credit
        probe.next().shouldBeNull()
        probe.receive(board.received(first))
        probe.outcomes shouldContainExactly orders.take(10).map { it to CommandOutcome.DONE }
        texts(probe.next()) shouldContainExactly (14..19).map { "c$it" }
    }

    test("a command that is longer than the credit goes out alone, and one that is longer than the board takes is not sent") {
        val probe = opened(BoardModel(credit = 20) { true })
        probe.offer("x".repeat(100), "y")
        texts(probe.next()) shouldContainExactly listOf("x".repeat(100))
        probe.next().shouldBeNull()
        val long = opened(board())
        val orders = long.offer("x".repeat(254), "y")
        texts(long.next()) shouldContainExactly listOf("y")
        long.outcomes shouldContainExactly listOf(orders[0] to CommandOutcome.TOO_LONG)
    }

    test("a refusal lets what is behind it be sent again with RESUME, until a frame comes without REFUSED") {
        val board = board()
        val probe = opened(board)
        val orders = probe.offer("on", "bad", "off")
        probe.receive(board.received(checkNotNull(probe.next())))
        probe.outcomes shouldContainExactly listOf(orders[0] to CommandOutcome.DONE, orders[1] to CommandOutcome.REFUSED)
        val again = checkNotNull(probe.next())
        again.kind() shouldBe FrameKind.COMMANDS_WITH_RESUME
        texts(again) shouldContainExactly listOf("off")
        probe.after(300).next()?.kind() shouldBe FrameKind.COMMANDS_WITH_RESUME
        probe.receive(board.received(again))
        probe.outcomes.last() shouldBe (orders[2] to CommandOutcome.DONE)
        probe.offer("next")
        probe.next()?.kind() shouldBe FrameKind.COMMANDS
    }

    test("after a refusal with nothing behind it the next command goes out with RESUME") {
        val board = board()
        val probe = opened(board)
        probe.offer("bad")
        probe.exchangeWith(board)
        probe.offer("on")
        val next = checkNotNull(probe.next())
        next.kind() shouldBe FrameKind.COMMANDS_WITH_RESUME
        probe.receive(board.received(next))
        probe.outcomes.map { it.second } shouldContainExactly listOf(CommandOutcome.REFUSED, CommandOutcome.DONE)
    }

    test("an acknowledgement without news lets what is out be repeated at once, and not again soon") {
        val board = board()
        val probe = opened(board)
        probe.offer("a")
        probe.next() // lost
        probe.offer("b")
        val second = checkNotNull(probe.next())
        val acknowledgement = board.received(second)
        probe.after(10).receive(acknowledgement)
        val repetition = checkNotNull(probe.next())
        texts(repetition) shouldContainExactly listOf("a", "b")
        probe.after(1).receive(acknowledgement)
        probe.next().shouldBeNull()
        probe.receive(board.received(repetition))
        probe.outcomes.map { it.second } shouldContainExactly listOf(CommandOutcome.DONE, CommandOutcome.DONE)
    }

    test("what is out is repeated after the timeout, which is at least 60 ms and doubles up to 500 ms") {
        val board = board()
        val probe = opened(board)
        repeat(50) {
            probe.offer("a")
            val frame = checkNotNull(probe.next())
            probe.after(5).receive(board.received(frame))
            probe.exchangeWith(board)
        }
        probe.offer("a")
        val sent = probe.next()
        val waits = mutableListOf<Long>()
        repeat(6) {
            val before = probe.now
            while (probe.next().also { if (it != null) it shouldBe sent } == null) probe.after(1)
            waits += (probe.now - before) / 1_000_000
        }
        waits shouldContainExactly listOf(60L, 120L, 240L, 480L, 500L, 500L)
    }

    test("a busy board is asked again every 250 ms, and the commands behind the one that it is busy with go out again then") {
        val board = board()
        val probe = opened(board)
        val orders = probe.offer("walk", "on")
        probe.receive(board.received(checkNotNull(probe.next())))
        repeat(20) {
            probe.after(249).next().shouldBeNull()
            probe.receive(board.received(checkNotNull(probe.after(251).next())))
        }
        probe.outcomes.shouldBeEmpty()
        probe.receive(listOf(board.finish()))
        probe.outcomes shouldContainExactly listOf(orders[0] to CommandOutcome.DONE)
        probe.exchangeWith(board)
        probe.outcomes.last() shouldBe (orders[1] to CommandOutcome.DONE)
    }

    test("a command whose time is over goes out again as none, and its outcome is not known") {
        val done = mutableListOf<String>()
        val board = BoardModel { done += it; true }
        val probe = opened(board)
        val orders = probe.offer("late", "on")
        probe.next() // lost
        orders[0].isGivenUp = true
        val repetition = checkNotNull(probe.after(300).next())
        texts(repetition) shouldContainExactly listOf("-", "on")
        probe.receive(board.received(repetition))
        done shouldContainExactly listOf("on")
        probe.outcomes shouldContainExactly listOf(orders[0] to CommandOutcome.UNCONFIRMED, orders[1] to CommandOutcome.DONE)
    }

    test("a board that has restarted leaves what is out unconfirmed, and a session begins with another nonce") {
        val board = board()
        val probe = opened(board)
        val nonce = board.nonce
        val orders = probe.offer("on")
        board.restart()
        probe.exchangeWith(board)
        probe.outcomes shouldContainExactly listOf(orders[0] to CommandOutcome.UNCONFIRMED)
        board.nonce shouldNotBe nonce
        probe.sessions shouldBe 2
        probe.offer("off")
        probe.exchangeWith(board)
        probe.outcomes.last().second shouldBe CommandOutcome.DONE
    }

    test("WELCOME that comes once more acknowledges nothing") {
        val board = board()
        val probe = opened(board)
        probe.offer("a", "b")
        val row = checkNotNull(probe.next())
        val acknowledgement = board.received(row)
        val hello = WireFrame.of(FrameKind.HELLO, board.nonce, "")
        probe.receive(board.received(hello)) // its number is that of the command after these two
        probe.outcomes.shouldBeEmpty()
        probe.receive(acknowledgement)
        probe.outcomes.map { it.second } shouldContainExactly listOf(CommandOutcome.DONE, CommandOutcome.DONE)
        probe.session.isOpen shouldBe true
    }

    test("a session whose numbers cannot be right for 16 frames ends, and another begins") {
        val probe = opened(board())
        probe.offer("a")
        probe.next()
        val nonce = probe.session.nonce()
        fun impossible(count: Int) = probe.receive(List(count) { WireFrame.of(FrameKind.ACK, 200, "") })
        impossible(15)
        probe.receive(listOf(WireFrame.of(FrameKind.ACK, 0, "")))
        impossible(15)
        probe.outcomes.shouldBeEmpty()
        impossible(1)
        probe.outcomes.map { it.second } shouldContainExactly listOf(CommandOutcome.UNCONFIRMED)
        val hello = checkNotNull(probe.next())
        hello.kind() shouldBe FrameKind.HELLO
        hello.number() shouldNotBe nonce
    }

    test("a session that another computer has begun with the same nonce is not taken over") {
        val probe = SessionProbe()
        probe.session.open(0)
        val hello = checkNotNull(probe.next())
        val board = board()
        board.received(hello)
        board.received(WireFrame.of(FrameKind.COMMANDS, 0, CommandItem.Text("a").payload()))
        probe.receive(board.received(hello))
        probe.session.isOpen shouldBe false
        val other = checkNotNull(probe.next())
        other.number() shouldNotBe hello.number()
        probe.receive(board.received(other))
        probe.session.isOpen shouldBe true
    }

    test("with a board of another revision of version 2 there is no session") {
        for ((welcome, revision) in listOf("\u0000\u003C\u00FF\u0004" to 0, "\u0000\u003C\u00FF\u0004\u0002\u0000" to 2)) {
            val probe = SessionProbe()
            probe.session.open(0)
            val nonce = checkNotNull(probe.next()).number().toChar()
            probe.receive(listOf(WireFrame.of(FrameKind.WELCOME, 0, nonce + welcome.drop(1))))
            probe.session.isOpen shouldBe false
            probe.otherRevisions shouldContainExactly listOf(revision)
        }
    }

    test("a command that the board began, and that failed, is told from one that it refused") {
        val board = board()
        val probe = opened(board)
        probe.offer("walk", "bad")
        probe.receive(board.received(checkNotNull(probe.next())))
        probe.receive(listOf(board.finish(false)))
        probe.exchangeWith(board)
        probe.outcomes.map { it.second } shouldContainExactly listOf(CommandOutcome.FAILED, CommandOutcome.REFUSED)
    }

    test("a board that is silent for four repetitions and two seconds may be another one") {
        val board = board()
        val probe = opened(board)
        probe.after(60_000)
        probe.offer("on")
        val sent = probe.next()
        val begin = probe.now
        while (probe.lapses == 0) probe.after(1).next()?.let { if (probe.lapses == 0) it shouldBe sent }
        (probe.now - begin) / 1_000_000 shouldBe 2_000L
        probe.outcomes.single().second shouldBe CommandOutcome.UNCONFIRMED
        probe.session.isOpen shouldBe false
    }

    test("requests are answered, by number, and only what came after the request counts") {
        val board = board(percepts = { "asked$it;" })
        val probe = opened(board)
        probe.session.request("", probe.now)
        val first = checkNotNull(probe.next())
        first.number() shouldBe 1
        probe.session.cancelRequest()
        probe.receive(board.received(first))
        probe.session.request("(dist)", probe.now)
        probe.receive(board.received(checkNotNull(probe.next())))
        probe.answers shouldContainExactly listOf("asked(dist);")
    }

    test("the first answer to any request counts that was asked again, and one that comes later does not") {
        val board = board(percepts = { "p;" })
        val probe = opened(board)
        probe.session.request("", probe.now)
        val first = checkNotNull(probe.next())
        val second = checkNotNull(probe.after(250).next())
        second.number() shouldBe 2
        probe.receive(board.received(first))
        probe.answers.size shouldBe 1
        probe.session.request("", probe.now)
        val third = checkNotNull(probe.next())
        probe.receive(board.received(second))
        probe.answers.size shouldBe 1
        probe.receive(board.received(third))
        probe.answers.size shouldBe 2
    }

    test("a damaged answer is asked for again as soon as the line is silent") {
        val board = board(percepts = { "p;" })
        val probe = opened(board)
        probe.session.request("", probe.now)
        probe.next()
        probe.after(10).session.receiving(probe.now)
        probe.session.damaged()
        probe.after(19).next().shouldBeNull()
        probe.receive(board.received(checkNotNull(probe.after(1).next())))
        probe.answers shouldContainExactly listOf("p;")
    }

    test("requests say how many texts are known, also when their numbers begin again") {
        val board = board(percepts = { "dist(f,10);" })
        val probe = opened(board)
        repeat(600) { n ->
            probe.session.request("", probe.now)
            val ask = generateSequence(probe::next).first { it.kind() == FrameKind.ASK }
            ask.number() shouldBe n % 255 + 1
            ask.payload()[0].code shouldBe if (n == 0) 0 else 1
            probe.receive(board.received(ask))
        }
        probe.answers.size shouldBe 600
        probe.answers.toSet() shouldBe setOf("dist(f,10);")
    }

    test("an answer in parts is put together, and one that lacks a part is asked for again") {
        val board = board(percepts = { "first(1);second(2);third(3);" }).apply { partSize = 12 }
        val probe = opened(board)
        probe.session.request("", probe.now)
        val parts = board.received(checkNotNull(probe.next()))
        probe.receive(parts - parts[1])
        probe.answers.shouldBeEmpty()
        probe.after(20)
        probe.exchangeWith(board)
        probe.answers shouldContainExactly listOf("first(1);second(2);third(3);")
        probe.receive(board.say("bump;"))
        probe.heard shouldContainExactly listOf("bump;")
    }

    test("an answer of more bytes than the limit is dropped") {
        val board = board(percepts = { "x".repeat(301) + ";" })
        val probe = SessionProbe(answerLimit = 301)
        probe.session.open(0)
        probe.exchangeWith(board)
        probe.session.request("", probe.now)
        probe.receive(board.received(checkNotNull(probe.next())))
        probe.answers.shouldBeEmpty()
        probe.dropped shouldBe 1
    }

    test("the board's actions are asked for behind the first answer, and then commands without arguments go by number") {
        val names = listOf(BoardAction("on", 0), BoardAction("speed", 1), BoardAction("say", BoardAction.ANY), BoardAction("on", 0)) +
            (0..20).map { BoardAction("more$it", 0) }
        val board = board(*names.toTypedArray())
        val probe = opened(board)
        probe.session.request("", probe.now)
        texts(probe.offer("on").let { probe.next(); probe.next() }) shouldContainExactly listOf("on")
        probe.session.vocabulary().isPresent shouldBe false
        probe.session.request("", probe.now)
        probe.exchangeWith(board)
        probe.session.vocabulary().get() shouldContainExactly names
        probe.offer("speed(1)", "on", "say", "more20")
        texts(probe.next()) shouldContainExactly listOf("speed(1)", "#3", "#2", "#24")
    }

    test("a page of the vocabulary without an action, although there are more, is reported, and leaves the board undescribed") {
        val board = board(BoardAction("on", 0), BoardAction("n".repeat(251), 0))
        val probe = opened(board)
        probe.session.request("", probe.now)
        probe.exchangeWith(board)
        probe.undescribed shouldContainExactly listOf(1 to 2)
        probe.session.vocabulary().isPresent shouldBe false
    }

    test("what a rule on the board reports is passed on") {
        val report = CriticalReport(3, ReflexOutcome.CARRIED_OUT, "dist(front,9);")
        val probe = opened(board())
        probe.receive(listOf(WireFrame.of(FrameKind.CRITICAL, 0, report.payload())))
        probe.reports shouldContainExactly listOf(report)
    }

    test("commands are numbered modulo 256") {
        val done = mutableListOf<String>()
        val board = BoardModel { done += it; true }
        val probe = opened(board)
        repeat(1_000) {
            probe.offer("c$it")
            probe.exchangeWith(board)
        }
        done shouldContainExactly List(1_000) { "c$it" }
        probe.outcomes.all { it.second == CommandOutcome.DONE } shouldBe true
    }
})
