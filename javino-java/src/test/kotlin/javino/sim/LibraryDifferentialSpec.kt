package javino.sim

import io.kotest.assertions.withClue
import io.kotest.core.NamedTag
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import javino.BoardReceiver
import javino.Frame
import javino.PerceptsRequest
import javino.Protocol
import javino.sim.BoardProgram.Outcome
import javino.wire.BoardAction
import javino.wire.CommandItem
import javino.wire.FrameKind
import javino.wire.NONCE
import javino.wire.PerceptDecoder
import javino.wire.Welcome
import javino.wire.WireDecoder
import javino.wire.WireFrame
import javino.wire.bytesOf
import javino.wire.textOf
import javino.wire.vectorOf
import java.util.HexFormat
import java.util.Random
import kotlin.time.Duration.Companion.minutes

private const val CONVERSATIONS = 3_000
private const val MS = 1_000_000L
private val HEX = HexFormat.of()

/** The program of `src/test/c/board.c` in Kotlin. */
private class DriverProgram(private val carried: (String) -> Unit) : BoardProgram {
    var percepts = emptyList<String>()

    override fun vocabulary() = listOf("front" to 0, "speed" to 1, "no" to 0, "later" to 0, "say" to BoardAction.ANY)
        .map { (name, arguments) -> BoardAction(name, arguments) }

    override fun carryOut(command: String): Outcome {
        if (command.startsWith("no") || command.startsWith("\u0001") || command == "speed") return Outcome.REFUSED
        carried(command)
        return if (command.startsWith("later")) Outcome.LATER else Outcome.DONE
    }

    /** Finds functors between a bracket or comma and the next one, because the request may be damaged. */
    override fun percepts(request: String): String {
        val isForAll = request.none { it in "(," }
        fun isWanted(functor: String) = Regex("[(,]${Regex.escape(functor)}[,)]").containsMatchIn(request)
        return percepts.filter { isForAll || isWanted(it.substringBefore('(')) }.joinToString("") { "$it;" }
    }
}

/** Names a board's frames for comparison. Names answers by their text, and ignores capacities. */
private class Observer {
    private val reader = PerceptDecoder()
    private var parts = ""
    private var nonce = 0

    fun name(frame: WireFrame): String? {
        val head = "${frame.number()} ${if (frame.isRefused) "REFUSED" else ""} ${if (frame.isBusy) "BUSY" else ""}"
        return when (frame.kind()) {
            FrameKind.WELCOME -> "WELCOME $head ${began(Welcome.read(frame.payload()).nonce())}"
            FrameKind.PERCEPTS -> answer(head, frame.payload()[0], frame.payload().drop(1))
            FrameKind.PERCEPTS_PART -> null.also { parts += frame.payload().drop(2) }
            FrameKind.PERCEPTS_LAST -> answer(head, frame.payload()[0], parts + frame.payload().drop(2)).also { parts = "" }
            else -> vectorOf(frame)
        }
    }

    private fun began(session: Int): Int {
        if (session != nonce) reader.forget()
        nonce = session
        return session
    }

    /** Names an answer or a part. Boards may cut answers at different places. */
    private fun answer(head: String, request: Char, items: String) =
        "PERCEPTS $head ${request.code} ${reader.read(items, LIMIT).orElse("unreadable")}"
}

/** The board of this package, driven by the operations of `src/test/c/board.c`. */
private class SessionBoard(rules: Int = 0) {
    private val named = mutableListOf<String>()
    private val observer = Observer()
    private val program = DriverProgram { named += "! $it" }
    val session = BoardSession(program, BoardSession.Capacity(63, 255, rules, 64)) { frame, _ ->
        due = frame.number()
        observer.name(frame)?.let { named += it }
    }
    private val receiver = BoardReceiver(Protocol.AUTO, 100 * MS, 255, session::nonce, ::handle)
    private var now = 0L
    private var lastByte = 0L
    private var open = 0L
    var due = 0
        private set

