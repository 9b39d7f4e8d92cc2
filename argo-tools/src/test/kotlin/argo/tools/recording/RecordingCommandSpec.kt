package argo.tools.recording

import argo.mcap.McapWriter
import argo.tools.Output
import argo.tools.argo
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempfile
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.boolean
import kotlinx.serialization.json.double
import kotlinx.serialization.json.int
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import java.nio.channels.FileChannel
import java.nio.file.Path
import java.nio.file.StandardOpenOption
import kotlin.io.path.readBytes
import kotlin.io.path.writeBytes
import kotlin.io.path.writeText

private const val SECOND = 1_000_000_000L

class RecordingCommandSpec : FunSpec({
    val file = tempfile(suffix = ".mcap").toPath()
    McapWriter(FileChannel.open(file, StandardOpenOption.WRITE)).use { writer ->
        writer.metadata("versions", mapOf("argo" to "0.1.0", "java" to "17"))
        writer.attachment("program/robot.asl", "text/plain", "!start.\n".encodeToByteArray())
        val cycles = writer.channel("/robot/cycle", writer.schema("argo.Cycle", "{}"))
        val prints = writer.channel("/robot/print", writer.schema("argo.Print", "{}"))
        (0L..3L).forEach { writer.message(cycles, 7 * SECOND + it * SECOND / 2, 0, """{"cycle":$it}""".encodeToByteArray()) }
        writer.message(prints, 9 * SECOND, 0, "\"\u001B[2J\"".encodeToByteArray())
    }

    test("seconds have a point in each language, as the options take them") {
        val java = Path.of(System.getProperty("java.home"), "bin", "java").toString()
        val tool = listOf(java, "-Duser.language=de", "-cp", System.getProperty("java.class.path"), "argo.tools.MainKt")
        val process = ProcessBuilder(tool + listOf("recording", "$file")).start()
        process.inputReader().readText() shouldContain "5 messages in 2.000 s"
    }

    test("a percent sign in the name of a recording is shown as it is") {
        val copy = tempfile(suffix = "50%d.mcap").toPath().apply { writeBytes(file.readBytes()) }
        argo("recording", "$copy").out shouldContain "$copy: 5 messages in 2.000 s"
    }

    test("recording shows what a recording holds") {
        argo("recording", "$file") shouldBe Output(
            0,
            """
            $file: 5 messages in 2.000 s, written by argo, complete
            TOPIC         SCHEMA      MESSAGES  FIRST    LAST
            /robot/cycle  argo.Cycle  4         0.000 s  1.500 s
            /robot/print  argo.Print  1         2.000 s  2.000 s
            FILE               TYPE        BYTES
            program/robot.asl  text/plain  8
            versions: argo=0.1.0, java=17

            """.trimIndent(),
            "",
        )
    }

    test("the messages of several recordings are in one order, and without messages of agents by the clock of each") {
        val other = tempfile(suffix = ".mcap").toPath()
        McapWriter(FileChannel.open(other, StandardOpenOption.WRITE)).use { writer ->
            writer.message(writer.channel("/other", writer.schema("Other", "{}")), 7 * SECOND + SECOND / 4, 0, "{}".encodeToByteArray())
        }
        argo("recording", "$file", "$other", "--messages", "--until", "0.6") shouldBe Output(
            0,
            "    0.000 s  $file  /robot/cycle  {\"cycle\":0}\n    0.250 s  $other  /other  {}\n" +
                "    0.500 s  $file  /robot/cycle  {\"cycle\":1}\n",
            "$other: no message of agents connects it with $file, so its times are those of its own clock\n",
        )
        argo("recording", "$file", "$other").out.lines().count { "written by argo" in it } shouldBe 2
        argo("recording", "$file", "$other", "--file", "x").err shouldContain "--file goes with one recording, not with 2"
    }

    test("--messages shows messages of a bag of ROS 2 in JSON, and tells those that cannot be read") {
        val bag = "../argo-recording/src/test/resources/bags/zstd.mcap"
        argo("recording", bag, "--messages", "--topic", "/said", "--until", "0.1") shouldBe
            Output(0, "    0.000 s  /said  {\"data\":\"go\"}\n", "")
        argo("recording", bag.replace("zstd", "odd"), "--messages").run {
            status shouldBe 1
            out.lines().take(5) shouldBe listOf(
                "    0.000 s  /said  {\"data\":\"a\"}", "    1.000 s  /said  (9 bytes)", "    2.000 s  /said  {\"data\":\"b\"}",
                "    3.000 s  /idl  \\x00\\x01", "    3.000 s  /text  {}",
            )
            err shouldContain "messages of /said are left out: a message of std_msgs/String ends within a field"
            err shouldContain "messages of /idl are shown as they are: the type of /idl is described by ros2idl"
        }
    }

    test("recording --json is data") {
        val json = Json.parseToJsonElement(argo("recording", "$file", "--json").out).jsonObject
        json.getValue("messages").jsonPrimitive.int shouldBe 5
        json.getValue("complete").jsonPrimitive.boolean shouldBe true
        val first = json.getValue("channels").jsonArray.first().jsonObject
        first.getValue("topic").jsonPrimitive.content shouldBe "/robot/cycle"
        first.getValue("last").jsonPrimitive.double shouldBe 1.5
        json.getValue("metadata").jsonObject.getValue("versions").jsonObject.getValue("argo").jsonPrimitive.content shouldBe "0.1.0"
    }

    test("--messages prints those of some seconds and topics, and what could command a terminal as text") {
        argo("recording", "$file", "--messages", "--from", "0.5", "--until", "1.5", "--topic", "/robot/cycle").out shouldBe
            "    0.500 s  /robot/cycle  {\"cycle\":1}\n    1.000 s  /robot/cycle  {\"cycle\":2}\n"
        argo("recording", "$file", "--messages", "--from", "2").out shouldBe "    2.000 s  /robot/print  \"\\x1B[2J\"\n"
        argo("recording", "$file", "--messages", "--until", "0.1", "--json").out shouldBe
            """{"topic":"/robot/cycle","seconds":0.0,"ns":7000000000,"message":{"cycle":0}}""" + "\n"
    }

    test("messages of another program that are no JSON are texts, and a recording without messages is told") {
        val other = tempfile(suffix = ".mcap").toPath()
        McapWriter(FileChannel.open(other, StandardOpenOption.WRITE)).use { writer ->
            writer.message(writer.channel("/log", writer.schema("Text", "")), SECOND, 0, "on [".encodeToByteArray())
        }
        argo("recording", "$other", "--messages", "--json").out shouldBe
            """{"topic":"/log","seconds":0.0,"ns":1000000000,"message":"on ["}""" + "\n"
        McapWriter(FileChannel.open(other, StandardOpenOption.WRITE, StandardOpenOption.TRUNCATE_EXISTING)).close()
        argo("recording", "$other", "--messages") shouldBe Output(0, "", "$other has no message\n")
    }

    test("--file prints a file of the program") {
        argo("recording", "$file", "--file", "program/robot.asl") shouldBe Output(0, "!start.\n", "")
        argo("recording", "$file", "--file", "robot.asl").err shouldBe
            "$file holds no file robot.asl; those that it holds: program/robot.asl\n"
    }

    test("bytes behind the end of a recording are told, with status 1") {
        val longer = tempfile(suffix = ".mcap").toPath().apply { writeBytes(file.readBytes() + byteArrayOf(1, 2, 3)) }
        val said = argo("recording", "$longer")
        said.status shouldBe 1
        said.err.trim() shouldBe
            "$longer: the recording ends 3 bytes before the end of the file; they were not read, be they another recording"
    }

    test("a recording that was cut off is shown as far as it goes, with status 1") {
        val cut = tempfile(suffix = ".mcap").toPath()
        cut.writeBytes(file.readBytes().run { copyOf(size - 10) })
        val said = argo("recording", "$cut")
        said.status shouldBe 1
        said.out shouldContain "$cut: 5 messages in 2.000 s, written by argo, not complete"
        said.err shouldContain "the file was cut off behind byte"
    }

    test("what is no recording, a topic that is missing and wrong arguments are refused in words") {
        val text = tempfile(suffix = ".mcap").toPath().also { it.writeText("javino") }
        argo("recording", "$text") shouldBe Output(1, "", "$text is no MCAP file: it does not begin as one\n")
        val board = tempfile(suffix = ".rec").toPath().also { it.writeText("javino-recording 1\n0\tin\tdist(1);\n") }
        argo("recording", "$board").err shouldContain "it is a recording of a board; \"monitor replay:$board\" shows it"
        argo("recording", "no-such.mcap").err shouldBe "there is no file no-such.mcap\n"
        argo("recording", "$file", "--messages", "--topic", "/x").err shouldBe
            "$file has no topic /x; those that it has: /robot/cycle, /robot/print\n"
        argo("recording", "$file", "--topic", "/x").status shouldBe 2
        argo("recording", "$file", "--messages", "--from", "-1").err shouldContain "-1 is no second of a recording"
        argo("recording", "$file", "--messages", "--file", "a").status shouldBe 2
        argo("recording", "$file", "--messages", "--from", "3") shouldBe Output(0, "", "$file has no such message in that time\n")
        argo("recording", "$file", "--messages", "--from", "2", "--until", "1").err shouldContain "--until is later than --from"
    }

    test("replay, which runs agents again, names what it is that holds none") {
        argo("replay", "$file") shouldBe
            Output(1, "", "$file holds no agent; the option argo_record=\"FILE.mcap\" of an agent in the .mas2j records it\n")
    }
})
