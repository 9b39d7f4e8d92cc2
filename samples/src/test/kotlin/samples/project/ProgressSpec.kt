package samples.project

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import java.io.ByteArrayOutputStream
import java.io.PrintStream
import java.nio.charset.Charset

class ProgressSpec : FunSpec({
    fun shown(inPlace: Boolean, charset: Charset = Charsets.UTF_8, use: (Progress) -> Unit): String {
        val bytes = ByteArrayOutputStream()
        use(Progress(PrintStream(bytes, true, charset), inPlace, charset))
        return bytes.toString(charset)
    }

    test("on a terminal a line replaces the one before, however long that was, and goes in the end") {
        shown(inPlace = true) {
            it.show(listOf("distance 100.0 cm", "driving"), 0)
            it.show(listOf("distance 9.0 cm", "driving"), 50)
            it.end()
            it.show(listOf("distance 8.0 cm", "driving"), 100)
        } shouldBe "\rdistance 100.0 cm · driving\rdistance 9.0 cm · driving  \r" + " ".repeat(25) + "\r"
    }

    test("elsewhere there is a line every five seconds") {
        val second = 1_000_000_000L
        shown(inPlace = false) { progress ->
            (0L..11L).forEach { progress.show(listOf("$it"), it * second) }
            progress.end()
        }.lines() shouldBe listOf("0", "5", "10", "")
    }

    test("a terminal that has no middle dot gets a dash") {
        shown(inPlace = true, Charsets.US_ASCII) { it.show(listOf("a", "b"), 0) } shouldBe "\ra - b"
    }

    test("a terminal shows a drawing before the facts, unless the line would be too long; elsewhere there is none") {
        shown(inPlace = true) { it.show(listOf("near"), 0, "o=o>|") } shouldBe "\ro=o>|  near"
        val long = "x".repeat(Progress.MAX_COLUMNS - 2)
        shown(inPlace = true) { it.show(listOf(long), 0, "|") } shouldBe "\r$long"
        shown(inPlace = false) { it.show(listOf("near"), 0, "o=o>|") } shouldBe "near\n"
    }

    test("a line is rewritten neither on a dumb terminal nor in the log of CI") {
        Progress.canRewrite(mapOf("TERM" to "xterm")) shouldBe true
        Progress.canRewrite(emptyMap()) shouldBe true // as on Windows
        Progress.canRewrite(mapOf("TERM" to "dumb")) shouldBe false
        Progress.canRewrite(mapOf("TERM" to "xterm", "CI" to "true")) shouldBe false
    }
})
