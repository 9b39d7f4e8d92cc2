package argo.ros

import argo.links.BoardMessage
import argo.links.Wish
import argo.ros.bridge.BridgeSocket
import argo.ros.bridge.SilentTopics
import argo.ros.bridge.part
import argo.ros.bridge.text
import argo.ros.mapping.mappingOf
import io.kotest.assertions.nondeterministic.eventually
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.collections.shouldHaveSize
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import javino.ActionFailedException
import javino.ActionRefusedException
import javino.LineClock
import javino.PortFaultException
import javino.link.SendOptions
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import java.net.URI
import java.util.concurrent.ExecutionException
import java.util.concurrent.TimeUnit
import java.util.concurrent.atomic.AtomicLong

/** The types of a robot and their fields, as `rosapi` of ROS 1 describes them. */
private val TYPES = mapOf(
    "std_msgs/String" to "data string", "std_msgs/Bool" to "data bool", "std_msgs/UInt8" to "data uint8", "std_msgs/Int64" to "data int64",
    "std_msgs/Float32" to "data float32", "std_msgs/Empty" to "",
    "geometry_msgs/Twist" to "linear geometry_msgs/Vector3, angular geometry_msgs/Vector3",
    "geometry_msgs/Vector3" to "x float64, y float64",
    "geometry_msgs/Pose" to "position geometry_msgs/Vector3, orientation geometry_msgs/Quaternion",
    "geometry_msgs/Quaternion" to "x float64, y float64, z float64, w float64",
    "geometry_msgs/PoseStamped" to "header std_msgs/Header, pose geometry_msgs/Pose",
    "my_msgs/Arm" to "joints float64[3], names string[], raw uint8[], at time, on bool, poses geometry_msgs/Pose[]",
    "my_msgs/Mode" to "mode uint8",
    "sensor_msgs/Range" to "header std_msgs/Header, min_range float32, max_range float32, range float32",
    "std_msgs/Header" to "frame_id string", "std_msgs/Float64" to "data float64",
    "my_msgs/DockGoal" to "station string", "std_srvs/SetBool" to "data bool", "time" to "secs int32, nsecs int32",
)

private fun definition(type: String): String {
    val fields = TYPES.getValue(type).split(", ").filter { it.isNotEmpty() }.map { it.split(' ') }
    val lengths = fields.map { (_, kind) -> if ('[' !in kind) -1 else kind.substringAfter('[').removeSuffix("]").ifEmpty { "0" }.toInt() }
    fun list(words: List<String>) = words.joinToString(",", "[", "]") { "\"$it\"" }
    return """{"type": "$type", "fieldnames": ${list(fields.map { it[0] })},
        "fieldtypes": ${list(fields.map { it[1].substringBefore('[') })}, "fieldarraylen": $lengths,
        "constnames": ["MANUAL", "AUTO"], "constvalues": ["1", "2"]}"""
}

private fun details(type: String): String {
    val all = generateSequence(listOf(type)) { before ->
        before.flatMap { TYPES.getValue(it).split(Regex("[ ,\\[]")) }.filter { it in TYPES }.ifEmpty { null }
    }.flatten().distinct()
    return all.joinToString(",", """{"typedefs": [""", "]}", transform = ::definition)
}

internal fun TestBridge.describeTypes() {
    val service: Service = { arguments ->
        val type = arguments.text("type").orEmpty()
        if (type in TYPES) true to Json.parseToJsonElement(details(type))
        else false to JsonPrimitive("service [/rosapi/message_details] responded with an error: b'error processing request: " +
            "Unable to load the manifest for package gripper_msgs. Caused by: gripper_msgs'")
    }
    serve("/rosapi/message_details", service)
    serve("/rosapi/service_request_details", service)
}

private val COMMANDS = """
    commands:
      - say(T) -> /say std_msgs/String
      - on(B) -> /on std_msgs/Bool
      - level(N) -> /level std_msgs/UInt8(data = N)
      - id(N) -> /id std_msgs/Int64
      - part(N) -> /part std_msgs/Float32
      - arm(J) -> /arm my_msgs/Arm(joints = J)
      - names(L) -> /arm my_msgs/Arm(names = L)
      - raw(L) -> /arm my_msgs/Arm(raw = L)
      - at(T) -> /arm my_msgs/Arm(at = T)
      - later(S) -> /arm my_msgs/Arm(at.secs = S)
      - lamp(B) -> service /lamp std_srvs/SetBool(data = B)
      - dock(S) -> action /dock my_msgs/DockAction(station = S)
      - grip -> /grip gripper_msgs/Grip(force = 1)
""".trimIndent()

