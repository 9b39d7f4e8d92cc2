package argo.ros

import argo.links.Wish
import argo.ros.bridge.SilentTopics
import argo.ros.bridge.text
import argo.ros.mapping.MappingException
import argo.ros.mapping.mappingOf
import io.kotest.assertions.nondeterministic.eventually
import io.kotest.core.spec.style.FunSpec
import io.kotest.inspectors.forAtLeastOne
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.string.shouldContain
import javino.LineClock
import javino.PortException
import javino.PortTimeoutException
import javino.link.SendOptions
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import java.net.URI
import java.util.concurrent.ExecutionException
import java.util.concurrent.TimeUnit
import java.util.concurrent.atomic.AtomicLong

/** The robot's topics, each with its type and a message. */
private val TOPICS = mapOf(
    "/sonar" to ("sensor_msgs/Range" to """{"header": {"frame_id": "front"}, "min_range": 0.1, "max_range": 4, "range": 0.5}"""),
    "/said" to ("std_msgs/String" to """{"data": "ready"}"""),
    "/pose" to ("geometry_msgs/Pose" to """{"position": {"x": 1, "y": 2}}"""),
    "/mode" to ("my_msgs/Mode" to """{"mode": 2}"""),
    "/arm" to ("my_msgs/Arm" to """{"joints": [1, 2, 3], "names": ["a"], "raw": "AQI=", "on": true, "poses": []}"""),
    "/tf" to (
        "tf2_msgs/TFMessage" to """{"transforms": [{"header": {"frame_id": "map"}, "child_frame_id": "base", "transform":
        {"translation": {"x": 1, "y": 0, "z": 0}, "rotation": {"x": 0, "y": 0, "z": 0, "w": 1}}}]}"""
        ),
)

/** The topics to which the robot's nodes subscribe, its services and its actions, each with its type. */
private val TAKEN = mapOf("/say" to "std_msgs/String", "/cmd_vel" to "geometry_msgs/Twist", "/dock/goal" to "my_msgs/DockActionGoal")
private val SERVICES = mapOf("/lamp" to "std_srvs/SetBool")

class MistakesSpec : FunSpec({
    val ahead = AtomicLong()

    fun TestBridge.beTheRobot() {
        fun word(name: String, value: String) = true to JsonObject(mapOf(name to JsonPrimitive(value)))
        fun list(name: String, values: List<String>) = true to JsonObject(mapOf(name to JsonArray(values.map(::JsonPrimitive))))
        describeTypes()
        serve("/rosapi/service_response_details") {
            val type = """{"typedefs": [{"type": "std_srvs/SetBoolResponse", "fieldnames": ["success", "message"],
                "fieldtypes": ["bool", "string"], "fieldarraylen": [-1, -1]}]}"""
            true to Json.parseToJsonElement(type)
        }
        fun advertised(topic: String?) = heard("advertise").find { it.text("topic") == topic }?.text("type")
        serve("/rosapi/topic_type") {
            val topic = it.text("topic")
            word("type", (TOPICS[topic]?.first ?: TAKEN[topic] ?: advertised(topic)).orEmpty())
        }
        serve("/rosapi/publishers") { list("publishers", if (it.text("topic") in TOPICS) listOf("/robot") else emptyList()) }
        serve("/rosapi/subscribers") { list("subscribers", if (it.text("topic") in TAKEN) listOf("/robot") else emptyList()) }
        serve("/rosapi/service_type") { word("type", SERVICES[it.text("service")].orEmpty()) }
        serve("/rosapi/action_servers") { list("action_servers", listOf("/dock")) }
        serve("/lamp") { true to JsonObject(mapOf("success" to JsonPrimitive(true), "message" to JsonPrimitive(""))) }
    }

    suspend fun told(line: String): List<String> = TestBridge().use { bridge ->
        bridge.beTheRobot()
        val (section, rule) = line.split(": ", limit = 2)
        LoggedWarnings().use { log ->
            try {
                val mapping = mappingOf(rule.split(" & ").joinToString("\n", "$section:\n") { "  - $it" }, "robot.ros.yaml")
                val clock = LineClock { System.nanoTime() + ahead.get() }
                RosLink.open("robot", URI("ws://127.0.0.1:${bridge.number}/"), mapping, true, clock).use { link ->
                    link.wants(Wish(true, 10, null))
                    val failures = mapping.commands.mapNotNull { command ->
                        val arguments = command.parameters.joinToString(",", "(", ")") { "true" }.takeIf { it != "()" }.orEmpty()
                        failureOf(link, command.name + arguments)
                    }
                    val topics = (mapping.percepts - mapping.poses.toSet()).map { it.topic } + mapping.poses.map { "/tf" }
                    repeat(ROUNDS) { round ->
                        if (round == ROUNDS / 2) ahead.addAndGet(2 * SilentTopics.LIMIT_NANOS)
                        topics.forEach { bridge.publish(it, TOPICS[it]?.second ?: return@forEach) }
                        try {
                            link.listen(LISTENING_MS)
                        } catch (_: PortTimeoutException) {
                            // a slow computer
                        }
                    }
                    log.messages + failures
                }
            } catch (refused: MappingException) {
                listOf(refused.message.orEmpty())
            } catch (refused: PortException) {
                listOf(refused.message.orEmpty())
            }
        }
    }

    test("what fits the robot is told nothing of") {
        listOf(
            "percepts: /sonar sensor_msgs/Range -> dist(f, range)", "percepts: /said std_msgs/String -> ready if data == 'ready'",
            "percepts: tf map base -> pose(x, y, yaw)", "percepts: /arm my_msgs/Arm -> joint(joints[-1]) if on",
            "commands: say(T) -> /say std_msgs/String", "commands: lamp(B) -> service /lamp std_srvs/SetBool(data = B) answer success",
        ).forEach { eventually(LIMIT) { told(it).shouldBeEmpty() } }
    }

    context("a mistake is told:") {
        val lines = checkNotNull(MistakesSpec::class.java.getResource("/mistakes.txt")).readText().lines()
        lines.filter { it.isNotBlank() && !it.startsWith("#") }.map { it.split(" => ") }.forEach { (line, words) ->
            test(line) { eventually(LIMIT) { told(line).forAtLeastOne { it shouldContain words } } }
        }
    }
})

private fun failureOf(link: RosLink, command: String): String? = try {
    link.send(command, SendOptions(false, 2_000)).outcome.get(20, TimeUnit.SECONDS)
    null
} catch (failed: ExecutionException) {
    failed.cause?.message
}

private const val ROUNDS = 20
private const val LISTENING_MS = 10
