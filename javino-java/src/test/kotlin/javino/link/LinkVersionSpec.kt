package javino.link

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.assertions.withClue
import io.kotest.core.NamedTag
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.collections.shouldNotContain
import io.kotest.matchers.doubles.shouldBeGreaterThan
import io.kotest.matchers.doubles.shouldBeLessThan
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.ints.shouldBeInRange
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import javino.ActionRefusedException
import javino.ActionUnconfirmedException
import javino.Frame
import javino.FrameDecoder
import javino.PortTimeoutException
import javino.Protocol
import javino.Transport
import javino.async
import javino.logged
import javino.sim.FakeBoard
import javino.sim.VirtualBoard2
import javino.sim.count
import javino.virtual.LineEnd
import javino.wire.BoardAction
import javino.wire.FrameKind
import javino.wire.Welcome
import javino.wire.WireDecoder
import javino.wire.WireFrame
import java.util.concurrent.TimeUnit

private const val REQUEST = "getPercepts"

private fun bench(board: LineEnd, settings: LinkSettings = LinkSettings.defaults()) = VirtualBench(settings, board, Protocol.AUTO)

/**
 * A version 1 board that forgets a frame after a stray f. The board also forgets a frame that is incomplete 300 ms after its first byte.
 */
private class FieldBoard(private val startsAt: Double = 0.0) : LineEnd {
    val received = mutableListOf<String>()
    private var bytes = ""
    private var began = 0.0

    override fun look(end: Transport, now: Double) {
        val buffer = ByteArray(64)
        val length = end.read(buffer, 0, buffer.size, 0)
        if (now < startsAt) return
        if (bytes.isNotEmpty() && now - began > 300) bytes = ""
        for (byte in buffer.take(length)) {
            if (bytes.isEmpty()) began = now
            bytes += byte.toInt().toChar()
            read(end)
        }
    }

    private fun read(end: Transport) {
        val header = "fffe".take(bytes.length)
        if (!bytes.startsWith(header)) {
            bytes = ""
        } else if (bytes.length >= 6 && bytes.length == 6 + bytes.substring(4, 6).toInt(16)) {
            received += bytes.substring(6)
            bytes = ""
            if (received.last() == REQUEST) Frame.of("${received.size};").toBytes().let { end.write(it, 0, it.size, 0) }
        }
    }
}

/** A board with a receive buffer and a slow loop. The board announces when it is ready. */
private class BusyBoard(val model: FieldBoardModel) : LineEnd {
    private var ready = false
    private var unsent = ArrayDeque<Byte>()

    override fun look(end: Transport, now: Double) {
        if (!ready) Frame.of("ready;").toBytes().let { end.write(it, 0, it.size, 0) }
        ready = true
        val buffer = ByteArray(64)
        val nanos = (now * 1e6).toLong()
        repeat(end.read(buffer, 0, buffer.size, 0)) { model.receive(buffer[it], nanos) }
        repeat(model.advance(nanos)) {
            if (unsent.isEmpty()) unsent += Frame.of("dist(f,1);").toBytes().toList()
            end.write(byteArrayOf(unsent.removeFirst()), 0, 1, 0)
        }
    }
}

/** A WELCOME without a revision, as in an older draft. */
private fun olderDraft(welcome: WireFrame) = WireFrame.of(FrameKind.WELCOME, welcome.number(), welcome.payload().take(4))

private fun newerRevision(welcome: WireFrame) =
    WireFrame.of(FrameKind.WELCOME, welcome.number(), welcome.payload().replaceRange(4, 5, "${(Welcome.REVISION + 1).toChar()}"))

private fun cut(frame: WireFrame) = WireFrame.of(frame.kind(), frame.number(), frame.payload().take(1))

private fun actionsLost(welcome: WireFrame) = WireFrame.of(FrameKind.WELCOME, welcome.number(), welcome.payload().dropLast(1) + '3')

