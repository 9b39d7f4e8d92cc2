package javino.wire

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive

class Vectors2Spec : FunSpec({
    test("there are vectors of all groups") {
        for (group in listOf("frames", "receive", "commands", "percepts", "void", "parts", "vocabulary")) {
            Vectors2.cases(group).size shouldBeGreaterThan 5
        }
    }

    for ((name, case) in Vectors2.cases("frames")) test("frame: $name") {
        val octets = case["payloadHex"].text()
        val frame = frameOf(case["kind"].text() + "%02x".format(case["number"].number()) + octets)
        textOf(frame.toBytes(case["nonce"].number())) shouldBe case["frameHex"].octets()
        Receiver(frame.kind().isFromBoard, case["nonce"].number()).receive(bytesOf(case["frameHex"].octets())).frames shouldBe listOf(frame)
    }

    for ((name, case) in Vectors2.cases("receive")) test("receive: $name") {
        val receiver = Receiver(case["direction"].text() == "from-board", case["session"].number())
        for (chunk in case["chunks"].items().map { it.jsonObject }) {
            receiver.silence(chunk["gapMs"].number().toLong()).receive(bytesOf(chunk["hex"].octets()))
        }
        receiver.frames.map(::vectorOf) shouldBe case["frames"].texts()
    }

    for ((name, case) in Vectors2.cases("commands")) test("commands: $name") {
        val row = case["commands"].items().map {
            if (it.isNull()) CommandItem.Nothing()
            else if (it is JsonObject) CommandItem.Rule(it["rule"].text())
            else if (it.jsonPrimitive.isString) CommandItem.Text(it.text())
            else CommandItem.Action(it.number())
        }
        CommandItem.read(case["payloadHex"].octets()) shouldBe row
        if (case["write"].isTrue()) row.joinToString("") { it.payload() } shouldBe case["payloadHex"].octets()
    }

    for ((name, case) in Vectors2.cases("percepts")) test("percepts: $name") {
        val board = PerceptWriter(case["shapes"].number())
        val computer = PerceptDecoder()
        for (answer in case["answers"].items().map { it.jsonObject }) {
            val texts = answer["texts"].texts()
            board.items(texts, answer["known"].number()) shouldBe answer["itemsHex"].octets()
            computer.read(answer["itemsHex"].octets(), LIMIT).get() shouldBe texts.joinToString("")
        }
    }

    for ((name, case) in Vectors2.cases("void")) test("void: $name") {
        val computer = PerceptDecoder()
        for (answer in case["answers"].items().map { it.jsonObject }) {
            val texts = if (answer["texts"].isNull()) null else answer["texts"].texts().joinToString("")
            computer.read(answer["itemsHex"].octets(), LIMIT).orElse(null) shouldBe texts
            computer.known() shouldBe answer["known"].number()
        }
    }

    for ((name, case) in Vectors2.cases("parts")) test("parts: $name") {
        val request = case["request"].number()
        val answer = case["answerHex"].octets()
        val parts = if (case["size"].isNull()) AnswerPart.split(request, answer)
        else AnswerPart.split(request, answer, case["size"].number())
        parts.map { vectorOf(WireFrame.of(it.kind(), 0, it.payload())).removeRange(2, 4) } shouldBe case["payloads"].texts()
    }

    for ((name, case) in Vectors2.cases("vocabulary")) test("vocabulary: $name") {
        val all = mutableListOf<BoardAction>()
        for (page in case["pages"].items().map { it.jsonObject }) {
            val read = VocabularyPage.read(page["payloadHex"].octets())
            read.request() shouldBe page["request"].number()
            read.first() shouldBe page["first"].number()
            read.actions() shouldBe page["actions"].items().map { BoardAction(it.jsonArray[0].text(), it.jsonArray[1].number()) }
            all += read.actions()
            read.total() shouldBeGreaterThan all.size - 1
        }
        for (page in case["pages"].items().map { it.jsonObject }) {
            val room = 3 + case["room"].number()
            VocabularyPage.of(page["request"].number(), page["first"].number(), all, room).payload() shouldBe page["payloadHex"].octets()
        }
    }
})

private const val LIMIT = 65_536
