package argo.ros

import argo.filters.Condition
import argo.filters.GroundTerm
import argo.filters.Operator
import argo.filters.PerceptionFilter
import argo.filters.Predicate
import argo.filters.Rule
import argo.filters.TermTest
import argo.links.BoardLink
import argo.links.BoardMessage
import argo.links.Wish
import argo.ros.bridge.Bridge
import argo.ros.bridge.BridgeListener
import argo.ros.bridge.Outgoing
import argo.ros.bridge.part
import argo.ros.bridge.text
import argo.ros.mapping.mappingOf
import io.kotest.assertions.nondeterministic.eventually
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainExactlyInAnyOrder
import io.kotest.matchers.ints.shouldBeLessThan
import io.kotest.matchers.maps.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.types.shouldBeInstanceOf
import javino.ActionFailedException
import javino.ActionRefusedException
import javino.ActionUnconfirmedException
import javino.LineClock
import javino.NoSuchPortException
import javino.PortException
import javino.PortFaultException
import javino.PortGoneException
import javino.PortTimeoutException
import javino.link.SendOptions
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import java.net.ServerSocket
import java.net.Socket
import java.net.URI
import java.util.concurrent.ExecutionException
import java.util.concurrent.TimeUnit
import kotlin.time.Duration.Companion.seconds

internal val LIMIT = 60.seconds
private const val LIMIT_MS = 60_000

private const val RESULT = "/dock/result"

private val ROBOT = """
    percepts:
      - /sonar/front sensor_msgs/Range -> dist(f, round(range*100))
      - /sonar/back sensor_msgs/Range -> dist(b, round(range*100))
      - /bumper std_msgs/Bool
    commands:
      - move(V, W) -> /cmd_vel geometry_msgs/Twist
      - reset -> service /reset std_srvs/Trigger
      - dock(N) -> action /dock dock_msgs/DockAction(station = N) within 2 s
      - turn(A) -> action /turn turtlesim/action/RotateAbsolute(theta = A) within 2 s
""".trimIndent()