class LinkVersionSpec : FunSpec({
    test("a version 2 board that runs is asked in version 2 from the beginning") {
        val board = VirtualBoard2()
        bench(board).use { bench ->
            bench.link.protocol() shouldBe Protocol.AUTO
            bench.link.request(REQUEST, 500).text() shouldBe "1;"
            bench.millis shouldBeLessThan 60.0
            bench.link.protocol() shouldBe Protocol.V2
            bench.link.request(REQUEST, 500).text() shouldBe "2;"
            board.handled shouldContainExactly listOf("2:$REQUEST", "2:$REQUEST")
        }
    }

    test("a version 1 board that runs answers within half a second") {
        val board = FieldBoard()
        bench(board).use { bench ->
            bench.link.request(REQUEST, 500).text() shouldBe "1;"
            bench.millis shouldBeLessThan 500.0
            bench.link.protocol() shouldBe Protocol.V1
            val before = bench.millis
            bench.link.request(REQUEST, 500).text() shouldBe "2;"
            bench.millis - before shouldBeLessThan 50.0
            bench.link.sendAndAwait("ledOn", 500)
            bench.awayFor(5)
            board.received shouldContainExactly listOf(REQUEST, REQUEST, "ledOn")
        }
    }

    for (starts in listOf(30.0, 90.0, 200.0, 400.0, 700.0, 1_000.0, 1_500.0, 1_800.0, 2_000.0, 2_400.0)) {
        test("a version 1 board that starts for $starts ms loses no more than one request's time to the other version") {
            val board = FieldBoard(starts)
            bench(board).use { bench ->
                bench.link.request(REQUEST, 500).text()
                bench.link.protocol() shouldBe Protocol.V1
                bench.millis - starts shouldBeLessThan 1_000.0
                val before = bench.millis
                bench.link.sendAndAwait("ledOn", 500)
                bench.link.request(REQUEST, 500).text()
                bench.millis - before shouldBeLessThan 100.0
                board.received.filter { it != REQUEST } shouldContainExactly listOf("ledOn")
            }
        }

        for (both in listOf(true, false)) test("a version 2 board that starts for $starts ms is found to be one, reads version 1: $both") {
            val board = VirtualBoard2(starts, both)
            bench(board).use { bench ->
                bench.link.request(REQUEST, 500).text()
                bench.link.protocol() shouldBe Protocol.V2
                bench.link.sendAndAwait("ledOn", 500)
                board.handled shouldContain "2:ledOn"
            }
        }
    }

    test("a version 2 board that says something while it starts is found to be one") {
        val board = VirtualBoard2(300.0)
        var said = false
        val talker = object : LineEnd {
            override fun look(end: Transport, now: Double) {
                if (!said && now > 250) "rst:0x1 (POWERON)".toByteArray().let { end.write(it, 0, it.size, 0) }
                said = now > 250
                board.look(end, now)
            }
        }
        bench(talker).use { bench ->
            bench.link.request(REQUEST, 500).text()
            bench.link.protocol() shouldBe Protocol.V2
        }
    }

    test("an agent that only acts finds a version 2 board too, and probes with no action") {
        val board = VirtualBoard2(1_800.0)
        bench(board).use { bench ->
            bench.link.sendAndAwait("ledOn", 500)
            bench.link.protocol() shouldBe Protocol.V2
            board.handled.filter { REQUEST !in it } shouldContainExactly listOf("2:ledOn")
        }
    }

    test("an agent that only acts reaches a version 1 board, once for each action") {
        val board = FieldBoard(1_800.0)
        bench(board).use { bench ->
            bench.link.sendAndAwait("ledOn", 500)
            bench.link.sendAndAwait("ledOff", 500)
            bench.awayFor(20)
            board.received.filter { it != REQUEST } shouldContainExactly listOf("ledOn", "ledOff")
        }
    }

    test("a board that never answers is sent its action when it must have started, in version 1") {
        val board = VirtualBoard().apply { silent = true }
        bench(board).use { bench ->
            bench.link.sendAndAwait("ledOn", 500)
            bench.millis shouldBeLessThan 4_000.0
            bench.awayFor(5)
            board.texts.last() shouldBe "ledOn"
            val before = bench.millis
            shouldThrow<PortTimeoutException> { bench.link.request(REQUEST, 500).text() }
            bench.millis - before shouldBeLessThan 900.0
        }
    }

    test("a slow version 2 board is found to be one") {
        for (takes in listOf(50.0, 150.0, 350.0, 450.0)) {
            val board = VirtualBoard2().apply { this.takes = takes }
            bench(board).use { bench ->
                bench.link.request(REQUEST, 1_000).text()
                bench.link.protocol() shouldBe Protocol.V2
                val handled = board.handled.size
                bench.link.request(REQUEST, 1_000).text().trimEnd(';').toInt() shouldBeInRange handled..board.handled.size
            }
        }
    }

    for (damaged in 1..6) test("a version 2 board whose first WELCOMEs, $damaged of them, are damaged on the line is found to be one") {
        var welcomes = 0
        val board = VirtualBoard2 { bytes ->
            val isWelcome = bytes.size > 2 && bytes[2] == 0x80.toByte()
            if (isWelcome && welcomes++ < damaged) bytes.clone().apply { this[lastIndex] = (this[lastIndex] + 1).toByte() } else bytes
        }
        bench(board).use { bench ->
            bench.link.request(REQUEST, 500)
            bench.link.protocol() shouldBe Protocol.V2
        }
    }

    test("a request of version 1 that a slow version 2 board answers late costs no command") {
        for (takes in 10..600 step 10) {
            val board = VirtualBoard2().apply { this.takes = takes.toDouble() }
            bench(board).use { bench ->
                bench.link.request(REQUEST, 1_000)
                withClue("$takes ms") { for (text in listOf("a", "b", "c")) bench.link.sendAndAwait(text, 5_000) }
                board.handled.filter { REQUEST !in it } shouldContainExactly listOf("2:a", "2:b", "2:c")
            }
        }
    }

    test("a request of version 1 whose turn comes when WELCOME has just come costs no command").config(tags = thorough) {
        for (starts in 300..1_500 step 40) for (takes in 480..600 step 5) {
            val board = VirtualBoard2(starts.toDouble()).apply { this.takes = takes / 10.0 }
            bench(board).use { bench ->
                withClue("starts at $starts ms, takes ${takes / 10.0} ms") { bench.link.sendAndAwait("a", 5_000) }
                board.handled.filter { REQUEST !in it }.map { it.drop(2) } shouldContainExactly listOf("a")
            }
        }
    }

    test("a program that speaks version 1 is understood by a board in the session of an earlier one") {
        val board = VirtualBoard2()
        bench(board).use { it.link.sendAndAwait("earlier", 500) }
        val settings = LinkSettings.defaults().withBootMillis(0).withBaud(115_200).withSpacingMillis(0)
        VirtualBench(settings, board, Protocol.V1).use { bench ->
            bench.awayFor(100)
            for (i in 1..50) bench.link.sendAndAwait("c$i", 500)
            bench.awayFor(5)
            bench.link.request(REQUEST, 500).text() shouldBe "1;"
        }
        board.handled shouldContainExactly listOf("2:earlier") + (1..50).map { "1:c$it" } + "1:$REQUEST"
    }

    test("a board that speaks unasked in version 1 is asked for its version once before an action, and for nothing else") {
        val old = VirtualBoard().apply { say(1.0, "bump;") }
        bench(old).use { bench ->
            bench.link.listen(1_000).text() shouldBe "bump;"
            bench.link.sendAndAwait("ledOn", 500)
            bench.link.protocol() shouldBe Protocol.V1
            bench.awayFor(5)
            old.texts shouldContainExactly listOf("ledOn")
        }
    }

    for (at in listOf(5.0, 40.0, 90.0, 200.0)) test("what a version 1 board says unasked $at ms after a probe reaches who listens") {
        val board = VirtualBoard().apply { say(1.0, "ready;") }
        bench(board).use { bench ->
            bench.link.listen(1_000).text() shouldBe "ready;"
            board.say(bench.millis + at, "bump;")
            bench.link.sendAndAwait("ledOn", 500)
            bench.link.listen(500).text() shouldBe "bump;"
            board.texts shouldContainExactly listOf("ledOn")
        }
    }

    test("what came before an action probes the board reaches who listens, unless something newer does") {
        val board = VirtualBoard().apply { say(1.0, "ready;") }
        bench(board).use { bench ->
            bench.link.listen(1_000).text()
            board.say(bench.millis, "bump;")
            bench.awayFor(20)
            bench.link.sendAndAwait("ledOn", 500)
            bench.link.listen(500).text() shouldBe "bump;"
            board.say(bench.millis, "old;")
            board.say(bench.millis + 20, "new;")
            bench.awayFor(60)
            bench.link.sendAndAwait("ledOff", 500)
            bench.link.listen(500).text() shouldBe "new;"
        }
    }

    test("a version 1 board whose loop takes long loses no action to the probes") {
        for (loop in listOf(100, 250, 400)) for (baud in listOf(9_600, 115_200)) {
            val settings = LinkSettings.defaults().withBaud(baud).withSpacingMillis(loop)
            val board = BusyBoard(FieldBoardModel(settings.line().byteNanos(), loop * 1_000_000L, Frame.of("dist(f,1);")))
            bench(board, settings).use { bench ->
                bench.link.listen(20_000).text() shouldBe "ready;"
                bench.link.sendAndAwait("x".repeat(40), 5_000)
                repeat(3) { bench.link.request(REQUEST, 5_000).text() shouldBe "dist(f,1);" }
                bench.link.sendAndAwait("ledOn", 5_000)
                bench.awayFor(2 * loop)
                board.model.overflowed shouldBe 0
                board.model.restarts shouldBe 0
                board.model.lost.shouldBeEmpty()
                board.model.handled.filter { it != REQUEST } shouldContainExactly listOf("x".repeat(40), "ledOn")
            }
        }
    }

    test("a version 2 board that starts late and speaks unasked in version 1 is found to be one") {
        val board = VirtualBoard2(5_000.0)
        bench(board).use { bench ->
            shouldThrow<PortTimeoutException> { bench.link.request(REQUEST, 500).text() }
            bench.awayFor(3_000)
            board.say("bump;", version = 1)
            bench.link.listen(500).text() shouldBe "bump;"
            bench.link.sendAndAwait("ledOn", 500)
            board.handled.last() shouldBe "2:ledOn"
        }
    }

    test("a frame of version 1 follows a HELLO only when WELCOME would have come") {
        val board = FieldBoard()
        val times = mutableListOf<Pair<Boolean, Double>>()
        val watcher = object : LineEnd {
            private var now = 0.0
            private val version1 = FrameDecoder(Long.MAX_VALUE / 2) { times += false to now }
            private val version2 = WireDecoder(false, Long.MAX_VALUE / 2, { 0 }) { times += true to now }
            override fun look(end: Transport, now: Double) {
                this.now = now
                board.look(object : Transport by end {
                    override fun read(b: ByteArray, off: Int, len: Int, timeoutMillis: Int) = end.read(b, off, len, timeoutMillis).also {
                        version1.accept(b, off, it, 0)
                        version2.accept(b, off, it, 0)
                    }
                }, now)
            }
        }
        bench(watcher, LinkSettings.defaults().withBaud(115_200)).use { bench ->
            bench.link.request(REQUEST, 500).text()
            bench.link.sendAndAwait("ledOn", 500)
            bench.awayFor(5)
        }
        times.map { it.first } shouldContainExactly listOf(true, true, false, true, false)
        for ((before, after) in times.zipWithNext()) if (before.first) after.second - before.second shouldBeGreaterThan 60.0
    }

    test("a board that starts is found to be of version 2 by requests with a time limit that is shorter than the gap between frames") {
        bench(VirtualBoard2(startsAt = 500.0)).use { bench ->
            bench.link.request(REQUEST, 5).text() shouldBe "1;"
            bench.link.protocol() shouldBe Protocol.V2
        }
    }

    test("a board that runs, and is only sent commands, is found to be of version 2 before the first one") {
        val board = VirtualBoard2()
        bench(board, LinkSettings.defaults().withBootMillis(0)).use { bench ->
            bench.link.sendAndAwait("ledOn", 500)
            bench.link.protocol() shouldBe Protocol.V2
            board.handled shouldContainExactly listOf("2:ledOn")
        }
    }

    test("a board of version 1 that runs, and is only sent commands, is sent HELLO twice before the first one, and no request") {
        val board = FieldBoard()
        bench(board, LinkSettings.defaults().withBootMillis(0)).use { bench ->
            bench.link.sendAndAwait("ledOn", 500)
            bench.millis shouldBeLessThan 250.0
            bench.link.sendAndAwait("ledOff", 500)
            bench.awayFor(5)
            board.received shouldContainExactly listOf("ledOn", "ledOff")
        }
    }

    test("a WELCOME that comes late makes it version 2 after all") {
        val board = VirtualBoard2().apply { takes = 700.0 }
        bench(board, LinkSettings.defaults().withBootMillis(0)).use { bench ->
            runCatching { bench.link.request(REQUEST, 500) }
            bench.link.protocol() shouldBe Protocol.AUTO
            board.takes = 0.0
            bench.link.watch(1_000)
            bench.link.protocol() shouldBe Protocol.V2
        }
    }

    test("a board that was exchanged for one of version 1 is found to be one") {
        val second = VirtualBoard2()
        val first = FieldBoard()
        var isExchanged = false
        bench(LineEnd { end, now -> if (isExchanged) first.look(end, now) else second.look(end, now) }).use { bench ->
            bench.link.request(REQUEST, 500)
            bench.link.sendAndAwait("on", 500)
            isExchanged = true
            shouldThrow<ActionUnconfirmedException> { bench.link.sendAndAwait("off", 500) }
            bench.link.protocol() shouldBe Protocol.AUTO
            bench.link.sendAndAwait("on", 500)
            bench.link.protocol() shouldBe Protocol.V1
            bench.awayFor(5)
            first.received shouldContainExactly listOf(REQUEST, "on")
        }
    }

    test("a board of version 2 that was silent for seconds is spoken to in version 2 again, and in nothing else") {
        val board = VirtualBoard2()
        bench(board).use { bench ->
            bench.link.request(REQUEST, 500)
            board.silent = true
            shouldThrow<ActionUnconfirmedException> { bench.link.sendAndAwait("off", 500) }
            shouldThrow<PortTimeoutException> { bench.link.sendAndAwait("on", 500) }
            board.silent = false
            bench.link.sendAndAwait("on", 500)
            bench.link.protocol() shouldBe Protocol.V2
            board.handled.filter { REQUEST !in it } shouldContainExactly listOf("2:on")
        }
    }

    test("a board of an older draft of version 2 is spoken to in version 1, and the log says what to do") {
        val board = VirtualBoard2().apply { posting = { listOf(if (it.kind() == FrameKind.WELCOME) olderDraft(it) else it) } }
        val warnings = logged("javino.link.LineReports") {
            bench(board, LinkSettings.defaults().withBootMillis(0)).use { bench ->
                bench.link.request(REQUEST, 500).text() shouldBe "1;"
                bench.link.protocol() shouldBe Protocol.V1
                bench.link.sendAndAwait("ledOn", 500)
                bench.awayFor(50)
                board.handled.last() shouldBe "1:ledOn"
            }
        }
        warnings.single() shouldContain "upload its sketch again"
        warnings.single() shouldContain "version 1 is used"
    }

    test("a board that comes back with another revision in the middle of a session is spoken to in version 1") {
        val board = VirtualBoard2()
        bench(board, LinkSettings.defaults().withBootMillis(0)).use { bench ->
            bench.link.request(REQUEST, 500)
            bench.link.protocol() shouldBe Protocol.V2
            board.posting = { listOf(if (it.kind() == FrameKind.WELCOME) olderDraft(it) else it) }
            board.restart()
            runCatching { bench.link.request(REQUEST, 500) }
            bench.link.request(REQUEST, 500)
            bench.link.protocol() shouldBe Protocol.V1
            bench.link.sendAndAwait("ledOn", 500)
            bench.awayFor(50)
            board.handled.last() shouldBe "1:ledOn"
        }
    }

    test("if version 2 is forced, a board of another revision of it gives no answer, and the error says why") {
        for ((welcome, words) in listOf(::olderDraft to "upload its sketch again", ::newerRevision to "use a newer version of ARGO")) {
            val board = VirtualBoard2().apply { posting = { listOf(if (it.kind() == FrameKind.WELCOME) welcome(it) else it) } }
            VirtualBench(LinkSettings.defaults().withBootMillis(0), board, Protocol.V2).use { bench ->
                shouldThrow<PortTimeoutException> { bench.link.request(REQUEST, 500) }.message shouldContain words
            }
            board.handled.shouldBeEmpty()
        }
    }

    test("actions that found no room on a board are told once, however many sessions there are") {
        val board = VirtualBoard2().apply { posting = { listOf(if (it.kind() == FrameKind.WELCOME) actionsLost(it) else it) } }
        val warnings = logged("javino.link.LineReports") {
            bench(board).use { bench ->
                bench.link.actionsLost() shouldBe 0
                repeat(3) {
                    bench.link.request(REQUEST, 500)
                    board.restart()
                }
                bench.link.actionsLost() shouldBe '3'.code
            }
        }
        warnings.single() shouldContain "51 actions of the board's program found no room"
    }

    test("a warning is logged outside of the lock of the line, which other threads can take meanwhile") {
        val board = VirtualBoard2().apply { posting = { listOf(if (it.kind() == FrameKind.WELCOME) actionsLost(it) else it) } }
        bench(board).use { bench ->
            val onAnotherThread = { check(async { bench.link.strayBytes().count() }.get(20, TimeUnit.SECONDS) >= 0) }
            logged("javino.link.LineReports", onAnotherThread) { bench.link.request(REQUEST, 500) }.size shouldBe 1
        }
    }

    test("frames that arrive whole and cannot be read are told once") {
        val board = VirtualBoard2().apply { posting = { listOf(if (it.kind() == FrameKind.VOCABULARY) cut(it) else it) } }
        val warnings = logged("javino.link.LineReports") {
            bench(board).use { bench ->
                repeat(40) {
                    bench.link.request(REQUEST, 500)
                    bench.link.watch(100)
                }
                bench.link.vocabulary().isEmpty shouldBe true
            }
        }
        warnings.single() shouldContain "a frame VOCABULARY that cannot be read here"
        board.count(FrameKind.DESCRIBE) shouldBeGreaterThan 1
    }

    test("a page of the vocabulary that is empty although actions follow is told once") {
        val empty = { page: WireFrame -> WireFrame.of(page.kind(), page.number(), page.payload().take(3)) }
        val board = VirtualBoard2(actions = listOf(BoardAction("stop", 0))).apply {
            posting = { listOf(if (it.kind() == FrameKind.VOCABULARY) empty(it) else it) }
        }
        val warnings = logged("javino.link.LineReports") {
            bench(board).use { bench ->
                repeat(40) {
                    bench.link.request(REQUEST, 500)
                    bench.link.watch(100)
                }
                bench.link.vocabulary().isEmpty shouldBe true
            }
        }
        warnings.single() shouldContain "the board describes 0 of its 1 actions and no more"
        board.count(FrameKind.DESCRIBE) shouldBeGreaterThan 1
    }

    test("of a simulated board's actions the first 126 are known, and it is told that there are others") {
        FakeBoard.plugIn("many").version2().lenient().knows(*Array(130) { "a$it" }).use { board ->
            val warnings = logged("javino.link.LineReports") {
                Link.open(board.port(), Bench.FAST.withProtocol(Protocol.V2), "the test").use { link ->
                    link.request(REQUEST, 20_000)
                    link.sendAndAwait("a125", 20_000)
                    while (link.vocabulary().isEmpty) link.request(REQUEST, 20_000)
                    link.vocabulary().get().size shouldBe 126
                    link.actionsLost() shouldBe 4
                    shouldThrow<ActionRefusedException> { link.sendAndAwait("a126", 20_000) }
                }
            }
            warnings.single() shouldContain "4 actions of the board's program found no room, and it refuses them; a board has 126 at most"
        }
    }

    test("a simulated board leaves out an action whose name fits on no page, and has the others") {
        FakeBoard.plugIn("long").version2().lenient().knows("n".repeat(251), "stop").use { board ->
            val warnings = logged("javino.link.LineReports") {
                Link.open(board.port(), Bench.FAST.withProtocol(Protocol.V2), "the test").use { link ->
                    link.request(REQUEST, 20_000)
                    while (link.vocabulary().isEmpty) link.request(REQUEST, 20_000)
                    link.vocabulary().get().map { it.name() } shouldBe listOf("stop")
                    link.actionsLost() shouldBe 1
                }
            }
            warnings.single() shouldContain "1 actions of the board's program found no room"
        }
    }

    test("two boards that are exchanged on their lines carry out no command of the other's") {
        val boards = List(2) { VirtualBoard2() }
        var areExchanged = false
        fun line(number: Int) = LineEnd { end, now -> boards[if (areExchanged) 1 - number else number].look(end, now) }
        val benches = List(2) { VirtualBench(LinkSettings.defaults().withBootMillis(0), line(it), Protocol.AUTO) }
        benches.forEach { it.link.request(REQUEST, 500) }
        boards[0].restart() // otherwise both sessions would have one nonce
        benches[0].link.request(REQUEST, 500)
        benches.forEachIndexed { i, bench -> bench.link.sendAndAwait("first($i)", 500) }
        areExchanged = true
        shouldThrow<ActionUnconfirmedException> { benches[0].link.sendAndAwait("off(0)", 500) }
        boards.flatMap { it.handled }.none { "off" in it } shouldBe true
        benches[0].link.sendAndAwait("second(0)", 500)
        boards[1].handled.last() shouldBe "2:second(0)"
        benches.forEach { it.close() }
    }

    test("a version that is forced is spoken alone") {
        val second = VirtualBoard2()
        VirtualBench(LinkSettings.defaults(), second, Protocol.V2).use { it.link.request(REQUEST, 500).text() }
        second.handled shouldNotContain "1:$REQUEST"
        val first = VirtualBoard2()
        VirtualBench(LinkSettings.defaults(), first, Protocol.V1).use { it.link.request(REQUEST, 500).text() }
        first.received.shouldBeEmpty()
        first.handled shouldContainExactly listOf("1:$REQUEST")
    }
})

private val thorough = setOf(NamedTag("Thorough"))
