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

/** The test vectors of version 1. The board's library must pass these vectors too. */
class VectorsSpec : FunSpec({
    val vectors = Json.parseToJsonElement(Path.of("../javino-arduino/vectors/javino-vectors.json").readText()).jsonObject
    val encode = vectors.cases("encode")
    val decode = vectors.cases("decode")

    test("there are vectors of all kinds") {
        encode.size shouldBeGreaterThan 5
        decode.size shouldBeGreaterThan 60
    }

    for (case in encode) test("encode: ${case["name"].text()}") {
        Frame.of(case["hex"].bytes()).toBytes() shouldBe case["frame"].bytes()
    }

    for (case in decode) test("decode: ${case["name"].text()}") {
        val frames = ArrayList<Frame>()
        val decoder = FrameDecoder(millis(case["timeoutMs"].number()), frames::add)
        var now = 0L
        for (chunk in case["chunks"].items().map { it.jsonObject }) {
            now += millis(chunk.getValue("gapMs").number())
            decoder.idle(now)
            chunk.getValue("hex").bytes().let { decoder.accept(it, 0, it.size, now) }
            chunk["delivered"]?.let { frames.size shouldBe it.number() }
        }
        decoder.idle(now + millis(case["endGapMs"].number()))
        frames shouldBe case["messages"].items().map { Frame.of(it.bytes()) }
    }
})

private typealias Case = Map<String, JsonElement>

private fun Case.cases(kind: String): List<Case> = getValue(kind).jsonArray.map { it.jsonObject }

private fun JsonElement?.number(): Int = checkNotNull(this).jsonPrimitive.int

private fun JsonElement?.text(): String = checkNotNull(this).jsonPrimitive.content

private fun JsonElement?.items(): List<JsonElement> = checkNotNull(this).jsonArray

private fun JsonElement?.bytes(): ByteArray = HexFormat.of().parseHex(text())

private fun millis(ms: Int) = TimeUnit.MILLISECONDS.toNanos(ms.toLong())
