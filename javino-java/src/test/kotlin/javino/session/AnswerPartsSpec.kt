package javino.session

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import javino.wire.FrameKind
import javino.wire.Vectors2
import javino.wire.WireFrame
import javino.wire.items
import javino.wire.number
import javino.wire.octets
import kotlinx.serialization.json.jsonObject

private val KINDS = mapOf(2 to FrameKind.PERCEPTS, 3 to FrameKind.PERCEPTS_PART, 4 to FrameKind.PERCEPTS_LAST)

class AnswerPartsSpec : FunSpec({
    for ((name, case) in Vectors2.cases("assemble")) test("assemble: $name") {
        val parts = AnswerParts()
        val answers = case["payloads"].items().map { it.octets() }.mapNotNull { bytes ->
            val frame = WireFrame.of(KINDS.getValue(bytes[0].code and 0x1f), 0, bytes.drop(1))
            parts.accept(frame)?.takeIf { it.items() != null }
        }
        answers shouldBe case["answers"].items().map { it.jsonObject }
            .map { AnswerParts.Answer(it["request"].number(), it["itemsHex"].octets()) }
    }
})
