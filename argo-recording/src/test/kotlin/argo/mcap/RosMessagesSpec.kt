package argo.mcap

import io.kotest.assertions.throwables.shouldNotThrowAny
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.property.Arb
import io.kotest.property.arbitrary.byte
import io.kotest.property.arbitrary.byteArray
import io.kotest.property.arbitrary.int
import io.kotest.property.checkAll
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import java.nio.file.Path
import kotlin.io.path.readLines

private fun bytes(hex: String) = hex.filterNot { it == ' ' }.chunked(2).map { it.toInt(16).toByte() }.toByteArray()

private fun channel(definition: String) = McapChannel(1, "/a", McapSchema(1, "my_msgs/msg/A", "ros2msg", definition), "cdr")

/** Checks [lines] of the program cdr.py. A line has messages as other programs write them, and the JSON that must be read from them. */
internal fun checkCdr(lines: List<String>) = lines.forEach { line ->
    val vector = Json.parseToJsonElement(line).jsonObject
    val messages = RosMessages.of(channel(vector.getValue("schema").jsonPrimitive.content)).shouldNotBeNull()
    for ((writer, hex) in vector.getValue("bytes").jsonObject) {
        withClue("$writer: $line") { messages.read(bytes(hex.jsonPrimitive.content)) shouldBeJson vector.getValue("json") }
    }
}

private infix fun JsonElement.shouldBeJson(expected: JsonElement) = withNumbers(this) shouldBe withNumbers(expected)

/** Returns [json] with numbers in place of their texts, since `1e30` and `1.0E30` are equal. */
private fun withNumbers(json: JsonElement): Any? = when (json) {
    is JsonObject -> json.mapValues { withNumbers(it.value) }
    is List<*> -> json.map { withNumbers(it as JsonElement) }
    is JsonPrimitive -> if (json.isString) json.content else json.content.toBigDecimalOrNull()?.stripTrailingZeros() ?: json.content
}

/** Reads the bags that `rosbags` and `mcap` (PyPI) have written by src/test/readers/bag.py. */
class RosMessagesSpec : FunSpec({
    fun messages(bag: String, topic: String) = McapReader(Path.of("src/test/resources/bags/$bag.mcap")).use { reader ->
        reader.problems.shouldBeEmpty()
        reader.messages(topics = setOf(topic)).map { checkNotNull(RosMessages.of(it.channel)).read(it.data) }.toList()
    }

    for (bag in listOf("rosbags", "zstd", "lz4")) test("messages of the bag $bag are as a bridge writes them") {
        messages(bag, "/sonar").map { "${it["range"]}" }.take(3) shouldBe listOf("1.0", "0.8999999761581421", "0.800000011920929")
        messages(bag, "/sonar")[1]["header"] shouldBe
            Json.parseToJsonElement("""{"stamp": {"sec": 1700000000, "nanosec": 100000000}, "frame_id": "sonar"}""")
        messages(bag, "/said").map { "$it" } shouldBe listOf("""{"data":"go"}""", """{"data":"stop ☃"}""")
        "${messages(bag, "/scan")[0]["ranges"]}" shouldBe "[1.5,null,null]"
        messages(bag, "/tick").map { "$it" } shouldBe listOf("{}")
        "${messages(bag, "/image")[0]["data"]}" shouldBe "\"AQL/\""
    }

    test("messages are read as rosbags and Cyclone DDS write them, in either order of bytes") {
        checkCdr(Path.of("src/test/resources/cdr.jsonl").readLines())
    }

    test("a message that is compressed by itself is read, as rosbags writes it with compression mode message") {
        val messages = RosMessages.of(channel("string data")).shouldNotBeNull()
        val compressed = bytes("28b52ffd200a51000000010000020000007800")
        "${messages.read(compressed)}" shouldBe """{"data":"x"}"""
        shouldThrow<McapException> { messages.read(compressed.copyOf(9)) }.message shouldContain "its compressed bytes"
    }

    test("types are read with their constants and defaults") {
        val definition = """
            # FOO = a comment
            int8 FOO=-1  # a constant
            string TEXT="a # b"
            string<=5[<=2] names
            int32 kept 7
            Inner[2] inner
            ================================================================================
            MSG: my_msgs/msg/Inner
            builtin_interfaces/Time at  # with '='
        """.trimIndent()
        val (own, inner) = RosMessages.of(channel(definition)).shouldNotBeNull().types
        own.constants shouldBe mapOf("FOO" to "-1", "TEXT" to "a # b")
        own.fields.map { Triple(it.name, it.type, it.length) } shouldBe
            listOf(Triple("names", "string", RosField.OPEN), Triple("kept", "int32", RosField.SINGLE), Triple("inner", "my_msgs/Inner", 2))
        inner.fields.map { it.type } shouldBe listOf("builtin_interfaces/Time")
    }

    test("a message or a type that cannot be read is refused with the reason") {
        fun refusal(definition: String, hex: String) =
            shouldThrow<McapException> { RosMessages.of(channel(definition))?.read(bytes(hex)) }.message.orEmpty()
        refusal("int64 a", "00010000 01") shouldContain "a message of my_msgs/A ends within a field"
        refusal("string a", "00010000 ffffff7f 00") shouldContain "ends within a field"
        refusal("float64[999999999] a", "00010000 00") shouldContain "ends within a field"
        refusal("A a", "00010000 00") shouldContain "the type my_msgs/A is nested too deep, or holds itself"
        refusal("B a", "00010000 00") shouldContain "the bag does not describe the type my_msgs/B"
        refusal("wstring a", "00010000 00") shouldContain "my_msgs/A has a wstring, which each middleware"
        refusal("int32 a", "0002 0000 00000000") shouldContain "it is in the form 0002 of CDR, and only 0000 and 0001 can be read here"
        refusal("int32 a", "0001") shouldContain "at least 4 bytes"
        refusal("a message", "00010000") shouldContain "the bag does not describe the type my_msgs/a"
        refusal("int32", "00010000") shouldContain "\"int32\" is no field of a message of ROS"
        RosMessages.of(channel("int32 a").copy(messageEncoding = "json")) shouldBe null
        shouldThrow<McapException> { RosMessages.of(channel("").copy(schema = McapSchema(1, "A", "ros2idl", ""))) }.message shouldContain
            "the type of /a is described by ros2idl, and only ros2msg can be read here"
    }

    test("a type that promises more than a message can hold takes no memory") {
        val doubling = (0..40).joinToString("\n${"=".repeat(80)}\n") {
            (if (it == 0) "" else "MSG: my_msgs/T$it\n") + "T${it + 1} a\nT${it + 1} b"
        }
        val types = "$doubling\n${"=".repeat(80)}\nMSG: my_msgs/T41"
        shouldThrow<McapException> { RosMessages.of(channel(types))?.read(bytes("00010000")) }.message shouldContain
            "a message of my_msgs/A has more than 1000000 values"
    }

    test("no bytes do harm") {
        val types = "string a\nfloat64[] b\nA2[] c\n${"=".repeat(80)}\nMSG: my_msgs/A2\nuint8[] d\nint16 e"
        val reader = RosMessages.of(channel(types)).shouldNotBeNull()
        checkAll(200, Arb.byteArray(Arb.int(0..60), Arb.byte())) { data ->
            shouldNotThrowAny {
                try {
                    reader.read(byteArrayOf(0, 1, 0, 0) + data)
                } catch (_: McapException) {
                    // refused
                }
            }
        }
    }
})
