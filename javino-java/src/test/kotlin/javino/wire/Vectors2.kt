package javino.wire

import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.boolean
import kotlinx.serialization.json.int
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import java.nio.file.Path
import java.util.HexFormat
import kotlin.io.path.readText

/** The test vectors of version 2. The board's library and the reference must pass these vectors too. */
internal object Vectors2 {
    private val file = Json.parseToJsonElement(Path.of("../javino-arduino/vectors/javino2-vectors.json").readText()).jsonObject

    fun cases(group: String): Map<String, JsonObject> =
        file.getValue(group).jsonArray.map { it.jsonObject }.associateBy { it["name"].text() }
}

internal fun JsonElement?.number(): Int = checkNotNull(this).jsonPrimitive.int

internal fun JsonElement?.text(): String = checkNotNull(this).jsonPrimitive.content

internal fun JsonElement?.items(): List<JsonElement> = checkNotNull(this).jsonArray

internal fun JsonElement?.texts(): List<String> = items().map { it.text() }

internal fun JsonElement?.isTrue(): Boolean = this?.jsonPrimitive?.boolean ?: false

internal fun JsonElement?.isNull(): Boolean = this == null || this is JsonNull

/** Decodes hexadecimal digits to one character a byte. */
internal fun JsonElement?.octets(): String = textOf(HexFormat.of().parseHex(text()))