    fun play(operation: String): List<String> {
        named.clear()
        val argument = operation.drop(2)
        when (operation[0]) {
            'w' -> receiver.idle(argument.toLong() * MS + now).also { now += argument.toLong() * MS }
            'b' -> HEX.parseHex(argument).forEach {
                receiver.accept(it, now, now - lastByte)
                lastByte = now
            }
            'p' -> program.percepts = argument.split(' ').filter { it.isNotEmpty() }.map { textOf(HEX.parseHex(it)) }
            'u' -> session.sendPercepts(program.percepts(PerceptsRequest.ALL))
            'r' -> session.report(open, argument == "1")
            'l' -> session.look(program.percepts(PerceptsRequest.ALL))
        }
        return named.toList()
    }

    private fun handle(found: BoardReceiver.Found) {
        val text = found.version1()?.text()
        if (text == null) session.receive(found.version2()) else handle(text)
        if (session.openAction() != 0L) open = session.openAction()
    }

    private fun handle(message: String) {
        session.end()
        if (PerceptsRequest.isIn(message)) named += "${Frame.of(program.percepts(message))}" else program.carryOut(message)
    }
}

/** Names the library's output for an operation like [SessionBoard.play]. */
private class LibraryOutput {
    private val observer = Observer()
    private var nonce = 0 // nonce of the session in the last WELCOME

    fun named(lines: List<String>): List<String> = lines.flatMap { line ->
        val bytes = HEX.parseHex(line.drop(2))
        if (line[0] == '!') listOf("! ${textOf(bytes)}") else frames(bytes)
    }

    private fun frames(bytes: ByteArray): List<String> {
        val named = mutableListOf<String>()
        val decoder = WireDecoder(true, 1, { nonce }) { frame ->
            if (frame.kind() == FrameKind.WELCOME) nonce = Welcome.read(frame.payload()).nonce()
            observer.name(frame)?.let { named += it }
        }
        var at = 0
        while (at < bytes.size) {
            if (decoder.accept(bytes[at], 0)) {
                at++
            } else {
                val length = Frame.HEADER_LENGTH + textOf(bytes.copyOfRange(at + 4, at + 6)).toInt(16)
                named += textOf(bytes.copyOfRange(at, at + length))
                at += length
            }
        }
        check(decoder.damaged() == 0L && !decoder.isInFrame) { "the library sent ${HEX.formatHex(bytes)}" }
        return named
    }
}

private class Generator(private val random: Random, private val due: () -> Int, private val nonce: () -> Int) {
    private fun <T> one(vararg choices: T): T = choices[random.nextInt(choices.size)]

    fun operations(): List<String> = when (random.nextInt(20)) {
        0 -> listOf("w " + one(10, 60, 150))
        1 -> listOf("p " + List(random.nextInt(8)) { HEX.formatHex(bytesOf(percept())) }.joinToString(" "))
        2 -> if (nonce() != 0) listOf("p " + HEX.formatHex(bytesOf(percept())), "u") else emptyList()
        3 -> listOf("r " + random.nextInt(2))
        4 -> listOf("b " + HEX.formatHex(noise()))
        5 -> listOf("w " + one(10, 60, 60, 60), "b " + HEX.formatHex(version1()))
        else -> chunks(if (random.nextInt(4) == 0) damaged(version2()) else version2())
    }

    private fun percept() = one("dist(f,", "light(", "a(\"x\",-", "b\u00A5(").let { it + random.nextInt(300) + ")" } + one("", "", "[s(1)]")

