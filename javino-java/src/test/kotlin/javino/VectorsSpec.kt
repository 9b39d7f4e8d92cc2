package javino

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.int
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import java.nio.file.Path
import java.util.HexFormat
import java.util.concurrent.TimeUnit
import kotlin.io.path.readText

/** The vectors that the board's library passes too: what the two ends must agree on, byte for byte. */
class VectorsSpec : FunSpec({
    val vectors = Json.parseToJsonElement(Path.of("../javino-arduino/vectors/javino-vectors.json").readText()).jsonObject
    val encode = vectors.cases("encode")
    val fragment = vectors.cases("fragment")
    val decode = vectors.cases("decode")

    test("there are vectors of all kinds") {
        vectors.cases("crc").size shouldBeGreaterThan 2
        encode.count { it["version"].number() == 1 } shouldBeGreaterThan 5
        encode.count { it["version"].number() == 2 } shouldBeGreaterThan 5
        fragment.size shouldBeGreaterThan 3
        for (receiver in RECEIVERS) decode.count { receiver.versions in it["receivers"].items() } shouldBeGreaterThan 20
    }

    for (case in vectors.cases("crc")) test("crc: ${case["name"].text()}") {
        case["hex"].bytes().let { Crc16.of(it, 0, it.size) } shouldBe case["crc"].text().toInt(16)
    }

    for (case in encode) test(case["name"].text()) {
        val payload = case["hex"].bytes()
        val frame = if (case["version"].number() == 1) Frame.of(payload)
        else Frame.version2(payload, case["flags"].number(), case["sequence"].number())
        frame.toBytes() shouldBe case["frame"].bytes()
    }

    for (case in fragment) test("fragment: ${case["name"].text()}") {
        val frames = Frame.fragments(case["hex"].bytes(), case["sequence"].number())
        frames.map { hex(it.toBytes()) } shouldBe case["frames"].items().map { it.text() }
    }

    for (receiver in RECEIVERS) for (case in decode.filter { receiver.versions in it["receivers"].items() }) {
        test("decode, receiver of ${receiver.versions}: ${case["name"].text()}") {
            val frames = ArrayList<Frame>()
            val decoder = FrameDecoder(millis(case["timeoutMs"].number()), receiver.protocol, frames::add)
            var now = 0L
            for (chunk in case["chunks"].items().map { it.jsonObject }) {
                now += millis(chunk.getValue("gapMs").number())
                decoder.idle(now)
                chunk.getValue("hex").bytes().let { decoder.accept(it, 0, it.size, now) }
                chunk["delivered"]?.let { frames.size shouldBe it.number() }
            }
            decoder.idle(now + millis(case["endGapMs"].number()))
            frames shouldBe case["messages"].items().map { frame(it.jsonObject) }
        }
    }
})

private class Receiver(versions: String, val protocol: Protocol) {
    val versions = Json.parseToJsonElement(versions).jsonArray
}

private val RECEIVERS = listOf(Receiver("[1]", Protocol.V1), Receiver("[1, 2]", Protocol.AUTO))

private fun frame(message: Case): Frame {
    val payload = message["hex"].bytes()
    return if (message["version"].number() == 1) Frame.of(payload)
    else Frame.version2(payload, message["flags"].number(), message["sequence"].number())
}

private typealias Case = Map<String, JsonElement>

private fun Case.cases(kind: String): List<Case> = getValue(kind).jsonArray.map { it.jsonObject }

private fun JsonElement?.number(): Int = checkNotNull(this).jsonPrimitive.int

private fun JsonElement?.text(): String = checkNotNull(this).jsonPrimitive.content

private fun JsonElement?.items(): List<JsonElement> = checkNotNull(this).jsonArray

private fun JsonElement?.bytes(): ByteArray = HexFormat.of().parseHex(text())

private fun hex(bytes: ByteArray) = HexFormat.of().formatHex(bytes)

private fun millis(ms: Int) = TimeUnit.MILLISECONDS.toNanos(ms.toLong())
