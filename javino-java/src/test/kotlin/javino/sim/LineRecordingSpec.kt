package javino.sim

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempfile
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.property.Arb
import io.kotest.property.arbitrary.bind
import io.kotest.property.arbitrary.char
import io.kotest.property.arbitrary.enum
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.map
import io.kotest.property.checkAll
import javino.sim.LineRecording.Direction
import java.io.IOException
import java.io.Reader
import java.io.StringReader
import java.io.StringWriter

class LineRecordingSpec : FunSpec({
    val messages = Arb.list(Arb.char(Char(0)..Char(0xFF)), 0..12).map { it.joinToString("") }
    val entries =
        Arb.bind(Arb.int(0..5_000), Arb.enum<Direction>(), messages) { millis, direction, message -> Triple(millis, direction, message) }

    fun read(text: String) = LineRecording.read(StringReader(text), "robot.rec")

    test("what was written is read again, whatever bytes it is of") {
        checkAll(Arb.list(entries, 0..8)) { entries ->
            val inOrder = entries.sortedBy { it.first }
            val text = StringWriter()
            RecordingWriter(text, START).use { writer ->
                inOrder.forEach { (millis, direction, message) -> writer.add(START + millis * 1_000_000L, direction, message) }
            }
            read("$text").entries() shouldBe
                inOrder.map { (millis, direction, message) -> LineRecording.Entry(millis.toLong(), direction, message) }
        }
    }

    test("a message is there as soon as it was added") {
        val text = StringWriter()
        val writer = RecordingWriter(text, 0)
        writer.add(12_999_999, Direction.IN, "dist(f,\"a\tb\\\");")
        "$text" shouldBe "javino-recording 1\n12\tin\tdist(f,\"a\\tb\\\\\");\n"
    }

    test("a file may hold comments, empty lines and line ends of any system") {
        read("javino-recording 1\r\n# by hand\r\n\r\n7\tout\tgetPercepts\r\n").entries() shouldBe
            listOf(LineRecording.Entry(7, Direction.OUT, "getPercepts"))
    }

    test("an editor's byte order mark is no part of it") {
        read("\uFEFFjavino-recording 1\r7\tout\tledOn\r").entries() shouldBe listOf(LineRecording.Entry(7, Direction.OUT, "ledOn"))
    }

    test("of a file that is no recording no more is read than shows it, though it has no end") {
        shouldThrow<IOException> { LineRecording.read(Endless(""), "zeros") }.message shouldContain "the first line of a recording is"
    }

    test("a message says no more of a line than shows which it is") {
        shouldThrow<IOException> { read("javino-recording 1\n${"x".repeat(100_000)}\tin\ta\n") }.message!!.length shouldBe 94
    }

    test("whether the board was asked is seen from what was sent") {
        read("javino-recording 1\n0\tout\tgetPercepts(dist)\n5\tin\tdist(1);\n").isOfRequests() shouldBe true
        read("javino-recording 1\n0\tout\tledOn\n5\tin\tdist(1);\n").isOfRequests() shouldBe false
    }

    listOf(
        "" to "robot.rec:1: the first line of a recording is \"javino-recording 1\"",
        "{\"ms\":1}\n" to "robot.rec:1: the first line",
        "!start.\n\n+!start <- true.\n" to "robot.rec:1: the first line",
        "javino-recording 2\n\n\n" to "robot.rec:1: a recording of format 2",
        "javino-recording 2\n" to "robot.rec:1: a recording of format 2; only format 1 can be read here",
        "javino-recording 1\nhello\n" to "robot.rec:2: a message is written MILLISECONDS, a tab",
        "javino-recording 1\n\nx\tin\ta\n" to "robot.rec:3: \"x\" is not a time in whole milliseconds",
        "javino-recording 1\n-1\tin\ta\n" to "robot.rec:2: \"-1\" is not a time",
        "javino-recording 1\n1\tto\ta\n" to "robot.rec:2: \"to\" is no direction; a message goes \"in\" or \"out\"",
        "javino-recording 1\n9\tin\ta\n8\tin\tb\n" to "robot.rec:3: a message at 8 ms stands behind one at 9 ms",
        "javino-recording 1\n9\tin\ta\\x\n" to "robot.rec:2: a backslash in a message stands before",
        "javino-recording 1\n9\tin\ta\\\n" to "robot.rec:2: a backslash in a message stands before",
        "javino-recording 1\n9\tin\ta\\u00g0\n" to "robot.rec:2: \\u in a message stands before four hexadecimal digits",
        "javino-recording 1\n9\tin\t€\n" to "robot.rec:2: a message carries one byte per character, but character 1 of \"€\" is U+20AC",
    ).forEach { (text, problem) ->
        test("refused: ${text.lines().last { it.isNotEmpty() || text.isEmpty() }.ifEmpty { "an empty file" }}") {
            shouldThrow<IOException> { read(text) }.message!!.substring(0, problem.length) shouldBe problem
        }
    }

    test("a file that is not UTF-8 is refused, not guessed at") {
        val file = tempfile()
        file.writeBytes("javino-recording 1\n9\tin\tü\n".toByteArray(Charsets.ISO_8859_1))
        shouldThrow<IOException> { LineRecording.read(file.toPath()) }.message shouldBe "$file: bytes that are not UTF-8"
    }
})

private const val START = -7_000_000_000L

/** [beginning], followed by endless zeros. */
private class Endless(private val beginning: String) : Reader() {
    private var at = 0

    override fun read(into: CharArray, from: Int, length: Int): Int {
        (0 until length).forEach { into[from + it] = beginning.getOrElse(at++) { '0' } }
        return length
    }

    override fun close() = Unit
}