    private fun version2(): ByteArray {
        val frame = when (random.nextInt(12)) {
            0 -> WireFrame.of(FrameKind.HELLO, one(nonce(), 1 + random.nextInt(0xFF), 1 + random.nextInt(0xFF)), one("", "", "x"))
            1 -> WireFrame.of(FrameKind.ASK, random.nextInt(256), "")
            2, 3 -> WireFrame.of(FrameKind.ASK, random.nextInt(256), random.nextInt(9).toChar() + one("", "", "(dist,b\u00A5)"))
            4 -> WireFrame.of(FrameKind.DESCRIBE, random.nextInt(256), one("", "\u0000", "\u0003", "\u0009"))
            else -> WireFrame.of(
                one(FrameKind.COMMANDS, FrameKind.COMMANDS_WITH_RESUME),
                due() + one(0, 0, 0, 0, -1, -3, 1, 128, 129) and 0xFF,
                List(random.nextInt(6)) { item() }.joinToString("").take(255),
            )
        }
        return frame.toBytes(if (random.nextInt(12) == 0) random.nextInt(256) else nonce())
    }

    private fun item(): String = when (random.nextInt(12)) {
        0 -> "\u00FE"
        1 -> one("\u00FF", "\u00FF\u0000", "\u00FF\u0002\u0007", "\u0000\u0000", "\u0007x", "\u0000")
        2 -> "\u0000" + one("\u0002hi", "\u0082" + "x".repeat(0x82))
        3 -> one("\u0003fly", "\u0002\u0001\u0007", "\u00FF\u0001\u0007", "\u00FF\u0003\u0007a\u0000")
        4 -> one("later", "no(1)", "later(2)", "\u00A4\u00A5fffe02hi").let { "" + it.length.toChar() + it }
        else -> "" + (0x80 + random.nextInt(7)).toChar()
    }

    private fun version1(): ByteArray {
        val texts = List(1 + random.nextInt(2)) { one("getPercepts", "stop", "getPercepts(dist)", "a\u00A5b", "fffe02hi", "no") }
        val bytes = texts.map { Frame.of(it).toBytes() }.reduce(ByteArray::plus)
        return if (random.nextInt(3) == 0) damaged(bytes) else bytes
    }

    private fun noise() = ByteArray(1 + random.nextInt(20)) {
        one(0xA5, 0xA4, 0x04, 0x05, 0x66, 0x65, 0x30, 0x31, random.nextInt(256)).toByte()
    }

    private fun damaged(bytes: ByteArray): ByteArray {
        val at = random.nextInt(bytes.size)
        return when (random.nextInt(5)) {
            0 -> bytes.copyOf(at)
            1 -> bytes.copyOf(at) + bytes.copyOfRange(at + 1, bytes.size)
            2 -> bytes.copyOf(at) + noise() + bytes.copyOfRange(at, bytes.size)
            3 -> bytes.copyOf(at) + bytes
            else -> bytes.clone().also { it[at] = (it[at].toInt() xor (1 shl random.nextInt(8))).toByte() }
        }.ifEmpty { byteArrayOf(0) }
    }

    private fun ByteArray.ifEmpty(other: () -> ByteArray) = if (isEmpty()) other() else this

    private fun chunks(bytes: ByteArray): List<String> {
        if (random.nextInt(3) > 0) return listOf("b " + HEX.formatHex(bytes))
        val cut = random.nextInt(bytes.size)
        return listOf("b " + HEX.formatHex(bytes, 0, cut), "w " + one(10, 60, 150), "b " + HEX.formatHex(bytes, cut, bytes.size))
    }
}

/** Random operations with a board that holds rules: set or remove rules, change the sensors, compare them. */
private class RuleGenerator(private val random: Random) {
    private var number = 0

    private fun <T> one(vararg choices: T): T = choices[random.nextInt(choices.size)]

    private fun value() = one("40", "-1.5", "+007", "0.0", "-0", "00.50", "f", "\"x,y\"", "[1,2]", "p(1,2)", "1e3", "4.", ".5", "39.999")

    fun operations(): List<String> {
        val percepts = List(random.nextInt(4)) { one("d", "~d", "e") + arguments() }
        val set = WireFrame.of(FrameKind.COMMANDS_WITH_RESUME, number++ % 256, CommandItem.Rule(rule()).payload()).toBytes(NONCE)
        return listOf("b " + HEX.formatHex(set), "p " + percepts.joinToString(" ") { HEX.formatHex(bytesOf(it)) }, "l")
    }

