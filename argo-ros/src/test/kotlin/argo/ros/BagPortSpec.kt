package argo.ros

import argo.links.BoardLinkProvider
import argo.links.Wish
import argo.ros.checking.RosCheckCommand
import io.kotest.assertions.nondeterministic.eventually
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempfile
import io.kotest.matchers.collections.shouldContainAll
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import javino.LineClock
import javino.NoSuchPortException
import javino.PortFaultException
import javino.link.SendOptions
import picocli.CommandLine
import java.io.PrintWriter
import java.io.StringWriter
import kotlin.io.path.writeText

private const val BAG = "../argo-recording/src/test/resources/bags/zstd.mcap"

class BagPortSpec : FunSpec({
    fun open(port: String) = checkNotNull(BoardLinkProvider.of(port)).open(port, true, LineClock.system())

    test("a port replay: of a bag gives percepts by the mapping, in the time of the bag, and takes commands") {
        open("replay:$BAG#bag").use { link ->
            link.actions?.map { it.name() } shouldBe listOf("stop", "say")
            link.wants(Wish(true, 20, null))
            val seen = HashSet<String>()
            eventually(LIMIT) {
                seen += link.listen(500)?.text.orEmpty().split(';')
                seen shouldContainAll listOf("dist(100)", "dist(10)", "said(\"stop ☃\")")
            }
            link.send("stop", SendOptions.defaults()).outcome.get()
        }
    }

    test("a recording of a board stays a port on a line, and what is no bag is refused with the reason") {
        BoardLinkProvider.of("replay:drive.rec") shouldBe null
        shouldThrow<NoSuchPortException> { open("replay:none.mcap#bag") }.message shouldContain "there is no bag none.mcap in "
        val text = tempfile(suffix = ".mcap").toPath().apply { writeText("no bag at all") }
        shouldThrow<PortFaultException> { open("replay:$text#bag") }.message shouldContain "it does not begin as one"
        val database = tempfile(suffix = ".db3").toPath().apply { writeText("SQLite format 3") }
        shouldThrow<PortFaultException> { open("replay:$database#bag") }.message shouldContain "\"ros2 bag convert\" makes an MCAP file"
        shouldThrow<NoSuchPortException> { open("replay:${database.parent}#bag") }.message shouldContain "is a folder"
    }

    test("ros check compares a mapping with the types in a bag") {
        val file = tempfile(suffix = ".ros.yaml").toPath()
        fun check(mapping: String, seconds: Int = 1): Pair<Int, String> {
            file.writeText(mapping)
            val (out, err) = StringWriter() to StringWriter()
            val command = CommandLine(RosCheckCommand()).setOut(PrintWriter(out, true)).setErr(PrintWriter(err, true))
            return command.execute("$file", "replay:$BAG", "--seconds", "$seconds") to "$out$err"
        }
        check("percepts:\n  - /said std_msgs/msg/String", seconds = 2).let { (status, told) -> // the end of a bag is no error
            status shouldBe 0
            told shouldContain "the bag is over"
        }
        check("percepts:\n  - /image sensor_msgs/msg/Image -> size(widht)").let { (status, told) ->
            status shouldBe 1
            told shouldContain "2:42: sensor_msgs/msg/Image has no field widht; it has header, height, width"
        }
        val lines = listOf(
            "/sonar sensor_msgs/msg/Range -> infrared if radiation_type == ULTRASOUND", "/said std_msgs/msg/Bool",
            "/sonars sensor_msgs/msg/Range -> d(range)",
        )
        val told = check(lines.joinToString("\n", "percepts:\n") { "  - $it" }).second
        told shouldContain "  infrared\n"
        told shouldContain "/said is of type std_msgs/msg/String on the robot, and the mapping says std_msgs/msg/Bool"
        told shouldContain "no node publishes /sonars"
    }
})
