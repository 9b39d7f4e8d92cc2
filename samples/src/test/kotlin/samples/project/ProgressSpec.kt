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
})