    private fun arguments() = one("", List(1 + random.nextInt(2)) { argument() }.joinToString(",", "(", ")"))

    private fun argument() = one("", "", " ") + value() + one("", "", " ")

    private fun rule(): String {
        val conditions = List(random.nextInt(3)) { "${one(1, 1, 2, 3, 9, 0)}${one("<", ">", "{", "}", "=", "!", "?")}${value()}\u0000" }
        val number = one("\u0001", "\u0002", "\u0003", "\u0001", "\u0002", "\u0003", "\u0000")
        val rule = number + one("d", "d", "~d", "e") + '\u0000' + conditions.joinToString("") +
            one("", "\u0002stop", "\u0002no", "\u0002")
        return when (random.nextInt(8)) {
            0 -> rule.take(1 + random.nextInt(rule.length))
            1 -> rule.take(1)
            else -> rule
        }
    }
}

/** Compares the board in Java with the board's library in C in equal conversations. */
class LibraryDifferentialSpec : FunSpec({
    test("both send the same frames and carry out the same commands, whatever arrives")
        .config(tags = thorough, enabledOrReasonIf = { LibraryBoards.available }, timeout = 10.minutes) {
            val played = mutableListOf<Pair<String, List<String>>>()
            repeat(CONVERSATIONS) { number ->
                val board = SessionBoard()
                val generator = Generator(Random(number.toLong()), { board.due }, { board.session.nonce() })
                val hello = "b " + HEX.formatHex(WireFrame.of(FrameKind.HELLO, NONCE, "").toBytes(NONCE))
                played += "n" to emptyList()
                val beginning = if (number % 4 == 0) emptyList() else listOf(hello)
                for (operation in beginning) played += operation to board.play(operation)
                repeat(40) { for (operation in generator.operations()) played += operation to board.play(operation) }
            }
            var output = LibraryOutput()
            var since = 0
            LibraryBoards.play(played.map { it.first }).forEachIndexed { i, lines ->
                val (operation, expected) = played[i]
                if (operation == "n") {
                    output = LibraryOutput()
                    since = i
                }
                fun history() = played.subList(since, i + 1).joinToString("\n") { (operation, named) -> "$operation -> $named" }
                withClue({ "the library, at the end of\n${history()}" }) {
                    output.named(lines) shouldBe expected
                }
            }
            played.count { (_, named) -> named.any { it.startsWith("!") } } shouldBeGreaterThan CONVERSATIONS
            played.count { (_, named) -> named.any { it.startsWith("PERCEPTS") } } shouldBeGreaterThan CONVERSATIONS
        }

    for ((cases, tags) in listOf(CONVERSATIONS / 4 to emptySet(), 10 * CONVERSATIONS to thorough)) {
        test("both refuse the same rules, and find the same ones met, in $cases cases")
            .config(tags = tags, enabledOrReasonIf = { LibraryBoards.available }, timeout = 10.minutes) {
                val board = SessionBoard(rules = 8)
                val generator = RuleGenerator(Random(5))
                val operations = listOf("b " + HEX.formatHex(WireFrame.of(FrameKind.HELLO, NONCE, "").toBytes(NONCE))) +
                    List(cases) { generator.operations() }.flatten()
                val expected = operations.map { board.play(it).sorted() } // rules that begin to match together have no order
                val output = LibraryOutput()
                val found = LibraryBoards.play(listOf("N") + operations).drop(1).map { output.named(it).sorted() }
                for ((i, operation) in operations.withIndex()) {
                    withClue({ "the library at $operation, behind\n" + operations.subList(maxOf(0, i - 9), i).joinToString("\n") }) {
                        found[i] shouldBe expected[i]
                    }
                }
                expected.count { named -> named.any { it.startsWith("85") } } shouldBeGreaterThan cases / 10
            }
    }
})

private const val LIMIT = 65_536

private val thorough = setOf(NamedTag("Thorough"))
