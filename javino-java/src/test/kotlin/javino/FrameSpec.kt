package javino

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.shouldNotBe
import io.kotest.matchers.string.shouldContain
import io.kotest.property.Arb
import io.kotest.property.arbitrary.byte
import io.kotest.property.arbitrary.byteArray
import io.kotest.property.arbitrary.int
import io.kotest.property.checkAll

class FrameSpec : FunSpec({
    test("a frame is the preamble, the length in two upper-case digits, and the payload") {
        Frame.of("hello").toString() shouldBe "fffe05hello"
        Frame.of("x".repeat(171)).toString() shouldBe "fffeAB" + "x".repeat(171)
    }

    test("an empty payload is a frame of six bytes") {
        Frame.of("").toBytes().decodeToString() shouldBe "fffe00"
        Frame.of("").length() shouldBe 6
    }

    test("any payload of up to 255 bytes comes back as it went in") {
        checkAll(Arb.byteArray(Arb.int(0..255), Arb.byte())) { payload ->
            val frame = Frame.of(payload)
            frame.payload() shouldBe payload
            Frame.of(frame.text()) shouldBe frame
            frame.toBytes().size shouldBe frame.length()
        }
    }

    test("text is one byte a character, whatever the platform's charset") {
        Frame.of("dist(é,ÿ)").payload() shouldBe "dist(é,ÿ)".toByteArray(Charsets.ISO_8859_1)
    }

    test("a payload of 256 bytes is refused with its length and the limit") {
        val refusal = shouldThrow<IllegalArgumentException> { Frame.of("x".repeat(256)) }
        refusal.message shouldContain "256"
        refusal.message shouldContain "255"
        shouldThrow<IllegalArgumentException> { Frame.of(ByteArray(256)) }
    }

    test("a character that does not fit into a byte is refused by its position and code") {
        val refusal = shouldThrow<IllegalArgumentException> { Frame.of("say(€)") }
        refusal.message shouldContain "character 5"
        refusal.message shouldContain "U+20AC"
    }

    test("a command whose text holds the header of a frame is refused with the header, its place and what to do") {
        for (header in listOf("fffe05", "fffe0A", "fffeFF", "fffeab")) {
            val refusal = shouldThrow<IllegalArgumentException> { Frame.ofCommand("say(\"${header}front\")") }
            refusal.message shouldContain header
            refusal.message shouldContain "character 6"
            refusal.message shouldContain "leave it out"
        }
        shouldThrow<IllegalArgumentException> { Frame.ofCommand("ffffe05") }
        shouldThrow<IllegalArgumentException> { Frame.ofCommand("x".repeat(256)) }
        shouldThrow<IllegalArgumentException> { Frame.ofCommand("say(€)") }
    }

    test("a command holds no control character") {
        for (text in listOf("\u0001", "\nsay", "say(\"a\tb\")", "stop\u0000", "\u007Fstop", "\u001F")) {
            shouldThrow<IllegalArgumentException> { Frame.ofCommand(text) }
        }
        shouldThrow<IllegalArgumentException> { Frame.ofCommand("say(\u0001)") }.message shouldBe
            "the command \"say(?)\" holds the control character U+0001 as character 5, and commands have none; leave it out"
        Frame.ofCommand("say(\"\u0080\u00FF ~\")").text() shouldBe "say(\"\u0080\u00FF ~\")"
    }

    test("any other text is a command") {
        for (text in listOf("", "ledOn", "say(\"fffe\")", "say(fffe0)", "say(fffe0g)", "say(FFFE05)", "say(ffe05)", "say(fffd05)")) {
            Frame.ofCommand(text) shouldBe Frame.of(text)
        }
    }

    test("frames are equal by payload, and keep their own copy of it") {
        val bytes = byteArrayOf(1, 2)
        val frame = Frame.of(bytes)
        bytes[0] = 9
        frame.payload()[1] = 9
        frame shouldBe Frame.of(byteArrayOf(1, 2))
        frame.hashCode() shouldBe Frame.of(byteArrayOf(1, 2)).hashCode()
        frame shouldNotBe Frame.of(byteArrayOf(2, 1))
    }
})