class RosChecksSpec : FunSpec({
    lateinit var bridge: TestBridge
    lateinit var log: LoggedWarnings
    val ahead = AtomicLong()
    beforeTest {
        bridge = TestBridge()
        log = LoggedWarnings()
        ahead.set(0)
    }
    afterTest {
        bridge.close()
        log.close()
    }

    fun describe() = bridge.describeTypes()

    fun open(mapping: String): RosLink {
        val clock = LineClock { System.nanoTime() + ahead.get() }
        return RosLink.open("robot", URI("ws://127.0.0.1:${bridge.number}/"), mappingOf(mapping, "robot.ros.yaml"), true, clock)
    }

    fun RosLink.outcomeOf(command: String): String = try {
        send(command, SendOptions(false, 5_000)).outcome.get(20, TimeUnit.SECONDS)
        "done"
    } catch (failed: ExecutionException) {
        "${failed.cause!!.javaClass.simpleName}: ${failed.cause!!.message}"
    }

    fun published() = bridge.heard("publish").map { "${it.part("msg")}" }

    suspend fun RosLink.awaitWarning(text: String) = eventually(LIMIT) {
        listen(20)
        log.messages.map { it.removePrefix("port robot: ") } shouldContain text
    }

    context("a command that ROS would drop is refused with the name of its field:") {
        listOf(
            "say(17)" to "say(17) does not fit the robot: data of std_msgs/String is a string: 17 is a number; write \"17\"",
            "on(\"true\")" to "data of std_msgs/Bool is a bool: \"true\" is neither true nor false",
            "on(1)" to "data of std_msgs/Bool is a bool: 1 is neither true nor false",
            "level(256)" to "data of std_msgs/UInt8 is a uint8: 256 is not within 0 to 255",
            "level(1.5)" to "data of std_msgs/UInt8 is a uint8: 1.5 is no whole number; the mapping may round it",
            "level(fast)" to "data of std_msgs/UInt8 is a uint8: \"fast\" is no number",
            "id(1e19)" to "data of std_msgs/Int64 is a int64: 10000000000000000000 is not within -9223372036854775808 to",
            "part(1e39)" to "data of std_msgs/Float32 is a float32: 1.0E39 is beyond its range",
            "arm([1,2])" to "joints of my_msgs/Arm is a float64[3]: the list has 2 items",
            "arm([1,2,b])" to "joints of my_msgs/Arm is a float64[3]: \"b\" is no number",
            "arm(1)" to "joints of my_msgs/Arm is a float64[3]: 1 is no list",
            "names([[a]])" to "names of my_msgs/Arm is a string[]: it takes no list",
            "raw([1,256])" to "raw of my_msgs/Arm is a uint8[]: 256 is not within 0 to 255",
            "at(5)" to "at of my_msgs/Arm is a time: 5 is no message; give its fields a value, secs, nsecs",
            "later(1.5)" to "at.secs of my_msgs/Arm is a int32: 1.5 is no whole number",
            "lamp(on)" to "data of std_srvs/SetBool is a bool: \"on\" is neither true nor false",
            "dock(3)" to "station of my_msgs/DockGoal is a string: 3 is a number",
            "grip" to "the bridge does not know the type gripper_msgs/Grip",
            "~say(a)" to "the robot has no command ~say(a)",
        ).forEach { (command, why) ->
            test(command) {
                describe()
                open(COMMANDS).use { it.outcomeOf(command) }.let { outcome ->
                    outcome shouldContain ActionRefusedException::class.simpleName!!
                    outcome shouldContain why
                }
                (published() + bridge.heard("call_service").filter { it.text("service") == "/lamp" }).shouldBeEmpty()
            }
        }
    }

    test("values go out as their fields take them") {
        describe()
        open(COMMANDS).use { link ->
            listOf(
                "say(true)", "say(word)", "say(\"☃ \\u005Cd\")", "on(true)", "level(255)", "id(9007199254740993)", "id(-9e18)", "part(1)",
                "arm([1,2.5,-3])", "names([a,\"b\",true])", "raw([0,255])", "raw(\"AQID\")", "at(now)", "later(7)",
            ).forEach { link.outcomeOf(it) shouldBe "done" }
        }
        eventually(LIMIT) {
            published() shouldContainExactly listOf(
                """{"data":"true"}""", """{"data":"word"}""", """{"data":"☃ \\d"}""", """{"data":true}""", """{"data":255}""",
                """{"data":9007199254740992}""", """{"data":-9000000000000000000}""", """{"data":1}""", """{"joints":[1,2.5,-3]}""",
                """{"names":["a","b","true"]}""", """{"raw":[0,255]}""", """{"raw":"AQID"}""", """{"at":"now"}""", """{"at":{"secs":7}}""",
            )
        }
    }

    test("annotations of a command are left out, which is reported once for each command") {
        open(COMMANDS).use { link ->
            listOf("say(a)[fast]", "say(b)[source(self),slow]", "level(1)[fast]").forEach { link.outcomeOf(it) shouldBe "done" }
        }
        log.messages.filter { "annotations" in it } shouldContainExactly listOf("say/1", "level/1").map {
            "port robot: the annotations of the command $it are left out, since no message of ROS has any"
        }
        eventually(LIMIT) { published() shouldContainExactly listOf("""{"data":"a"}""", """{"data":"b"}""", """{"data":1}""") }
    }

    test("fields and constants of commands, and nested fields of percepts, are refused with line and column when the port is opened") {
        describe()
        fun refusal(mapping: String) = shouldThrow<PortFaultException> { open(mapping) }.message.orEmpty()
        refusal("commands:\n  - go(V) -> /cmd_vel geometry_msgs/Twist(linear.q = V)") shouldContain
            "robot.ros.yaml:2:43: geometry_msgs/Vector3 has no field q; it has x, y"
        refusal("commands:\n  - move(V) -> /cmd_vel geometry_msgs/Twist(linear = V)") shouldContain
            "2:45: linear of geometry_msgs/Twist is a geometry_msgs/Vector3, and no argument is a message; give its fields a value, x, y"
        refusal("percepts:\n  - /a my_msgs/Arm -> joint(joints(0))") shouldContain "2:29: joints is a field of my_msgs/Arm, and no literal"
        refusal("commands:\n  - go -> /level std_msgs/UInt8(data = -1)") shouldContain
            "robot.ros.yaml:2:33: data of std_msgs/UInt8 is a uint8: -1 is not within 0 to 255"
        refusal("commands:\n  - go -> /level std_msgs/Empty(data = 1)") shouldContain "std_msgs/Empty has no field data"
        refusal("commands:\n  - go -> service /lamp std_srvs/SetBool(on = 'true')") shouldContain
            "std_srvs/SetBool has no field on; it has data"
        refusal("commands:\n  - go -> action /dock my_msgs/DockAction(home = 'true')") shouldContain "my_msgs/DockGoal has no field home"
        refusal("percepts:\n  - /p geometry_msgs/Pose -> at(position.z)") shouldContain
            "robot.ros.yaml:2:33: geometry_msgs/Vector3 has no field z; it has x, y"
        refusal("percepts:\n  - /a my_msgs/Arm -> at(poses.position)") shouldContain
            "poses of my_msgs/Arm is a list; take an item of it, as poses[0].position"
        refusal("percepts:\n  - /a my_msgs/Arm -> at(on[0])") shouldContain "on of my_msgs/Arm is a bool, and no list"
        refusal("percepts:\n  - /a my_msgs/Arm -> at(on.x)") shouldContain "on of my_msgs/Arm is a bool, and has no field x"
        refusal("percepts:\n  - /a my_msgs/Arm -> at(joints[3])") shouldContain "joints of my_msgs/Arm has 3 items, and no [3]"
        refusal("percepts:\n  - /a my_msgs/Arm -> at(joints[0:4])") shouldContain "joints of my_msgs/Arm has 3 items, and no [0:4]"
        refusal("percepts:\n  - /a my_msgs/Arm -> at(max(poses[:].positoin.x))") shouldContain "geometry_msgs/Pose has no field positoin"
        refusal("percepts:\n  - /m my_msgs/Mode -> auto if mode == ATUO") shouldContain
            "2:40: my_msgs/Mode has no field ATUO; it has mode, MANUAL, AUTO"
        open("percepts:\n  - /a my_msgs/Arm -> at(poses[0].position.x, joints[-1], at.secs, max(poses[:].position.x))").close()
    }

    test("fields of poses that a command leaves empty, and robots need, are told") {
        describe()
        fun told(fields: String) = LoggedWarnings().use { log ->
            open("commands:\n  - goto(X) -> /goal geometry_msgs/PoseStamped($fields)").close()
            log.messages.map { it.substringAfter("line 2: ") }
        }
        told("pose.position.x = X") shouldBe listOf(
            "header.frame_id of geometry_msgs/PoseStamped is left empty, so that its frame is not known; write header.frame_id = 'map'",
            "pose.orientation of geometry_msgs/PoseStamped is left as a quaternion of zeros, which is no rotation; for none, write " +
                "pose.orientation.w = 1",
        )
        told("pose.position.x = X, header.frame_id = 'map', pose.orientation.w = 1") shouldBe emptyList()
        open("commands:\n  - go(X) -> /cmd_vel geometry_msgs/Twist(linear.x = X)").close()
        log.messages.filter { "is left" in it && "Twist" in it } shouldBe emptyList()
    }

    test("constants of a type are known by its description") {
        describe()
        open("percepts:\n  - /mode my_msgs/Mode -> auto if mode == AUTO").use { link ->
            link.wants(Wish(true, 50, null))
            eventually(LIMIT) { bridge.subscribed().keys shouldBe setOf("/mode") }
            bridge.publish("/mode", """{"mode": 2}""")
            link.await { it.text == "auto;" }
        }
    }

    test("bytes, which bridges write in base64, are a list of numbers, up to 1,000") {
        describe()
        open("percepts:\n  - /arm my_msgs/Arm -> raw(raw, raw[1], len(raw))\n  - /arm my_msgs/Arm -> on(on)").use { link ->
            link.wants(Wish(true, 50, null))
            eventually(LIMIT) { bridge.subscribed().keys shouldBe setOf("/arm") }
            bridge.publish("/arm", """{"raw": "AQL/", "on": true}""")
            link.await { it.text == "raw([1,2,255],2,3);on(true);" }
            bridge.publish("/arm", """{"raw": "${"A".repeat(1_336)}", "on": true}""")
            link.await { it.text == "on(true);" }
            log.messages.last() shouldContain "its bytes are no list: they are more than 1000, or not in base64"
        }
    }

    test("types of ROS 2 are understood as its rosapi describes them") {
        val point = """{"type": "geometry_msgs/Point", "fieldnames": ["_x"], "fieldtypes": ["double"], "fieldarraylen": [-1]}"""
        val path = """{"type": "my_msgs/Path", "fieldnames": ["_points", "_name", "_ids"],
            "fieldtypes": ["geometry_msgs/Point", "string<10>", "uint8, 4"], "fieldarraylen": [0, -1, 0]}"""
        bridge.serve("/rosapi/message_details") {
            val known = if ("Path" in it.text("type").orEmpty()) "$path, $point" else ""
            true to Json.parseToJsonElement("""{"typedefs": [$known]}""")
        }
        val commands = "commands:\n  - name(N) -> /path my_msgs/msg/Path(name = N)\n  - grip -> /grip gripper_msgs/msg/Grip(force = 1)"
        open("percepts:\n  - /path my_msgs/msg/Path -> path(points[0].x, len(ids))\n$commands").use { link ->
            link.outcomeOf("name(5)") shouldContain "name of my_msgs/msg/Path is a string: 5 is a number"
            link.outcomeOf("name(five)") shouldBe "done"
            link.outcomeOf("grip") shouldContain "the bridge does not know the type gripper_msgs/msg/Grip"
        }
        shouldThrow<PortFaultException> { open("percepts:\n  - /path my_msgs/msg/Path -> path(points[0].z)") }.message shouldContain
            "geometry_msgs/Point has no field z; it has x"
    }

    test("where rosapi does not run, commands go out unchecked") {
        open(COMMANDS).use { it.outcomeOf("say(17)") shouldBe "done" }
        eventually(LIMIT) { published() shouldBe listOf("""{"data":17}""") }
    }

    test("a topic that comes later with another type, or goes away, is reported when it has said nothing for five seconds") {
        var type = ""
        var publishers = emptyList<String>()
        bridge.serve("/rosapi/topic_type") { true to JsonObject(mapOf("type" to JsonPrimitive(type))) }
        bridge.serve("/rosapi/publishers") { true to JsonObject(mapOf("publishers" to JsonArray(publishers.map(::JsonPrimitive)))) }
        open("percepts:\n  - /late std_msgs/Bool").use { link ->
            link.wants(Wish(true, 50, null))
            ahead.addAndGet(2 * SilentTopics.LIMIT_NANOS)
            link.awaitWarning("no node publishes /late")
            type = "std_msgs/String"
            publishers = listOf("/node")
            ahead.addAndGet(2 * SilentTopics.LIMIT_NANOS)
            link.awaitWarning(
                "/late is of type std_msgs/String on the robot, and the mapping says std_msgs/Bool: its messages do not pass the bridge",
            )
        }
    }

    test("a command to a topic that comes later with another type, or that nobody listens to, is reported") {
        var type = "std_msgs/String"
        bridge.serve("/rosapi/topic_type") { true to JsonObject(mapOf("type" to JsonPrimitive(type))) }
        bridge.serve("/rosapi/subscribers") { true to JsonObject(mapOf("subscribers" to JsonArray(emptyList()))) }
        open("commands:\n  - say(T) -> /say std_msgs/String").use { link ->
            link.outcomeOf("say(a)") shouldBe "done"
            link.awaitWarning("no node subscribes to /say, so that \"say\" does nothing")
            type = "std_msgs/Bool"
            link.outcomeOf("say(b)") shouldBe "done" // no second question within five seconds
            ahead.addAndGet(2 * SilentTopics.LIMIT_NANOS)
            link.outcomeOf("say(c)") shouldBe "done"
            link.awaitWarning(
                "/say is of type std_msgs/Bool on the robot, and the mapping says std_msgs/String: its messages do not pass the bridge",
            )
        }
        bridge.heard("call_service").filter { it.text("service") == "/rosapi/subscribers" } shouldHaveSize 2
    }

    test("a goal for an action that no server offers fails at once, and no later server begins it") {
        var servers = emptyList<String>()
        bridge.serve("/rosapi/topic_type") { true to JsonObject(mapOf("type" to JsonPrimitive("my_msgs/DockActionGoal"))) }
        bridge.serve("/rosapi/action_servers") { true to JsonObject(mapOf("action_servers" to JsonArray(servers.map(::JsonPrimitive)))) }
        open("commands:\n  - dock(S) -> action /dock my_msgs/DockAction(station = S)").use { link ->
            link.awaitWarning("rosapi shows no action server /dock yet")
            link.outcomeOf("dock(home)").let {
                it shouldContain ActionFailedException::class.simpleName!!
                it shouldContain "rosapi shows no action server /dock"
            }
            eventually(LIMIT) { // an unsent goal needs no cancellation
                val topics = bridge.heard("publish").map { it.text("topic") }
                topics.count { it == "/dock/cancel" } shouldBe topics.count { it == "/dock/goal" }
            }
            servers = listOf("/dock")
            bridge.onPublish = { topic, message ->
                val id = message.part("goal_id")?.text("id")
                val result = """{"status": {"goal_id": {"id": "$id"}, "status": 3, "text": ""}}"""
                if (topic == "/dock/goal") bridge.publish("/dock/result", result)
            }
            link.outcomeOf("dock(home)") shouldBe "done"
        }
    }

    test("a percept that is left out is reported once, with the reason") {
        open("percepts:\n  - /range sensor_msgs/Range -> distance(range)").use { link ->
            link.wants(Wish(true, 50, null))
            eventually(LIMIT) { bridge.subscribed().keys shouldBe setOf("/range") }
            repeat(3) { bridge.publish("/range", """{"range": null}""") }
            bridge.say("""{"op": "png"}""")
            link.awaitWarning("the bridge sends the operation png, which is not read")
            log.messages.filter { "range: it is null" in it } shouldHaveSize 1
        }
    }

    test("of ever new things to report there are a hundred lines of log, and one that says so") {
        open("percepts:\n  - /photo std_msgs/String").use { link ->
            repeat(110) { bridge.say("""{"op": "new$it"}""") }
            link.awaitWarning("100 lines have been reported; the rest is left out")
            log.messages.filter { "which is not read" in it } shouldHaveSize 100
        }
    }

    test("messages that are not read are reported: long ones, binary ones, other operations") {
        open("percepts:\n  - /photo std_msgs/String").use { link ->
            link.wants(Wish(true, 50, null))
            eventually(LIMIT) { bridge.subscribed().keys shouldBe setOf("/photo") }
            bridge.publish("/photo", """{"data": "${"x".repeat(BridgeSocket.MAX_LENGTH)}"}""")
            val beginning = """{"op":"publish","topic":"/photo","msg":{"data": "xxxxxxxxxxxxxxxxxxxxxxxxxxxx""".take(60)
            link.awaitWarning("the bridge sends a message of more than 4194304 characters, which begins $beginning; it is not read")
            bridge.sayBytes(byteArrayOf(1))
            link.awaitWarning("the bridge sends a binary message, though ARGO asks for none; it is not read")
            bridge.say("""{"op": "png", "data": ""}""")
            link.awaitWarning("the bridge sends the operation png, which is not read")
        }
    }
})

private fun RosLink.await(isWanted: (BoardMessage) -> Boolean) {
    while (true) if (listen(20_000)?.let(isWanted) == true) return
}
