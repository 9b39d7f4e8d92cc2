package argo.ros

import argo.filters.GroundTerm
import argo.mcap.McapWriter
import argo.ros.bridge.operationIn
import argo.testkit.agentOf
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempfile
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import java.nio.channels.FileChannel
import java.nio.file.Path
import java.nio.file.StandardOpenOption
import java.util.logging.Level
import kotlin.time.Duration.Companion.seconds

private const val PORT = "ros://robot:9090"

private val PROGRAM = """
    !start.
    +!start <- argo.port("$PORT"); argo.limit(50); argo.percepts(open); argo.act(move(0.3, 0)).
    +dist(f, D) : D < 40 <- argo.act(stop); argo.act(dock); +docked.
""".trimIndent()

/** Agents in virtual time, with the mapping `robot.ros.yaml`. */
class PlayedRobotSpec : FunSpec({
    test("messages of topics become percepts, and commands become messages, by the mapping") {
        agentOf(PROGRAM) { board(PORT).playsItsMapping() }.use { robot ->
            robot.shouldSend("move(0.3,0)")
            robot.board.publishes("/sonar/front", """{"range": 0.5}""")
            robot.shouldBelieve("dist(f,50)").shouldNotSend("stop")
            robot.board.publishes("/sonar/front", """{"range": 0.382}""")
            robot.shouldSend("stop").shouldSend("dock").shouldBelieve("docked").shouldBelieve("dist(f,38)")
            robot.board.published shouldBe listOf(
                """/cmd_vel {"linear":{"x":0.3},"angular":{"z":0}}""", """/cmd_vel {"linear":{"x":0},"angular":{"z":0}}""",
                """/dock {"station":"home"}""",
            )
        }
    }

    test("text passes in both directions as it is, whatever its characters") {
        val program = """!start. +!start <- argo.port("$PORT#said"); argo.limit(50); argo.percepts(open). +said(T) <- argo.act(say(T))."""
        agentOf(program) { board("$PORT#said").playsItsMapping() }.use { robot ->
            robot.shouldBelieve("port(\"$PORT#said\",on)")
            val texts = listOf("☃ ü", "C:\\robot\\map.yaml", "{\"a\": \"x\\ny\"}", "two\nlines", "\\d+")
            for (text in texts) {
                val message = "${JsonObject(mapOf("data" to JsonPrimitive(text)))}"
                robot.board.publishes("/said", message)
                robot.shouldSend("say(${GroundTerm.Text(text)})")
                robot.board.published.last() shouldBe "/say ${operationIn(message)}"
            }
        }
    }

    test("what is published while the robot is gone is never perceived, and its port comes back") {
        agentOf(PROGRAM) { board(PORT).playsItsMapping() }.use { robot ->
            robot.shouldBelieve("port(\"$PORT\",on)")
            robot.board.disconnects()
            robot.shouldBelieve("port(\"$PORT\",off)")
            robot.board.publishes("/sonar/front", """{"range": 0.3}""")
            robot.board.reconnects()
            robot.shouldBelieve("port(\"$PORT\",on)", within = 5.seconds).shouldNotBelieve("dist(f,30)")
            robot.board.publishes("/sonar/front", """{"range": 0.3}""")
            robot.shouldBelieve("dist(f,30)")
        }
    }

    val bags = Path.of("../argo-recording/src/test/resources/bags")
    val listener = """
        !start.
        +!start <- argo.port("$PORT#bag"); argo.limit(50); argo.percepts(open).
        +dist(Cm) : Cm < 50 <- argo.act(stop).
        +said(W) <- argo.act(say(W)).
    """.trimIndent()

    for (bag in listOf("rosbags", "zstd", "lz4")) test("the bag $bag drives an agent in virtual time, twice alike") {
        fun drive() = agentOf(listener) { board("$PORT#bag").replays(bags.resolve("$bag.mcap")) }.use { robot ->
            robot.shouldSend("say(\"go\")").after(2.seconds)
            robot.shouldBelieve("dist(10)")
            robot.board.arrivals.map { "$it" } to robot.board.published
        }
        val (arrivals, published) = drive()
        published.distinct() shouldBe listOf("""/say {"data":"go"}""", """/say {"data":"stop ☃"}""", "/stop {}")
        drive() shouldBe (arrivals to published)
    }

    test("of a bag it is told what cannot be read, and that it is over; it is not begun before its agent perceives") {
        LoggedWarnings(Level.INFO).use { log ->
            agentOf(listener.replace("argo.percepts(open)", ".wait(5000); argo.percepts(open)")) {
                board("$PORT#bag").replays(bags.resolve("odd.mcap"))
            }.use { robot ->
                robot.after(3.seconds).shouldNotSend("say(\"a\")")
                robot.shouldSend("say(\"a\")", within = 3.seconds).shouldSend("say(\"b\")", within = 3.seconds).after(2.seconds)
            }
            log.messages.filter { "the bag" in it || "left out" in it }.map { it.substringAfter("9090#bag: ") } shouldBe
                listOf("a message of /said is left out: a message of std_msgs/String ends within a field", "the bag is over")
        }
    }

    test("a file that is no bag of ROS 2 fails argo.port with the reason") {
        val own = tempfile(suffix = ".mcap").toPath()
        McapWriter(FileChannel.open(own, StandardOpenOption.WRITE)).use { it.channel("/robot/cycle", it.schema("argo.Cycle", "{}")) }
        val program = """!start. +!start <- argo.port("$PORT#bag"). -!start[error(E),error_msg(M)] <- .print(M); +why(E)."""
        agentOf(program) { board("$PORT#bag").replays(own) }.use { it.shouldBelieve("why(port_failed)") }
    }

    test("a test that misspells is refused") {
        agentOf(PROGRAM) { board(PORT).playsItsMapping() }.use { robot ->
            robot.shouldBelieve("port(\"$PORT\",on)")
            shouldThrow<IllegalArgumentException> { robot.board.publishes("/sonar/front", "range 0.3") }.message shouldContain "JSON"
            shouldThrow<IllegalStateException> { robot.board("ttyACM0").publishes("/a", "{}") }.message shouldContain "playsItsMapping()"
        }
    }

    test("a mapping that is refused fails argo.port") {
        val program = """!start. +!start <- argo.port("$PORT#none"). -!start[error(E)] <- +why(E)."""
        agentOf(program) { board("$PORT#none").playsItsMapping() }.use { it.shouldBelieve("why(port_failed)") }
    }
})