class RosLinkSpec : FunSpec({
    lateinit var bridge: TestBridge
    beforeTest { bridge = TestBridge() }
    afterTest { bridge.close() }

    fun open(mapping: String = ROBOT): RosLink =
        RosLink.open(bridge.port, URI("ws://127.0.0.1:${bridge.number}/"), mappingOf(mapping, "robot.ros.yaml"), true, LineClock.system())

    fun perceived(wish: Wish = Wish(true, 50, null), mapping: String = ROBOT, work: suspend (RosLink) -> Unit): suspend () -> Unit = {
        open(mapping).use {
            it.wants(wish)
            work(it)
        }
    }

    suspend fun awaitSubscriptions(vararg topics: Pair<String, Pair<Long, Int>>) =
        eventually(LIMIT) { bridge.subscribed() - RESULT shouldBe topics.toMap() }

    fun BoardLink.awaitMessage(isWanted: (BoardMessage) -> Boolean): BoardMessage {
        while (true) listen(LIMIT_MS)?.takeIf(isWanted)?.let { return it }
    }

    fun outcomeOf(link: BoardLink, command: String, options: SendOptions = SendOptions.defaults()): String = try {
        link.send(command, options).outcome.get(LIMIT_MS.toLong(), TimeUnit.MILLISECONDS)
        "done"
    } catch (failed: ExecutionException) {
        failed.cause!!.javaClass.simpleName
    }

    context("topics") {
        test("are subscribed to at the sensing interval, with a queue for the newest message alone") {
            perceived {
                awaitSubscriptions("/sonar/front" to (50L to 1), "/sonar/back" to (50L to 1), "/bumper" to (50L to 1))
                it.wants(Wish(true, 200, null))
                awaitSubscriptions("/sonar/front" to (200L to 1), "/sonar/back" to (200L to 1), "/bumper" to (200L to 1))
                it.wants(Wish(false, 200, null))
                awaitSubscriptions()
            }()
        }
        test("that a filter drops entirely are not subscribed to, until it is changed") {
            val notFront = Condition.Argument(0, TermTest.Compare(Operator.NE, GroundTerm.of("f")))
            perceived(Wish(true, 50, PerceptionFilter("front", Rule(Predicate("dist"), listOf(notFront)), Rule("bumper")))) {
                awaitSubscriptions("/sonar/front" to (50L to 1))
                it.wants(Wish(true, 50, null))
                awaitSubscriptions("/sonar/front" to (50L to 1), "/sonar/back" to (50L to 1), "/bumper" to (50L to 1))
            }()
        }
        test("are perceived by their newest messages") {
            perceived {
                awaitSubscriptions("/sonar/front" to (50L to 1), "/sonar/back" to (50L to 1), "/bumper" to (50L to 1))
                bridge.publish("/sonar/front", """{"range": 1.2}""")
                bridge.publish("/bumper", """{"data": false}""")
                it.awaitMessage { message -> message.text == "dist(f,120);bumper(false);" }
                bridge.publish("/sonar/front", """{"range": 0.5}""")
                it.awaitMessage { message -> message.text == "dist(f,50);bumper(false);" }
            }()
        }
        test("that do not say what a rule needs are not believed") {
            perceived {
                awaitSubscriptions("/sonar/front" to (50L to 1), "/sonar/back" to (50L to 1), "/bumper" to (50L to 1))
                bridge.publish("/sonar/front", """{"range": 1.2}""")
                it.awaitMessage { message -> message.text == "dist(f,120);" }
                bridge.publish("/sonar/front", """{"distance": 7}""")
                it.awaitMessage { message -> message.text == "" }
                bridge.publish("/sonar/front", """{"range": null}""")
                bridge.publish("/bumper", """{"data": true}""")
                it.awaitMessage { message -> message.text == "bumper(true);" }
            }()
        }
        test("that say nothing leave the bridge on, as long as that shows that it is there") {
            perceived { it.listen(400) shouldBe null }()
        }
        test("of a bridge that does not show that it is there make a time-out") {
            perceived {
                awaitSubscriptions("/sonar/front" to (50L to 1), "/sonar/back" to (50L to 1), "/bumper" to (50L to 1))
                bridge.answersPings = false
                shouldThrow<PortTimeoutException> { repeat(1_000) { _ -> it.listen(40) } }
                bridge.answersPings = true
                eventually(LIMIT) { it.listen(40) shouldBe null }
            }()
        }
        test("have a time limit of their own if their rule has one") {
            perceived(mapping = "percepts:\n  - /hit std_msgs/Bool -> hit for 30 ms") {
                awaitSubscriptions("/hit" to (50L to 1))
                bridge.publish("/hit", """{"data": true}""")
                it.awaitMessage { message -> message.text == "hit;" }
                it.awaitMessage { message -> message.text == "" }
            }()
        }
    }

    context("ages") {
        fun time(nanos: Long) = """{"secs": ${nanos / 1_000_000_000}, "nsecs": ${nanos % 1_000_000_000}}"""
        val aheadNanos = TimeUnit.HOURS.toNanos(1)
        val rosNanos = { System.nanoTime() + aheadNanos + 1_000_000_000_000_000L }

        test("count from the time stamp, by the robot's clock") {
            bridge.serve("/rosapi/get_time") { true to JsonObject(mapOf("time" to Json.parseToJsonElement(time(rosNanos())))) }
            perceived {
                awaitSubscriptions("/sonar/front" to (50L to 1), "/sonar/back" to (50L to 1), "/bumper" to (50L to 1))
                eventually(LIMIT) {
                    val stamp = rosNanos() - TimeUnit.MILLISECONDS.toNanos(3_000)
                    bridge.publish("/sonar/front", """{"header": {"stamp": ${time(stamp)}}, "range": 1.2}""")
                    val message = it.awaitMessage { message -> message.text == "dist(f,120);" }
                    val ageMs = TimeUnit.NANOSECONDS.toMillis(message.receivedNanos - message.seenNanos.getValue("dist(f,120)"))
                    (ageMs >= 2_900) shouldBe true
                }
            }()
        }
        test("count from the arrival where the robot's clock is not known, or there is no stamp") {
            perceived {
                awaitSubscriptions("/sonar/front" to (50L to 1), "/sonar/back" to (50L to 1), "/bumper" to (50L to 1))
                bridge.publish("/sonar/front", """{"header": {"stamp": ${time(rosNanos())}}, "range": 1.2}""")
                val message = it.awaitMessage { message -> message.text == "dist(f,120);" }
                message.seenNanos.getValue("dist(f,120)") shouldBe message.receivedNanos
            }()
        }
    }

    context("commands") {
        test("to a topic are over when they have left") {
            open().use { link ->
                outcomeOf(link, "move(0.3,0)") shouldBe "done"
                eventually(LIMIT) {
                    bridge.heard("publish").map { "${it.text("topic")} ${it.part("msg")}" } shouldBe
                        listOf("""/cmd_vel {"linear":{"x":0.3},"angular":{"z":0}}""")
                }
                bridge.heard("advertise").map { it.text("topic") } shouldContainExactlyInAnyOrder
                    listOf("/cmd_vel", "/dock/goal", "/dock/cancel")
            }
        }
        test("to a service end with its response") {
            bridge.serve("/reset") { true to JsonObject(mapOf("success" to JsonPrimitive(true))) }
            open().use { outcomeOf(it, "reset") shouldBe "done" }
            bridge.serve("/reset") { true to Json.parseToJsonElement("""{"success": false, "message": "jam\u001b[m"}""") }
            open().use { link ->
                shouldThrow<ActionFailedException> { link.sendAndAwait("reset", SendOptions.defaults()) }.message shouldContain "jam\\x1B[m"
            }
        }
        test("that no rule has, or that a service does not exist for, fail") {
            open().use {
                outcomeOf(it, "fly") shouldBe ActionRefusedException::class.simpleName
                outcomeOf(it, "move(1)") shouldBe ActionRefusedException::class.simpleName
                outcomeOf(it, "reset") shouldBe ActionFailedException::class.simpleName
            }
        }
        test("to an action of ROS 1 end with the result of their goal") {
            bridge.onPublish = { topic, message ->
                val id = message.part("goal_id")?.text("id")
                val status = if (message.part("goal")?.text("station") == "home") 3 else 4
                if (topic == "/dock/goal") {
                    bridge.publish("/dock/result", """{"status": {"goal_id": {"id": "another"}, "status": 4, "text": ""}}""")
                    bridge.publish("/dock/result", """{"status": {"goal_id": {"id": "$id"}, "status": $status, "text": "no way"}}""")
                }
            }
            open().use { link ->
                eventually(LIMIT) { (RESULT in bridge.subscribed()) shouldBe true }
                outcomeOf(link, "dock(home)") shouldBe "done"
                shouldThrow<ActionFailedException> { link.sendAndAwait("dock(away)", SendOptions.defaults()) }.message shouldContain
                    "no way"
            }
        }
        test("to an action of ROS 2 end with its result") {
            bridge.onGoal = {
                val status = if (it.part("args")?.text("theta") == "1") 4 else 6
                bridge.say("""{"op":"action_result","id":"${it.text("id")}","action":"/turn","values":{},"status":$status,"result":true}""")
            }
            open().use {
                outcomeOf(it, "turn(1)") shouldBe "done"
                outcomeOf(it, "turn(2)") shouldBe ActionFailedException::class.simpleName
            }
        }
        test("to an action are cancelled when their time is over") {
            open().use { link ->
                outcomeOf(link, "dock(home)", SendOptions(false, 30)) shouldBe ActionUnconfirmedException::class.simpleName
                eventually(LIMIT) { bridge.heard("publish").map { it.text("topic") } shouldBe listOf("/dock/goal", "/dock/cancel") }
            }
        }
        test("have left long before their outcome is known, so that they hold up no perception") {
            open().use {
                val sent = it.send("dock(home)", SendOptions.defaults())
                sent.left.get(LIMIT_MS.toLong(), TimeUnit.MILLISECONDS)
                sent.outcome.isDone shouldBe false
            }
        }
    }

    context("faults") {
        test("a bridge that goes ends waits and commands at once, and nothing is left of the connection") {
            val link = open()
            link.wants(Wish(true, 50, null))
            val sent = link.send("reset", SendOptions.defaults()).also { bridge.serve("/reset") { error("mute") } }
            sent.left.get(LIMIT_MS.toLong(), TimeUnit.MILLISECONDS)
            bridge.close()
            shouldThrow<PortGoneException> { repeat(1_000) { link.listen(LIMIT_MS) } }
            link.isOpen shouldBe false
            val failure = shouldThrow<ExecutionException> { sent.outcome.get(LIMIT_MS.toLong(), TimeUnit.MILLISECONDS) }
            failure.cause.shouldBeInstanceOf<PortException>()
            shouldThrow<PortException> { link.sendAndAwait("move(1,1)", SendOptions.defaults()) }
        }
        test("no command goes out on a connection that has gone, also while its socket still takes messages") {
            lateinit var connection: BridgeListener
            val taking = object : Bridge {
                override fun send(message: Outgoing) {
                    message.left.complete(Unit)
                }
                override fun queue(message: Outgoing) = send(message)
                override fun flush() = Unit
                override fun ping() = Unit
                override fun close() = Unit
            }
            val link = RosLink.over("ros://robot", mappingOf(ROBOT, "robot.ros.yaml"), true, LineClock.system()) { listener ->
                connection = listener
                taking
            }
            outcomeOf(link, "move(1,1)") shouldBe "done"
            connection.gone("the bridge has closed the connection")
            outcomeOf(link, "move(1,1)") shouldBe PortGoneException::class.simpleName
        }
        test("garbage changes nothing") {
            perceived {
                awaitSubscriptions("/sonar/front" to (50L to 1), "/sonar/back" to (50L to 1), "/bumper" to (50L to 1))
                val garbage = listOf(
                    "", "null", "[]", "{", "{}", """{"op":7}""", """{"op":"publish"}""",
                    """{"op":"publish","topic":"/sonar/front","msg":[]}""",
                    """{"op":"publish","topic":"/other","msg":{}}""", """{"op":"service_response","id":[]}""",
                    "[".repeat(100_000), "\u0000",
                    """{"op":"publish","topic":"/sonar/front","msg":{"header":7,"range":"far"}}""",
                    """{"op":"status","level":"error","msg":"so it goes"}""",
                )
                garbage.forEach(bridge::say)
                bridge.publish("/sonar/front", """{"range": 1}""")
                it.awaitMessage { message -> message.text == "dist(f,100);" }
            }()
        }
        test("of a flood the newest message is perceived, and none waits behind another") {
            perceived(Wish(true, 0, null)) {
                awaitSubscriptions("/sonar/front" to (0L to 1), "/sonar/back" to (0L to 1), "/bumper" to (0L to 1))
                val count = 20_000
                for (i in 1..count) bridge.say("""{"op":"publish","topic":"/sonar/front","msg":{"range":${i / 100.0}}}""")
                var taken = 1
                while (it.awaitMessage { true }.text != "dist(f,$count);") taken++
                (taken <= count) shouldBe true
            }()
        }
        test("where nothing listens, or what listens is no bridge, is reported as such") {
            val clock = LineClock.system()
            val mapping = mappingOf(ROBOT, "robot.ros.yaml")
            Socket().use { silent -> // occupies the port
                silent.bind(null)
                val place = "127.0.0.1:${silent.localPort}"
                shouldThrow<NoSuchPortException> { RosLink.open("ros://$place", URI("ws://$place/"), mapping, true, clock) }
                    .message shouldContain "nothing listens"
            }
            ServerSocket(0).use { other ->
                Thread { other.accept().use { it.getOutputStream().write("HTTP/1.1 404 Not Found\r\n\r\n".toByteArray()) } }.start()
                val port = "ros://127.0.0.1:${other.localPort}"
                shouldThrow<PortFaultException> { RosLink.open(port, URI("ws://127.0.0.1:${other.localPort}/"), mapping, true, clock) }
            }
            ServerSocket(0).use { other ->
                Thread {
                    other.accept().use {
                        it.getInputStream().read(ByteArray(4096)) // else its close is a reset, which may overtake the answer
                        it.getOutputStream().write("\u001b[31m${"x".repeat(500)}\r\n\r\n".toByteArray())
                    }
                }.start()
                val port = "ros://127.0.0.1:${other.localPort}"
                val refusal = shouldThrow<PortFaultException> {
                    RosLink.open(port, URI("ws://127.0.0.1:${other.localPort}/"), mapping, true, clock)
                }.message.orEmpty()
                refusal shouldContain "does not answer as a bridge: Invalid status line: \"\\x1B[31mxxx"
                refusal.length shouldBeLessThan 400
            }
        }
        test("a field that the bridge does not know of its type is refused with line and column") {
            bridge.serve("/rosapi/message_details") {
                val details = """{"typedefs": [{"type": "my_msgs/Depth", "fieldnames": ["header", "meters"]}]}"""
                true to Json.parseToJsonElement(details)
            }
            open("percepts:\n  - /depth my_msgs/Depth -> depth(meters)").close()
            shouldThrow<PortFaultException> { open("percepts:\n  - /depth my_msgs/Depth -> depth(metres)") }.message shouldContain
                "robot.ros.yaml:2:35: my_msgs/Depth has no field metres; it has header, meters"
        }
    }

    test("a closed link leaves no connection") {
        open().close()
        eventually(LIMIT) { bridge.clients shouldBe 0 }
        bridge.heard("subscribe").filter { it.text("topic") == "/bumper" }.shouldBeEmpty()
        (bridge.subscribed() - RESULT).shouldBeEmpty()
    }
})
